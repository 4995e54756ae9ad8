// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/self_intersections.hpp"

#include "corticle/geometry/cgal_triangles.hpp"
#include "corticle/mesh/sizes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>

namespace corticle::geometry
{

std::vector<std::pair<std::int32_t, std::int32_t>> self_intersections(const TriangleMesh& surface)
{
    require_vertices(surface);
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    const auto mesh = cgal_mesh<Mesh>(surface);
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    pairs.reserve(found.size());
    for (const auto& pair : found)
    {
        const auto first = static_cast<std::int32_t>(pair.first.idx());
        const auto second = static_cast<std::int32_t>(pair.second.idx());
        pairs.emplace_back(std::min(first, second), std::max(first, second));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::int64_t intersecting_triangles(const TriangleMesh& surface)
{
    std::vector<std::int32_t> triangles;
    for (const auto& [first, second] : self_intersections(surface))
    {
        triangles.push_back(first);
        triangles.push_back(second);
    }
    std::ranges::sort(triangles);
    return std::unique(triangles.begin(), triangles.end()) - triangles.begin();
}

} // namespace corticle::geometry
