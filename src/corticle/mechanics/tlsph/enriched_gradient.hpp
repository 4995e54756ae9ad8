// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/large_pages.hpp"
#include "corticle/base/mat3.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"
#include "corticle/mesh/cloud.hpp"

#include <cstdint>
#include <vector>

// Gradients of second order near the surface, where supports are one-sided. See docs/theory/tlsph.md.

namespace corticle::tlsph
{

/// F of a particle near the surface: F_i = sum_j w_ij x_ij (x) b_ij with b_ij = B_i X_ij + (n_i . X_ij) Q_i X_ij.
struct EnrichedGradient
{
    Mat3 B;      ///< B_i
    Mat3 Q;      ///< Q_i [1/mm]; zero where B_i is L_i
    Vec3 normal; ///< n_i, unit, outward
    Vec3 moment; ///< sum_j w_ij (n_i . X_ij) X_ij
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

    std::vector<Reach> reach;               ///< one per particle
    std::vector<std::int32_t> at;           ///< where `gradient` has that of a particle, -1: nowhere
    LargeVector<EnrichedGradient> gradient; ///< of eight consecutive particles at once where any of them is enriched

    /// The farthest reach among the particles [begin, end).
    Reach farthest(std::int64_t begin, std::int64_t end) const;
};

/// Gradients of the particles that lie on the surface, or have a neighbour there.
/// @param correction  L_i   @param supports  radius of the kernel about each particle [mm]
/// @param pairs       with their weights; those with enriched neighbours are put first
EnrichedGradients enrich_gradients(const Cloud& cloud, const LargeVector<Mat3>& correction,
                                   std::span<const double> supports, PairBlocks& pairs);

} // namespace corticle::tlsph
