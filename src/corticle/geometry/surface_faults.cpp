// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/surface_faults.hpp"

#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>

namespace corticle::geometry
{

namespace
{

using Edge = std::pair<std::int32_t, std::int32_t>;

/// Sets of numbers that are joined one by one.
class Unions
{
  public:
    explicit Unions(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    std::int32_t root(std::int32_t k)
    {
        while (parent_[k] != k)
        {
            parent_[k] = parent_[parent_[k]];
            k = parent_[k];
        }
        return k;
    }
    /// The lower root stays.
    void join(std::int32_t a, std::int32_t b)
    {
        const std::int32_t root_a = root(a);
        const std::int32_t root_b = root(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }

  private:
    std::vector<std::int32_t> parent_;
};

struct EdgeUse
{
    std::int32_t count = 0;
    std::int32_t forward = 0; ///< from the lower vertex to the higher
    std::int32_t triangle = 0;
};

std::map<Edge, EdgeUse> edge_uses(const TriangleMesh& surface)
{
    std::map<Edge, EdgeUse> uses;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::int32_t a = surface.triangles[t][k];
            const std::int32_t b = surface.triangles[t][(k + 1) % 3];
            EdgeUse& use = uses[std::minmax(a, b)];
            ++use.count;
            use.forward += a < b ? 1 : 0;
            use.triangle = static_cast<std::int32_t>(t);
        }
    }
    return uses;
}

std::vector<SurfaceHole> holes_of(const TriangleMesh& surface, const std::vector<Edge>& boundary)
{
    Unions rims(surface.vertices.size());
    for (const auto& [a, b] : boundary)
    {
        rims.join(a, b);
    }
    std::map<std::int32_t, SurfaceHole> by_root;
    std::map<std::int32_t, TriangleMesh> rim_points;
    for (const auto& [a, b] : boundary)
    {
        SurfaceHole& hole = by_root[rims.root(a)];
        ++hole.edges;
        hole.length_mm += norm(surface.vertices[a] - surface.vertices[b]);
        std::vector<Vec3>& points = rim_points[rims.root(a)].vertices;
        points.insert(points.end(), {surface.vertices[a], surface.vertices[b]});
    }
    std::vector<SurfaceHole> holes;
    holes.reserve(by_root.size());
    for (auto& [root, hole] : by_root)
    {
        hole.radius_mm = std::min(hole.length_mm / (2.0 * std::numbers::pi), 0.5 * bounding_diagonal(rim_points[root]));
        holes.push_back(hole);
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const SurfaceHole& a, const SurfaceHole& b) { return a.length_mm > b.length_mm; });
    return holes;
}

/// Vertices that more than one strip of triangles meets, at least one of them with two open sides.
std::vector<char> pinched_vertices(const TriangleMesh& surface)
{
    // About a vertex with one strip, boundary edges come in one pair.
    std::vector<std::int32_t> open_sides(surface.vertices.size(), 0);
    for (const auto& [edge, use] : edge_uses(surface))
    {
        open_sides[edge.first] += use.count == 1 ? 1 : 0;
        open_sides[edge.second] += use.count == 1 ? 1 : 0;
    }
    std::vector<char> pinched(surface.vertices.size(), 0);
    std::ranges::transform(open_sides, pinched.begin(), [](std::int32_t sides) { return sides > 2 ? 1 : 0; });
    return pinched;
}

} // namespace

EdgeFaults find_edge_faults(const TriangleMesh& surface)
{
    require_vertices(surface);
    EdgeFaults faults;
    std::vector<Edge> boundary;
    for (const auto& [edge, use] : edge_uses(surface))
    {
        if (use.count == 1)
        {
            boundary.push_back(edge);
        }
        faults.crowded_edges += use.count > 2;
        faults.opposed_edges += use.count == 2 && use.forward != 1;
    }
    faults.boundary_edges = std::ssize(boundary);
    faults.holes = holes_of(surface, boundary);
    return faults;
}

