// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/hemispheres.hpp"

#include "corticle/base/box.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace corticle::study
{

namespace
{

/// For each vertex the least number of the vertices that edges connect it with.
std::vector<std::int32_t> pieces_of(const TriangleMesh& surface)
{
    std::vector<std::int32_t> parent(surface.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](std::int32_t v)
    {
        while (parent[static_cast<std::size_t>(v)] != v)
        {
            std::int32_t& up = parent[static_cast<std::size_t>(v)];
            up = parent[static_cast<std::size_t>(up)];
            v = up;
        }
        return v;
    };
    for (const Triangle& triangle : surface.triangles)
    {
        const std::int32_t low = std::min({root(triangle[0]), root(triangle[1]), root(triangle[2])});
        for (const std::int32_t v : triangle)
        {
            parent[static_cast<std::size_t>(root(v))] = low;
        }
    }
    for (std::size_t v = 0; v < parent.size(); ++v)
    {
        parent[v] = root(static_cast<std::int32_t>(v));
    }
    return parent;
}

/// Extent of each piece along x, in the place of its least vertex.
struct Reach
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

std::vector<Reach> reaches_of(const TriangleMesh& surface, std::span<const std::int32_t> pieces)
{
    std::vector<Reach> reaches(pieces.size());
    for (std::size_t v = 0; v < pieces.size(); ++v)
    {
        Reach& reach = reaches[static_cast<std::size_t>(pieces[v])];
        reach.low = std::min(reach.low, surface.vertices[v].x);
        reach.high = std::max(reach.high, surface.vertices[v].x);
    }
    return reaches;
}

SurfacePart part_of(std::size_t vertex_count, std::span<const Triangle> triangles, std::string structure,
                    std::string letter)
{
    SurfacePart part{std::move(structure), std::move(letter), {}, {}};
    std::vector<std::int32_t> number(vertex_count, -1);
    for (const Triangle& triangle : triangles)
    {
        for (const std::int32_t v : triangle)
        {
            number[static_cast<std::size_t>(v)] = 0;
        }
    }
    for (std::size_t v = 0; v < vertex_count; ++v)
    {
        if (number[v] == 0)
        {
            number[v] = static_cast<std::int32_t>(part.kept.size());
            part.kept.push_back(static_cast<std::int32_t>(v));
        }
    }
    for (const Triangle& triangle : triangles)
    {
        part.triangles.push_back({number[static_cast<std::size_t>(triangle[0])],
                                  number[static_cast<std::size_t>(triangle[1])],
                                  number[static_cast<std::size_t>(triangle[2])]});
    }
    return part;
}

} // namespace

bool has_separate_hemispheres(const TriangleMesh& surface)
{
    const double middle = bounding_box(surface.vertices).center().x;
    bool has_left = false;
    bool has_right = false;
    for (const Reach& reach : reaches_of(surface, pieces_of(surface)))
    {
        if (reach.low < middle && reach.high > middle)
        {
            return false;
        }
        const bool is_piece = reach.low <= reach.high;
        has_left = has_left || (is_piece && reach.high <= middle);
        has_right = has_right || (is_piece && reach.low >= middle);
    }
    return has_left && has_right;
}

std::vector<SurfacePart> hemispheres(const TriangleMesh& surface, bool cuts)
{
    const double middle = bounding_box(surface.vertices).center().x;
    const std::vector<std::int32_t> pieces = pieces_of(surface);
    const std::vector<Reach> reaches = reaches_of(surface, pieces);
    const auto is_left = [&](const Triangle& triangle)
    {
        const Reach& reach = reaches[static_cast<std::size_t>(pieces[static_cast<std::size_t>(triangle[0])])];
        double sum = 0.0;
        for (const std::int32_t v : triangle)
        {
            sum += surface.vertices[static_cast<std::size_t>(v)].x;
        }
        return (cuts ? sum / 3.0 : 0.5 * (reach.low + reach.high)) < middle;
    };
    std::vector<Triangle> sorted = surface.triangles;
    const auto right = std::stable_partition(sorted.begin(), sorted.end(), is_left);
    return {part_of(surface.vertices.size(), {sorted.begin(), right}, "CortexLeft", "L"),
            part_of(surface.vertices.size(), {right, sorted.end()}, "CortexRight", "R")};
}

} // namespace corticle::study
