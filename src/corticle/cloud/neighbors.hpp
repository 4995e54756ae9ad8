// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/cloud.hpp"
#include "corticle/mesh/neighbor_list.hpp"

namespace corticle::cloud
{

struct VisibilityReport
{
    std::int64_t dropped_pairs = 0; ///< pairs within the support whose segment leaves the body
};

/// All pairs closer than `support` [mm] that see each other: a pair whose segment leaves the body (the two banks of
/// a fissure) is dropped, in both directions. Chords that graze a gently concave surface are kept: the ends that lie
/// on or near the surface are moved inward along the normal by half a spacing for the test.
/// The support of a pair is the mean of those about its ends. @param support  at the surface [mm]
Neighbors find_neighbors(const Cloud& cloud, const geometry::SurfaceTree& surface, double support,
                         VisibilityReport* report = nullptr);

/// All pairs closer than `support`, whatever lies between them.
Neighbors find_pairs_within(std::span<const Vec3> positions, double support);

/// The same with a support about each particle; that of a pair is the mean.
Neighbors find_pairs_within(std::span<const Vec3> positions, std::span<const double> supports);

} // namespace corticle::cloud
