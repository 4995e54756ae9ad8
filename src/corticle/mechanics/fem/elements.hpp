// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/base/simd.hpp"
#include "corticle/mesh/tet_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::fem
{

/// Constant data of eight tets, component by component.
struct alignas(64) TetBlock
{
    double inverse_edges[9][wide_lanes]; ///< entry 3a + k: component k of the gradient of the shape function of corner
                                         ///< a + 1 in the reference configuration [1/mm]
    double volume[wide_lanes];           ///< V [mm³]
    std::uint16_t corner[4][wide_lanes]; ///< numbers of the corners among the nodes of their chunk
};

/// Linear tetrahedra of a body in the reference configuration.
///
/// Tets are cut into chunks of `parallel_block`; each chunk knows the nodes it touches. A pass sums within a chunk
/// first, then over the chunks of each node in a fixed order: without races, the same bits for any number of threads.
struct TetElements
{
    std::vector<Vec3> X;                   ///< reference positions of the nodes [mm]
    std::vector<Tet> tets;                 ///< right-handed, neighbours in space close in memory
    std::vector<double> volume;            ///< V of each tet [mm³]
    std::vector<double> node_volume;       ///< a quarter of the adjacent tets [mm³]
    std::vector<TetBlock> blocks;          ///< the last one is filled up with the last tet, its corners all in node 0
    std::vector<std::int64_t> chunk_begin; ///< chunk c touches chunk_node[chunk_begin[c] ... chunk_begin[c + 1]]
    std::vector<std::int32_t> chunk_node;
    std::vector<std::int64_t> part_begin; ///< node i is at part[part_begin[i] ... part_begin[i + 1]] of chunk_node
    std::vector<std::int64_t> part;
    double spacing = 0.0; ///< mean distance between adjacent nodes [mm]
};

/// Tets along a space-filling curve through their centroids.
std::vector<Tet> ordered_tets(std::span<const Vec3> X, std::span<const Tet> tets);

/// [mm]
std::vector<Vec3> centroids(std::span<const Vec3> X, std::span<const Tet> tets);

/// @param tets  right-handed, every node in one of them at least
/// @throws InputError naming the first tet without volume
TetElements make_elements(std::vector<Vec3> X, std::vector<Tet> tets, double spacing);

/// F of one tet for given positions of the nodes.
Mat3 deformation_gradient(const TetElements& elements, std::size_t tet, std::span<const Vec3> x);

} // namespace corticle::fem
