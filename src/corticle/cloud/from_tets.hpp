// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/remesh.hpp"
#include "corticle/mesh/cloud.hpp"
#include "corticle/mesh/tet_mesh.hpp"

#include <optional>
#include <string>

namespace corticle::cloud
{

/// How nodes are chosen when there are more than particles asked for.
enum class Thinning
{
    random, ///< as in the thesis, section 2.4.1
    uniform ///< as far from each other as the mesh permits
};

struct TetCloudOptions
{
    std::optional<std::int64_t> particles; ///< none: every node is one
    Thinning thinning = Thinning::uniform;
    std::uint64_t seed = 1;
};

struct TetCloud
{
    Cloud cloud;
    std::vector<Tet> tets;             ///< with particles for corners; empty where nodes were left out
    TriangleMesh surface;              ///< reference surface; its vertices are cloud.surface_particles
    geometry::RemeshReport remesh;     ///< zero when the boundary of the tets serves as it is
    std::vector<std::string> warnings; ///< one line each
};

/// Particles on the nodes of a tet mesh that require_valid_tets accepts.
/// All nodes: volumes are a quarter of every adjacent tet, the surface is the boundary of the tets.
/// Thinned to `particles`: the boundary is remeshed to the new spacing, with a particle on every vertex; the others are
/// nodes inside it, thinned; volumes are those of the Voronoi cells cut at the surface.
/// Either way the volumes sum to the volume enclosed by the surface, and the result does not depend on the number of
/// threads.
/// @throws InputError when there are fewer nodes than particles asked for, or the surface cannot be remeshed
TetCloud cloud_from_tets(const TetMesh& mesh, const TetCloudOptions& options = {});

} // namespace corticle::cloud
