// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/passes.hpp"

#include "corticle/mechanics/fem/block_law.hpp"

namespace corticle::fem
{

namespace
{

template <bool plain, bool remodels = false>
CORTICLE_INLINE void sum_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    Lanes local[most_nodes];
    for (std::size_t k = 0; k < chunk.nodes.size(); ++k)
    {
        local[k] = lanes(x[chunk.nodes[k]]);
        parts[k] = {};
    }
    for (std::int64_t first = chunk.begin; first < chunk.end; first += wide_lanes)
    {
        const TetBlock& block = chunk.block_of(first);
        const WideGroup group = group_of(chunk, first);
        WideEdges edge;
        gather_edges(block, local, edge);
        auto point = tissue_of<plain, remodels>(chunk, group, WideMat3::identity()).point; // whatever the normal
        if constexpr (remodels)
        {
            const WideLanes J = determinant(gradients(block, edge));
            point = material::grown_by_stress(point, material::grow_by_stress(chunk.tissue, group, point, J));
        }
        const WideLanes grown = material::growth_volume<plain>(point) * in_lanes(block.volume);
        const WideVec3 quarter = 0.25 * WideVec3{volumes(edge), grown, point.bulk_modulus * grown};
        group.scatter_rows(quarter,
                           [&](int l, const Lanes& row)
                           {
                               for (const auto& corner : block.corner)
                               {
                                   reinterpret_cast<Lanes&>(parts[corner[l]]) += row;
                               }
                           });
    }
}

} // namespace

CORTICLE_EVERY_ISA void plain_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    sum_volumes<true>(chunk, x, parts);
}

CORTICLE_EVERY_ISA void general_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    sum_volumes<false>(chunk, x, parts);
}

CORTICLE_EVERY_ISA void remodelled_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    sum_volumes<false, true>(chunk, x, parts);
}

} // namespace corticle::fem