std::vector<std::int32_t> shells_of(const TriangleMesh& surface)
{
    require_vertices(surface);
    Unions unions(surface.vertices.size());
    for (const Triangle& t : surface.triangles)
    {
        unions.join(t[0], t[1]);
        unions.join(t[0], t[2]);
    }
    std::map<std::int32_t, std::int32_t> number;
    std::vector<std::int32_t> shells;
    shells.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles)
    {
        shells.push_back(number.try_emplace(unions.root(t[0]), static_cast<std::int32_t>(number.size())).first->second);
    }
    return shells;
}

TriangleMesh kept_triangles(const TriangleMesh& surface, const std::vector<char>& keep)
{
    require_vertices(surface);
    require_size("marks of the triangles to keep", keep.size(), surface.triangles.size());
    std::vector<char> used(surface.vertices.size(), 0);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        for (const std::int32_t vertex : surface.triangles[t])
        {
            used[vertex] = used[vertex] != 0 || keep[t] != 0 ? 1 : 0;
        }
    }
    TriangleMesh result;
    std::vector<std::int32_t> number(surface.vertices.size(), -1);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        if (used[v] != 0)
        {
            number[v] = static_cast<std::int32_t>(result.vertices.size());
            result.vertices.push_back(surface.vertices[v]);
        }
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        if (keep[t] != 0)
        {
            const Triangle& corners = surface.triangles[t];
            result.triangles.push_back({number[corners[0]], number[corners[1]], number[corners[2]]});
        }
    }
    return result;
}

TriangleMesh merge_within(const TriangleMesh& surface, double distance)
{
    require_vertices(surface);
    std::vector<std::int32_t> order(surface.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::int32_t v) { return surface.vertices[v].x; });
    Unions same(surface.vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const Vec3& p = surface.vertices[order[i]];
        for (std::size_t j = i + 1; j < order.size() && surface.vertices[order[j]].x - p.x <= distance; ++j)
        {
            if (squared_norm(surface.vertices[order[j]] - p) <= distance * distance)
            {
                same.join(order[i], order[j]);
            }
        }
    }
    TriangleMesh merged = surface;
    std::vector<char> keep;
    keep.reserve(merged.triangles.size());
    for (Triangle& t : merged.triangles)
    {
        t = {same.root(t[0]), same.root(t[1]), same.root(t[2])};
        keep.push_back(t[0] != t[1] && t[1] != t[2] && t[2] != t[0] ? 1 : 0);
    }
    return kept_triangles(merged, keep);
}

TriangleMesh drop_repeated_triangles(const TriangleMesh& surface)
{
    std::set<Triangle> seen;
    std::vector<char> keep;
    keep.reserve(surface.triangles.size());
    for (Triangle t : surface.triangles)
    {
        std::sort(t.begin(), t.end());
        keep.push_back(seen.insert(t).second ? 1 : 0);
    }
    return kept_triangles(surface, keep);
}

TriangleMesh open_pinched_holes(const TriangleMesh& surface)
{
    require_vertices(surface);
    TriangleMesh result = surface;
    constexpr int most_rounds = 10;
    for (int round = 0; round < most_rounds; ++round)
    {
        const std::vector<char> pinched = pinched_vertices(result);
        if (std::ranges::none_of(pinched, [](char p) { return p != 0; }))
        {
            break;
        }
        std::vector<char> keep;
        keep.reserve(result.triangles.size());
        for (const Triangle& t : result.triangles)
        {
            keep.push_back(pinched[t[0]] != 0 || pinched[t[1]] != 0 || pinched[t[2]] != 0 ? 0 : 1);
        }
        result = kept_triangles(result, keep);
    }
    return result;
}

double bounding_diagonal(const TriangleMesh& surface)
{
    Vec3 low = surface.vertices.at(0);
    Vec3 high = low;
    for (const Vec3& p : surface.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    return norm(high - low);
}

} // namespace corticle::geometry
