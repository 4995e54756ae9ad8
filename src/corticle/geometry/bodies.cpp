// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/bodies.hpp"

#include "corticle/geometry/mend.hpp"
#include "corticle/geometry/shells.hpp"
#include "corticle/geometry/surface_faults.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <numeric>

namespace corticle::geometry
{

namespace
{

constexpr double small_volume = 0.01; ///< of the largest body
constexpr double small_area = 0.04;   ///< of all: less cannot enclose that much
constexpr double largest_holes = 0.5; ///< squares of the rims' lengths over the area: a hole of 0.4 radii in a sphere

double volume_of(const TriangleMesh& body)
{
    return enclosed_volume(body.vertices, body.triangles);
}

/// The piece closed and turned outward; nothing where it is wide open or cannot be closed.
std::optional<TriangleMesh> closed_piece(const TriangleMesh& piece)
{
    double squares = 0.0;
    for (const SurfaceHole& hole : find_edge_faults(piece).holes)
    {
        squares += hole.length_mm * hole.length_mm;
    }
    if (squares > largest_holes * surface_area(piece.vertices, piece.triangles))
    {
        return std::nullopt;
    }
    try
    {
        std::int64_t filled = 0;
        TriangleMesh closed = orient_and_fill_holes(piece, filled);
        if (volume_of(closed) < 0.0)
        {
            std::ranges::for_each(closed.triangles, [](Triangle& t) { std::swap(t[1], t[2]); });
        }
        return closed;
    }
    catch (const std::exception&) // of ours, or one that CGAL throws where it is at a loss
    {
        return std::nullopt;
    }
}

/// How a body lies to another.
struct Relation
{
    bool is_inside = false; ///< all of its vertices
    bool overlaps = false;  ///< some of them lie inside
    SurfaceBodies::Gap gap; ///< otherwise
};

Relation relation_of(const TriangleMesh& body, const SurfaceTree& other)
{
    std::size_t inside = 0;
    SurfacePoint nearest;
    nearest.squared_distance = std::numeric_limits<double>::infinity();
    Vec3 from;
    for (const Vec3& vertex : body.vertices)
    {
        inside += other.winding_number(vertex) != 0 ? 1 : 0;
        const SurfacePoint foot = other.closest(vertex);
        if (foot.squared_distance < nearest.squared_distance)
        {
            nearest = foot;
            from = vertex;
        }
    }
    return {inside == body.vertices.size(),
            inside > 0,
            {std::sqrt(nearest.squared_distance), 0.5 * (nearest.position + from)}};
}

/// Groups of bodies that overlap, one after another; the closest pair of different groups.
void group(SurfaceBodies& found)
{
    std::vector<std::size_t> group_of(found.bodies.size());
    std::iota(group_of.begin(), group_of.end(), std::size_t{0});
    for (std::size_t a = 0; a < found.bodies.size(); ++a)
    {
        const SurfaceTree tree(found.bodies[a].vertices, found.bodies[a].triangles);
        for (std::size_t b = a + 1; b < found.bodies.size(); ++b)
        {
            const Relation relation = relation_of(found.bodies[b], tree);
            if (relation.overlaps)
            {
                std::ranges::replace(group_of, std::size_t{group_of[b]}, std::size_t{group_of[a]});
            }
            else if (!found.gap || relation.gap.width_mm < found.gap->width_mm)
            {
                found.gap = relation.gap;
            }
        }
    }
    std::ranges::sort(group_of);
    found.separate = std::unique(group_of.begin(), group_of.end()) - group_of.begin();
}

} // namespace

SurfaceBodies find_bodies(const TriangleMesh& surface)
{
    require_vertices(surface);
    const double least_area = small_area * surface_area(surface.vertices, surface.triangles);
    std::vector<TriangleMesh> closed;
    for (const TriangleMesh& piece : separate_shells(surface))
    {
        if (surface_area(piece.vertices, piece.triangles) >= least_area)
        {
            if (auto body = closed_piece(piece))
            {
                closed.push_back(std::move(*body));
            }
        }
    }
    std::ranges::stable_sort(closed, std::greater<>{}, volume_of);
    SurfaceBodies found;
    for (TriangleMesh& body : closed)
    {
        const auto encloses = [&](const TriangleMesh& larger)
        { return relation_of(body, SurfaceTree(larger.vertices, larger.triangles)).is_inside; };
        if (volume_of(body) >= small_volume * volume_of(closed.front()) && std::ranges::none_of(found.bodies, encloses))
        {
            found.bodies.push_back(std::move(body));
        }
    }
    group(found);
    return found;
}

std::int64_t genus_of(const TriangleMesh& surface)
{
    return (2 - std::ssize(surface.vertices) + std::ssize(surface.triangles) / 2) / 2;
}

} // namespace corticle::geometry
