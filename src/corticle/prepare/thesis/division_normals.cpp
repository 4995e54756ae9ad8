// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/division_normals.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace corticle::prepare
{

namespace
{

void require_divisions(std::int32_t divisions)
{
    constexpr std::int32_t most = 1024;
    if (divisions < 2 || divisions > most || divisions % 2 != 0)
    {
        throw InputError(fmt::format("normals by divisions: got {} divisions; expected an even number from 2 to {}",
                                     divisions, most));
    }
}

/// The lines of each piece.
std::vector<NormalLines> lines_by_division(const NormalLines& lines, std::int32_t divisions, const Vec3& centre)
{
    std::vector<NormalLines> pieces(divisions);
    for (std::size_t k = 0; k < lines.points.size(); ++k)
    {
        NormalLines& piece = pieces[division_of(lines.points[k], divisions, centre)];
        piece.points.push_back(lines.points[k]);
        piece.normals.push_back(lines.normals[k]);
    }
    return pieces;
}

Vec3 normal_of_nearest_line(const Vec3& X, const NormalLines& lines)
{
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    for (std::size_t k = 0; k < lines.points.size(); ++k)
    {
        const double distance2 = squared_norm(cross(X - lines.points[k], lines.normals[k]));
        if (distance2 < nearest)
        {
            nearest = distance2;
            found = k;
        }
    }
    return lines.normals[found];
}

} // namespace

NormalLines triangle_normal_lines(const TriangleMesh& surface)
{
    NormalLines lines;
    for (const Triangle& t : surface.triangles)
    {
        const Vec3& a = surface.vertices[t[0]];
        const Vec3& b = surface.vertices[t[1]];
        const Vec3& c = surface.vertices[t[2]];
        lines.points.push_back((a + b + c) / 3.0);
        lines.normals.push_back(normalized(cross(b - a, c - a)));
    }
    return lines;
}

std::int32_t division_of(const Vec3& point, std::int32_t divisions, const Vec3& centre)
{
    const std::int32_t wedges = divisions / 2;
    const Vec3 r = point - centre;
    const double turn = std::atan2(r.y, r.x) / (2.0 * std::numbers::pi); // -1/2 to 1/2
    const auto wedge = static_cast<std::int32_t>(std::floor((turn < 0.0 ? turn + 1.0 : turn) * wedges));
    return 2 * std::min(wedge, wedges - 1) + (r.z < 0.0 ? 1 : 0);
}

std::vector<Vec3> division_normals(std::span<const Vec3> positions, const NormalLines& lines, std::int32_t divisions,
                                   const Vec3& centre)
{
    require_divisions(divisions);
    const std::vector<NormalLines> pieces = lines_by_division(lines, divisions, centre);
    for (const Vec3& X : positions)
    {
        const std::int32_t piece = division_of(X, divisions, centre);
        if (pieces[piece].points.empty())
        {
            throw InputError(fmt::format("normals by divisions: no normal of the surface in the piece of {} that holds "
                                         "the particle at ({:.4g}, {:.4g}, {:.4g}) mm; expected at least one: use "
                                         "fewer divisions",
                                         divisions, X.x, X.y, X.z));
        }
    }
    std::vector<Vec3> normals(positions.size());
    parallel_for(std::ssize(positions),
                 [&](std::int64_t i)
                 {
                     const NormalLines& near = pieces[division_of(positions[i], divisions, centre)];
                     normals[i] = normal_of_nearest_line(positions[i], near);
                 });
    return normals;
}

} // namespace corticle::prepare
