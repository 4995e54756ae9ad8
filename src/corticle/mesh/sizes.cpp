// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/sizes.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle
{

namespace
{

template <std::size_t Corners>
void require_corners(std::string_view element, std::string_view corner,
                     std::span<const std::array<std::int32_t, Corners>> elements, std::ptrdiff_t count)
{
    for (std::size_t k = 0; k < elements.size(); ++k)
    {
        for (const std::int32_t index : elements[k])
        {
            if (index < 0 || index >= count)
            {
                throw InputError(
                    fmt::format("{} {}: got {} {}, expected 0 to {}", element, k, corner, index, count - 1));
            }
        }
    }
}

} // namespace

void require_size(std::string_view what, std::size_t got, std::size_t expected)
{
    if (got != expected)
    {
        throw InputError(fmt::format("{}: got {} values, expected {}", what, got, expected));
    }
}

void require_positive(std::string_view what, double value)
{
    if (!(value > 0.0) || !std::isfinite(value))
    {
        throw InputError(fmt::format("{}: got {}, expected a finite number above 0", what, value));
    }
}

void require_finite(std::string_view what, std::span<const Vec3> points)
{
    const auto bad = std::ranges::find_if_not(points, is_finite);
    if (bad != points.end())
    {
        throw InputError(fmt::format("{}: got number {} at ({}, {}, {}), expected finite coordinates", what,
                                     bad - points.begin(), bad->x, bad->y, bad->z));
    }
}

void require_vertices(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    require_corners<3>("triangle", "vertex", triangles, std::ssize(vertices));
}

void require_vertices(const TriangleMesh& surface)
{
    require_vertices(surface.vertices, surface.triangles);
}

void require_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    if (triangles.empty())
    {
        throw InputError("a surface without triangles: got 0, expected at least one");
    }
    require_vertices(vertices, triangles);
}

void require_triangles(const TriangleMesh& surface)
{
    require_triangles(surface.vertices, surface.triangles);
}

void require_tets(const TetMesh& mesh)
{
    if (mesh.tets.empty())
    {
        throw InputError("a tet mesh without tets: got 0, expected at least one");
    }
    require_corners<4>("tet", "node", mesh.tets, std::ssize(mesh.vertices));
}

} // namespace corticle
