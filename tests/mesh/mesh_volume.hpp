// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <numeric>

namespace corticle
{

/// Sum of the signed volumes [mm³].
inline double mesh_volume(const TetMesh& mesh)
{
    const std::vector<double> volumes = tet_volumes(mesh);
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

} // namespace corticle
