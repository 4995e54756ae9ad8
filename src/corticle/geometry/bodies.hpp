// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <optional>

namespace corticle::geometry
{

/// What a surface encloses, its small holes filled.
struct SurfaceBodies
{
    std::vector<TriangleMesh>
        bodies;                ///< closed, outward, largest first; none lies inside another or is below 1 % of it
    std::int64_t separate = 0; ///< number, those that overlap counted as one

    /// Where two that do not overlap come closest.
    struct Gap
    {
        double width_mm = 0.0;
        Vec3 place;
    };
    std::optional<Gap> gap; ///< of separate ones
};

/// The bodies among the pieces of a surface: pieces that are closed but for holes that are small against them. What is
/// wide open belongs to none.
SurfaceBodies find_bodies(const TriangleMesh& surface);

/// Number of handles of a closed surface in one piece, from its Euler characteristic.
std::int64_t genus_of(const TriangleMesh& surface);

} // namespace corticle::geometry
