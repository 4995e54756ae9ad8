// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// Vertices that are maxima of a function on a surface and stand out by at least `prominence`, highest first.
///
/// Watershed with merging, as sulcal pits are found (Im et al. 2010, Cerebral Cortex 20; ridge height only): vertices
/// are flooded from the highest; where two basins meet, the lower one is merged when its maximum stands less than the
/// prominence above the meeting point. The highest of each connected part counts when it stands that much above the
/// lowest vertex of the part.
/// @param values      one per vertex
/// @param prominence  in the unit of the values, positive
std::vector<std::int32_t> prominent_maxima(std::span<const double> values, std::span<const Triangle> triangles,
                                           double prominence);

/// Sulcal pits and gyral crowns of a surface: vertices.
struct DepthExtrema
{
    std::vector<std::int32_t> pits;   ///< deepest points of sulcal basins, deepest first
    std::vector<std::int32_t> crowns; ///< least deep points of gyri, least deep first
};

/// Local extrema of the sulcal depth.
/// @param ridge_height  [mm] least height of the ridge between two pits (of the saddle below two crowns); 2.5 for adult
///                      brains (Im et al. 2010)
DepthExtrema depth_extrema(std::span<const double> sulcal_depth, std::span<const Triangle> triangles,
                           double ridge_height);

} // namespace corticle::metrics
