// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/parallel.hpp"
#include "corticle/material/wide_remodelling.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/fem/elements.hpp"

#include <algorithm>

// The first of the two sweeps over the tets of one chunk: volumes of its nodes. force_pass.hpp has the second, the
// forces on them. Each writes only its chunk's part of a buffer.

namespace corticle::fem
{

/// Volume of a node, or the part of it that one chunk of tets gives: sums of a quarter of the adjacent tets.
struct alignas(32) NodalVolume
{
    double current = 0.0; ///< [mm³]
    double grown = 0.0;   ///< sum of J_g V / 4 [mm³]
    double bulk = 0.0;    ///< sum of K J_g V / 4 [mu_w mm³]
    double lane = 0.0;    ///< fills the register
};

/// What the volume ratio Ja of a node gives to its tets.
struct alignas(32) NodalPressure
{
    double pressure = 0.0; ///< K U'(Ja) [mu_w]
    double density = 0.0;  ///< U(Ja) [-]
    double work = 0.0;     ///< K U'(Ja) Ja [mu_w]
    double lane = 0.0;     ///< fills the register
};

/// One chunk of tets, with its part of the buffers.
struct Chunk
{
    const TetElements& elements;
    const material::Tissue& tissue;
    double t;
    std::int64_t begin, end;             ///< tets
    std::span<const std::int32_t> nodes; ///< that it touches
    std::int64_t first_part;             ///< where their parts start

    /// @param first, last  tets, parallel_block of them or the last ones
    Chunk(const TetElements& all, const material::Tissue& of_tets, double now, std::int64_t first, std::int64_t last)
        : elements(all), tissue(of_tets), t(now), begin(first), end(last)
    {
        const std::int64_t c = first / parallel_block;
        first_part = all.chunk_begin[c];
        nodes = std::span(all.chunk_node).subspan(first_part, all.chunk_begin[c + 1] - first_part);
    }

    const TetBlock& block_of(std::int64_t first) const { return elements.blocks[first / wide_lanes]; }
};

inline constexpr std::size_t most_nodes = 4 * parallel_block; ///< of a chunk

CORTICLE_INLINE WideGroup group_of(const Chunk& chunk, std::int64_t first)
{
    return {first, std::min(wide_lanes, chunk.end - first)};
}

/// `plain`: growth is that of Tissue::grows_plainly. `remodels`: tissue has a history.
template <bool plain, bool remodels>
CORTICLE_INLINE material::WideTissue tissue_of(const Chunk& chunk, const WideGroup& group, const WideMat3& F)
{
    return plain      ? material::plain_tissue(chunk.tissue, chunk.t, group)
           : remodels ? material::unstressed_tissue(chunk.tissue, chunk.t, group, F)
                      : material::any_tissue(chunk.tissue, chunk.t, group, F);
}

/// Parts of the volumes of the chunk's nodes. The first for growth that Tissue::grows_plainly, the last for tissue with
/// a history, whose growth by stress it sets.
void plain_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts);
void general_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts);
void remodelled_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts);

} // namespace corticle::fem
