// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/boundary/tied_surface.hpp"
#include "corticle/mechanics/fem/elements.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mechanics/tracts/tracts.hpp"
#include "corticle/mesh/cloud.hpp"

#include <optional>

namespace corticle::model
{

/// The tets of a body, and the tissue at their centroids.
struct ElementModel
{
    fem::TetElements elements;
    material::TissueFields tissue;
};

/// A body as it is before it grows, constant once prepared: nodes, surface, tissue at the material points, and what the
/// method needs: pairs of particles or elements. Simulations share it.
struct Model
{
    Cloud cloud;                      ///< the nodes
    TriangleMesh surface;             ///< reference surface; its vertices are cloud.surface_particles
    TriangleMesh inner_surface;       ///< of a labelled cortex, towards other tissue, in the reference frame; or empty
    material::TissueFields tissue;    ///< at the nodes
    tlsph::Particles particles;       ///< pairs; empty with finite elements
    std::optional<ElementModel> fem;  ///< of method "fem"
    TriangleMesh skull;               ///< at the start; without triangles: none
    boundary::TiedSurface ventricles; ///< walls of the ventricles, where a fluid presses on them
    tracts::Tracts tracts;            ///< of axons; or none
};

} // namespace corticle::model
