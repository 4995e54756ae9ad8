// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/hemispheres.hpp"

#include "corticle/base/box.hpp"
#include "corticle/geometry/surface_faults.hpp"

#include <algorithm>
#include <limits>

namespace corticle::study
{

namespace
{

/// Extent of a piece along x.
struct Reach
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// Of each piece. @param pieces  geometry::shells_of(surface)
std::vector<Reach> reaches_of(const TriangleMesh& surface, std::span<const std::int32_t> pieces)
{
    std::vector<Reach> reaches(pieces.empty() ? 0 : static_cast<std::size_t>(*std::ranges::max_element(pieces) + 1));
    for (std::size_t t = 0; t < pieces.size(); ++t)
    {
        Reach& reach = reaches[static_cast<std::size_t>(pieces[t])];
        for (const std::int32_t v : surface.triangles[t])
        {
            reach.low = std::min(reach.low, surface.vertices[static_cast<std::size_t>(v)].x);
            reach.high = std::max(reach.high, surface.vertices[static_cast<std::size_t>(v)].x);
        }
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
    for (const Reach& reach : reaches_of(surface, geometry::shells_of(surface)))
    {
        if (reach.low < middle && reach.high > middle)
        {
            return false;
        }
        has_left = has_left || reach.high <= middle;
        has_right = has_right || reach.low >= middle;
    }
    return has_left && has_right;
}

std::vector<SurfacePart> hemispheres(const TriangleMesh& surface, bool cuts)
{
    const double middle = bounding_box(surface.vertices).center().x;
    const std::vector<std::int32_t> pieces = geometry::shells_of(surface);
    const std::vector<Reach> reaches = reaches_of(surface, pieces);
    std::vector<Triangle> left;
    std::vector<Triangle> right;
    for (std::size_t t = 0; t < pieces.size(); ++t)
    {
        const Triangle& triangle = surface.triangles[t];
        const Reach& reach = reaches[static_cast<std::size_t>(pieces[t])];
        double sum = 0.0;
        for (const std::int32_t v : triangle)
        {
            sum += surface.vertices[static_cast<std::size_t>(v)].x;
        }
        ((cuts ? sum / 3.0 : 0.5 * (reach.low + reach.high)) < middle ? left : right).push_back(triangle);
    }
    return {part_of(surface.vertices.size(), left, "CortexLeft", "L"),
            part_of(surface.vertices.size(), right, "CortexRight", "R")};
}

} // namespace corticle::study
