// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/validate.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace corticle::geometry
{

namespace
{

struct DirectedEdge
{
    std::int32_t low, high; ///< its ends
    bool forward;           ///< from low to high
};

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& surface)
{
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * surface.triangles.size());
    for (const Triangle& t : surface.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            const std::int32_t a = t[k];
            const std::int32_t b = t[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const DirectedEdge& a, const DirectedEdge& b)
              { return std::tie(a.low, a.high, a.forward) < std::tie(b.low, b.high, b.forward); });
    return edges;
}

void require_numbers(const TriangleMesh& surface, const std::string& source)
{
    if (surface.triangles.empty())
    {
        throw InputError(fmt::format("{}: empty surface: 0 triangles; expected a closed surface", source));
    }
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        const Vec3& p = surface.vertices[v];
        if (!is_finite(p))
        {
            throw InputError(fmt::format("{}: vertex {} is not finite: ({}, {}, {})", source, v, p.x, p.y, p.z));
        }
    }
    const auto count = static_cast<std::int64_t>(surface.vertices.size());
    for (std::size_t f = 0; f < surface.triangles.size(); ++f)
    {
        const Triangle& t = surface.triangles[f];
        for (const std::int32_t vertex : t)
        {
            if (vertex < 0 || vertex >= count)
            {
                throw InputError(
                    fmt::format("{}: triangle {} refers to vertex {}; expected 0 to {}", source, f, vertex, count - 1));
            }
        }
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        {
            throw InputError(
                fmt::format("{}: triangle {} has a vertex twice: {}, {}, {}", source, f, t[0], t[1], t[2]));
        }
    }
}

void require_closed(const TriangleMesh& surface, const std::string& source)
{
    const std::vector<DirectedEdge> edges = sorted_edges(surface);
    std::int64_t boundary = 0;
    std::int64_t crowded = 0;
    std::int64_t opposed = 0;
    DirectedEdge example{};
    for (std::size_t first = 0; first < edges.size();)
    {
        std::size_t last = first;
        while (last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high)
        {
            ++last;
        }
        const std::size_t uses = last - first;
        boundary += uses == 1;
        crowded += uses > 2;
        opposed += uses == 2 && edges[first].forward == edges[first + 1].forward;
        example = uses > 2 || (uses == 2 && edges[first].forward == edges[first + 1].forward) ? edges[first] : example;
        first = last;
    }
    if (crowded > 0)
    {
        throw InputError(fmt::format("{}: not manifold: {} edges with more than two triangles, one between vertices {} "
                                     "and {}; expected two triangles at every edge",
                                     source, crowded, example.low, example.high));
    }
    if (boundary > 0)
    {
        throw InputError(
            fmt::format("{}: open surface: {} boundary edges; expected a closed surface", source, boundary));
    }
    if (opposed > 0)
    {
        throw InputError(fmt::format("{}: inconsistent orientation: {} edges between triangles of opposite sense, one "
                                     "between vertices {} and {}",
                                     source, opposed, example.low, example.high));
    }
}

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t k)
{
    while (parent[k] != k)
    {
        parent[k] = parent[parent[k]];
        k = parent[k];
    }
    return k;
}

/// Every edge has two triangles of consistent sense: the triangles at a vertex then form cycles, one for a manifold.
void require_manifold_vertices(const TriangleMesh& surface, const std::string& source)
{
    std::vector<std::int32_t> corners(surface.vertices.size(), 0);
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> next; // about a vertex: from a neighbour to the next
    std::vector<std::int32_t> start(surface.vertices.size(), -1);
    for (const Triangle& t : surface.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            ++corners[t[k]];
            next[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
            start[t[k]] = t[(k + 1) % 3];
        }
    }
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        std::int32_t walked = 0;
        std::int32_t at = start[v];
        while (walked < corners[v] && (walked == 0 || at != start[v]))
        {
            at = next[{static_cast<std::int32_t>(v), at}];
            ++walked;
        }
        if (walked != corners[v])
        {
            throw InputError(fmt::format("{}: not manifold: vertex {} joins separate fans of triangles", source, v));
        }
    }
}

