// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/fem/elements.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/cloud.hpp"

#include <optional>

namespace corticle
{

/// The tets of a body, and the tissue at their centroids.
struct ElementBody
{
    TetElements elements;
    Tissue tissue;
};

/// Constant after preparation: nodes, surface, tissue at the material points, and what the method needs: pairs of
/// particles or elements.
struct Body
{
    Cloud cloud;                    ///< the nodes
    TriangleMesh surface;           ///< reference surface; its vertices are cloud.surface_particles
    Tissue tissue;                  ///< at the nodes
    Particles particles;            ///< pairs; empty with finite elements
    std::optional<ElementBody> fem; ///< of method "fem"
};

/// theta at the present time of growth, at the nodes and in the elements.
void set_layer(Body& body, double t);

} // namespace corticle
