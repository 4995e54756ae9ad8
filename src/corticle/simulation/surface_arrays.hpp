// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/fold_measures.hpp"
#include "corticle/simulation/simulation.hpp"

namespace corticle
{

/// What is measured at every surface vertex at an output time.
struct SurfaceArrays
{
    FoldFields folds;
    std::vector<double> thickness; ///< of the cortex [mm]
};

SurfaceArrays surface_arrays(const Simulation& simulation, std::span<const Mat3> F);

/// Folds are measured about the mid-plane of the reference surface.
FoldOptions fold_options(const Body& body);

/// Folds as a displacement of the reference surface.
struct ReferenceFolds
{
    double wavelength_mm = 0.0; ///< dominant wavelength of the normal displacement, in the reference frame; 0: no folds
    double degree = 0.0;        ///< spherical harmonic of 1 to 30 with the most power of the radial displacement; 0: no
                                ///< folds, or the reference surface is no sphere
};

ReferenceFolds reference_folds(const Simulation& simulation);

} // namespace corticle
