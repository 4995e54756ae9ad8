// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"

namespace corticle::prepare
{

/// Vertices within a cloud of nodes, each tied to the four nodes near it in whose tetrahedron it lies deepest: the
/// weights are its barycentric coordinates there, so where the nodes move linearly so does the surface.
boundary::TiedSurface tied_surface(const TriangleMesh& surface, std::span<const Vec3> nodes, double spacing);

/// Walls of the labelled ventricles where a pressure acts on them; else without triangles.
boundary::TiedSurface ventricle_surface(const PreparationOptions& options, const model::Model& model);

} // namespace corticle::prepare
