// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/fixed_array.hpp"
#include "corticle/base/large_pages.hpp"
#include "corticle/base/wide_group.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"
#include "corticle/mesh/cloud.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

// Gradients of second order near the surface, where supports are one-sided. See docs/theory/tlsph.md.

namespace corticle::tlsph
{

/// The quadratic fits of eight consecutive particles, before they move; symbols as in Fit. Where the fit of one of them
/// is linear, this is that.
struct alignas(64) QuadraticFits
{
    FixedArray<WideLanes, 45> inverse;
    FixedArray<WideLanes, 6> second_moment; ///< sum_j w_ij (X_ij)_b (X_ij)_c for bc = xx, xy, xz, yy, yz, zz
    WideVec3 at;                            ///< centroid of the cell, from the particle
};

/// Where gradients are enriched.
struct EnrichedGradients
{
    enum class Reach : std::uint8_t
    {
        none,      ///< neither the particle nor a neighbour has an enriched gradient
        neighbors, ///< a neighbour has
        itself
    };

    std::vector<Reach> reach;        ///< one per particle
    std::vector<std::int32_t> group; ///< of every eight particles: where `fits` has theirs, -1: nowhere
    LargeVector<QuadraticFits> fits; ///< where any of the eight is enriched

    /// How many such places there are.
    std::int64_t groups() const { return group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1; }
    /// Where among the particles of all `fits` particle i is.
    std::int64_t place(std::int64_t i) const { return wide_lanes * group[i / wide_lanes] + i % wide_lanes; }
    /// The farthest reach among the particles [begin, end).
    Reach farthest(std::int64_t begin, std::int64_t end) const;
};

/// Gradients of the particles that lie on the surface, or have a neighbour there.
/// @param correction  L_i   @param supports  radius of the kernel about each particle [mm]
/// @param pairs       with their weights; those with enriched neighbours are put first
EnrichedGradients enrich_gradients(const Cloud& cloud, const LargeVector<Mat3>& correction,
                                   std::span<const double> supports, PairBlocks& pairs);

} // namespace corticle::tlsph
