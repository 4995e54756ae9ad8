// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/elements.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::fem
{

namespace
{

static_assert(parallel_block % wide_lanes == 0);
static_assert(4 * parallel_block <= 65536); // a corner has 16 bits

Mat3 edges(std::span<const Vec3> x, const Tet& tet)
{
    const Vec3& origin = x[tet[0]];
    return {{x[tet[1]] - origin, x[tet[2]] - origin, x[tet[3]] - origin}};
}

void require_volume(const TetElements& elements)
{
    for (std::size_t e = 0; e < elements.tets.size(); ++e)
    {
        if (!(elements.volume[e] > 0.0))
        {
            const Vec3& X = elements.X[elements.tets[e][0]];
            throw InputError(fmt::format("tet mesh: tet {} at ({:.4g}, {:.4g}, {:.4g}) mm: got a volume of {:.3g} mm³, "
                                         "expected a positive one",
                                         e, X.x, X.y, X.z, elements.volume[e]));
        }
    }
}

/// Nodes of each chunk in ascending order, and the corners of its tets among them.
void cut_into_chunks(TetElements& elements)
{
    const auto count = static_cast<std::size_t>(elements.tets.size());
    elements.chunk_begin.push_back(0);
    for (std::size_t begin = 0; begin < count; begin += parallel_block)
    {
        const std::size_t end = std::min(count, begin + parallel_block);
        std::vector<std::int32_t> nodes;
        for (std::size_t e = begin; e < end; ++e)
        {
            nodes.insert(nodes.end(), elements.tets[e].begin(), elements.tets[e].end());
        }
        std::ranges::sort(nodes);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (std::size_t e = begin; e < end; ++e)
        {
            for (std::size_t a = 0; a < 4; ++a)
            {
                const auto found = std::ranges::lower_bound(nodes, elements.tets[e][a]);
                elements.blocks[e / wide_lanes].corner[a][e % wide_lanes] =
                    static_cast<std::uint16_t>(found - nodes.begin());
            }
        }
        elements.chunk_node.insert(elements.chunk_node.end(), nodes.begin(), nodes.end());
        elements.chunk_begin.push_back(std::ssize(elements.chunk_node));
    }
}

/// Where each node stands in chunk_node, by a counting sort.
void find_parts(TetElements& elements)
{
    elements.part_begin.assign(elements.X.size() + 1, 0);
    for (const std::int32_t node : elements.chunk_node)
    {
        ++elements.part_begin[node + 1];
    }
    for (std::size_t i = 0; i < elements.X.size(); ++i)
    {
        elements.part_begin[i + 1] += elements.part_begin[i];
    }
    elements.part.resize(elements.chunk_node.size());
    std::vector<std::int64_t> next = elements.part_begin;
    for (std::size_t k = 0; k < elements.chunk_node.size(); ++k)
    {
        elements.part[next[elements.chunk_node[k]]++] = static_cast<std::int64_t>(k);
    }
}

void fill_blocks(TetElements& elements)
{
    const std::size_t count = elements.tets.size();
    elements.blocks.resize((count + wide_lanes - 1) / wide_lanes);
    for (std::size_t slot = 0; slot < wide_lanes * elements.blocks.size(); ++slot)
    {
        const std::size_t e = std::min(slot, count - 1);
        TetBlock& block = elements.blocks[slot / wide_lanes];
        const Mat3 inverse_edges = inverse(edges(elements.X, elements.tets[e]));
        for (int k = 0; k < 9; ++k)
        {
            block.inverse_edges[k][slot % wide_lanes] = inverse_edges(k / 3, k % 3);
        }
        block.volume[slot % wide_lanes] = elements.volume[e];
        for (auto& corner : block.corner)
        {
            corner[slot % wide_lanes] = 0;
        }
    }
}

} // namespace

std::vector<Vec3> centroids(std::span<const Vec3> X, std::span<const Tet> tets)
{
    std::vector<Vec3> result;
    result.reserve(tets.size());
    for (const Tet& tet : tets)
    {
        result.push_back(0.25 * (X[tet[0]] + X[tet[1]] + X[tet[2]] + X[tet[3]]));
    }
    return result;
}

std::vector<Tet> ordered_tets(std::span<const Vec3> X, std::span<const Tet> tets)
{
    std::vector<Tet> result;
    result.reserve(tets.size());
    for (const std::int32_t e : hilbert_order(centroids(X, tets)))
    {
        result.push_back(tets[e]);
    }
    return result;
}

TetElements make_elements(std::vector<Vec3> X, std::vector<Tet> tets, double spacing)
{
    TetMesh mesh{std::move(X), std::move(tets)};
    TetElements elements;
    elements.volume = tet_volumes(mesh);
    elements.node_volume = node_volumes(mesh);
    elements.X = std::move(mesh.vertices);
    elements.tets = std::move(mesh.tets);
    elements.spacing = spacing;
    require_volume(elements);
    fill_blocks(elements);
    cut_into_chunks(elements);
    find_parts(elements);
    return elements;
}

Mat3 deformation_gradient(const TetElements& elements, std::size_t tet, std::span<const Vec3> x)
{
    const Tet& nodes = elements.tets[tet];
    return edges(x, nodes) * inverse(edges(elements.X, nodes));
}

} // namespace corticle::fem
