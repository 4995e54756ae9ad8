// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/fold_measures.hpp"
#include "corticle/model/output_view.hpp"

namespace corticle::metrics
{

/// What is measured at every surface vertex at an output time, in mm at its week.
struct SurfaceArrays
{
    FoldFields folds;
    std::vector<double> thickness; ///< of the cortex [mm]
    std::vector<Vec3> boundary;    ///< of cortex and white matter: the point below each vertex [mm]
    double inner_area = 0.0;       ///< of a labelled cortex that of its own inner surface, else of the boundary [mm²]
};

SurfaceArrays surface_arrays(const model::OutputView& view);

/// Folds are measured about the mid-plane of the reference surface.
FoldOptions fold_options(const model::OutputView& view);

/// Folds as a displacement of the reference surface, in mm of the body as it was given.
struct ReferenceFolds
{
    double wavelength_mm = 0.0; ///< dominant wavelength of the normal displacement, in the reference frame; 0: no folds
    double degree = 0.0;        ///< spherical harmonic of 1 to 30 with the most power of the radial displacement; 0: no
                                ///< folds, or the reference surface is not a sphere
};

ReferenceFolds reference_folds(const model::OutputView& view);

} // namespace corticle::metrics