void require_one_component(const TriangleMesh& surface, const std::string& source)
{
    std::vector<std::int32_t> parent(surface.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    std::vector<char> used(surface.vertices.size(), 0);
    for (const Triangle& t : surface.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            used[t[k]] = 1;
            parent[root_of(parent, t[k])] = root_of(parent, t[(k + 1) % 3]);
        }
    }
    std::int64_t components = 0;
    for (std::size_t v = 0; v < parent.size(); ++v)
    {
        if (used[v] == 0)
        {
            throw InputError(fmt::format("{}: vertex {} belongs to no triangle", source, v));
        }
        components += parent[v] == static_cast<std::int32_t>(v);
    }
    if (components != 1)
    {
        throw InputError(fmt::format("{}: {} components; expected 1", source, components));
    }
}

void require_volume(const TriangleMesh& surface, const std::string& source)
{
    const double volume = enclosed_volume(surface.vertices, surface.triangles);
    const double area = surface_area(surface.vertices, surface.triangles);
    if (!std::isfinite(volume) || !std::isfinite(area))
    {
        throw InputError(fmt::format("{}: enclosed volume {} mm³ is not finite", source, volume));
    }
    // A flat surface encloses nothing but round-off: compare with a sphere of the same area.
    constexpr double round_off = 1e-12;
    if (std::abs(volume) <= round_off * std::pow(area, 1.5))
    {
        throw InputError(fmt::format("{}: flat: the enclosed volume is zero; expected a positive one", source));
    }
    if (volume < 0.0)
    {
        throw InputError(fmt::format("{}: inside-out (enclosed volume {:.6g} mm³); expected normals that point outward",
                                     source, volume));
    }
}

void require_embedded(const TriangleMesh& surface, const std::string& source)
{
    const auto pairs = self_intersections(surface);
    if (!pairs.empty())
    {
        throw InputError(fmt::format("{}: self-intersecting: {} pairs of triangles cross, first {} and {}", source,
                                     pairs.size(), pairs[0].first, pairs[0].second));
    }
}

} // namespace

void require_valid_surface(const TriangleMesh& surface, const std::string& source)
{
    require_numbers(surface, source);
    require_closed(surface, source);
    require_one_component(surface, source);
    require_manifold_vertices(surface, source);
    require_volume(surface, source);
    require_embedded(surface, source);
}

TriangleMesh merge_duplicates(const TriangleMesh& surface)
{
    require_vertices(surface);
    std::vector<std::int32_t> order(surface.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto less = [&](std::int32_t a, std::int32_t b)
    {
        const Vec3& p = surface.vertices[a];
        const Vec3& q = surface.vertices[b];
        return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    };
    // Vertices that are not finite have no order; they stay as they are, for require_valid_surface to name.
    const auto finite_end = std::stable_partition(order.begin(), order.end(),
                                                  [&](std::int32_t v) { return is_finite(surface.vertices[v]); });
    std::sort(order.begin(), finite_end, less);
    std::vector<std::int32_t> same(surface.vertices.size());
    std::iota(same.begin(), same.end(), 0);
    for (auto it = order.begin(); it != finite_end; ++it)
    {
        const bool repeats = it != order.begin() && surface.vertices[*it] == surface.vertices[*(it - 1)];
        same[*it] = repeats ? same[*(it - 1)] : *it;
    }
    TriangleMesh result;
    std::vector<std::int32_t> number(surface.vertices.size(), -1);
    for (const Triangle& t : surface.triangles)
    {
        Triangle merged{same[t[0]], same[t[1]], same[t[2]]};
        if (merged[0] == merged[1] || merged[1] == merged[2] || merged[2] == merged[0])
        {
            continue;
        }
        for (std::int32_t& vertex : merged)
        {
            if (number[vertex] < 0)
            {
                number[vertex] = static_cast<std::int32_t>(result.vertices.size());
                result.vertices.push_back(surface.vertices[vertex]);
            }
            vertex = number[vertex];
        }
        result.triangles.push_back(merged);
    }
    return result;
}

} // namespace corticle::geometry
