// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/kuhn_grid.hpp"

#include "corticle/base/parallel.hpp"

#include <bit>

namespace corticle::imaging
{

namespace
{

constexpr unsigned all_neighbors = (1U << kuhn_neighbors) - 1;

constexpr std::array<int, 3> kuhn_step(int k)
{
    const int bits = k % 7 + 1;
    const int sign = k < 7 ? 1 : -1;
    return {sign * (bits & 1), sign * (bits >> 1 & 1), sign * (bits >> 2 & 1)};
}

constexpr bool is_kuhn_edge(const std::array<int, 3>& d)
{
    const bool upward = d[0] >= 0 && d[1] >= 0 && d[2] >= 0 && d[0] <= 1 && d[1] <= 1 && d[2] <= 1;
    const bool downward = d[0] <= 0 && d[1] <= 0 && d[2] <= 0 && d[0] >= -1 && d[1] >= -1 && d[2] >= -1;
    return (upward || downward) && (d[0] != 0 || d[1] != 0 || d[2] != 0);
}

/// For each neighbour the neighbours it shares an edge with.
constexpr std::array<unsigned, kuhn_neighbors> link_edges()
{
    std::array<unsigned, kuhn_neighbors> edges{};
    for (int a = 0; a < kuhn_neighbors; ++a)
    {
        for (int b = 0; b < kuhn_neighbors; ++b)
        {
            const auto p = kuhn_step(a);
            const auto q = kuhn_step(b);
            if (is_kuhn_edge({q[0] - p[0], q[1] - p[1], q[2] - p[2]}))
            {
                edges[a] |= 1U << b;
            }
        }
    }
    return edges;
}

bool is_connected(unsigned set, const std::array<unsigned, kuhn_neighbors>& edges)
{
    unsigned reached = set & (~set + 1U);
    for (unsigned front = reached; front != 0;)
    {
        const int at = std::countr_zero(front);
        front &= front - 1;
        const unsigned fresh = edges[at] & set & ~reached;
        reached |= fresh;
        front |= fresh;
    }
    return set != 0 && reached == set;
}

std::vector<std::uint8_t> simple_table()
{
    constexpr auto edges = link_edges();
    std::vector<std::uint8_t> table(all_neighbors + 1U);
    for (unsigned set = 0; set <= all_neighbors; ++set)
    {
        table[set] = is_connected(set, edges) && is_connected(all_neighbors & ~set, edges) ? 1 : 0;
    }
    return table;
}

/// Simplices whose lowest vertex is a voxel, counted with sign, for each set of its upward neighbours inside.
std::array<std::int64_t, 128> euler_table()
{
    std::array<std::int64_t, 128> table{};
    for (unsigned set = 0; set < 128; ++set)
    {
        const auto has = [&](unsigned bits) { return (set >> (bits - 1) & 1U) != 0; };
        std::int64_t sum = 1;
        for (unsigned a = 1; a < 8; ++a)
        {
            sum -= has(a) ? 1 : 0;
            for (unsigned b = a + 1; b < 8; ++b)
            {
                const bool triangle = (a & b) == a && has(a) && has(b);
                sum += triangle ? 1 : 0;
                // A tetrahedron ends at the highest corner.
                sum -= triangle && std::popcount(a) == 1 && std::popcount(b) == 2 && has(7) ? 1 : 0;
            }
        }
        table[set] = sum;
    }
    return table;
}

} // namespace

std::array<std::int64_t, kuhn_neighbors> kuhn_offsets(const VoxelGrid& grid)
{
    std::array<std::int64_t, kuhn_neighbors> offsets{};
    for (int k = 0; k < kuhn_neighbors; ++k)
    {
        const auto step = kuhn_step(k);
        offsets[k] = step[0] * grid.stride(0) + step[1] * grid.stride(1) + step[2] * grid.stride(2);
    }
    return offsets;
}

bool is_simple(unsigned inside)
{
    static const std::vector<std::uint8_t> table = simple_table();
    return table[inside] != 0;
}

std::int64_t euler_characteristic(const VoxelGrid& grid, const Mask& mask)
{
    require_voxels(grid, "mask", mask.size());
    static const std::array<std::int64_t, 128> table = euler_table();
    const auto offsets = kuhn_offsets(grid);
    return parallel_reduce(
        grid.count(), std::int64_t{0},
        [&](std::int64_t begin, std::int64_t end)
        {
            std::int64_t sum = 0;
            for (std::int64_t voxel = begin; voxel < end; ++voxel)
            {
                if (mask[voxel] == 1)
                {
                    unsigned upward = 0;
                    for (int k = 0; k < 7; ++k)
                    {
                        upward |= static_cast<unsigned>(mask[voxel + offsets[k]] == 1) << k;
                    }
                    sum += table[upward];
                }
            }
            return sum;
        },
        [](std::int64_t& total, std::int64_t part) { total += part; });
}

Components kuhn_components(const VoxelGrid& grid, const Mask& mask, std::uint8_t value)
{
    require_voxels(grid, "mask", mask.size());
    const auto offsets = kuhn_offsets(grid);
    Components result{std::vector<std::int32_t>(mask.size(), 0), {0}};
    std::vector<std::int64_t> stack;
    for (std::int64_t start = 0; start < grid.count(); ++start)
    {
        if (mask[start] != value || result.number[start] != 0)
        {
            continue;
        }
        const auto number = static_cast<std::int32_t>(result.sizes.size());
        result.sizes.push_back(0);
        result.number[start] = number;
        stack.assign(1, start);
        while (!stack.empty())
        {
            const std::int64_t voxel = stack.back();
            stack.pop_back();
            ++result.sizes.back();
            for (const std::int64_t offset : offsets)
            {
                const std::int64_t next = voxel + offset;
                if (next >= 0 && next < grid.count() && mask[next] == value && result.number[next] == 0)
                {
                    result.number[next] = number;
                    stack.push_back(next);
                }
            }
        }
    }
    return result;
}

} // namespace corticle::imaging
