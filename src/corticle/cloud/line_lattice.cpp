// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/line_lattice.hpp"

#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::cloud
{

namespace
{

/// On which side of the edge from a to b, seen along z, the point (x, y) lies. Exactly antisymmetric in the ends, so
/// that a line meets exactly one of the two triangles of an edge.
bool left_of_edge(std::span<const Vec3> vertices, std::int32_t a, std::int32_t b, double x, double y)
{
    const bool swap = a > b;
    const Vec3& p = vertices[swap ? b : a];
    const Vec3& q = vertices[swap ? a : b];
    const bool left = (p.x - x) * (q.y - y) - (p.y - y) * (q.x - x) > 0.0;
    return left != swap;
}

} // namespace

template <class Visit>
void LineLattice::visit_crossings(const TriangleMesh& surface, const Triangle& triangle, Visit&& visit) const
{
    const Vec3& a = surface.vertices[triangle[0]];
    const Vec3& b = surface.vertices[triangle[1]];
    const Vec3& c = surface.vertices[triangle[2]];
    const auto index = [&](double offset, std::int64_t count)
    { return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(offset / step_)), -1, count); };
    const std::int64_t x_first = std::max<std::int64_t>(index(std::min({a.x, b.x, c.x}) - x_, lines_[0]), 0);
    const std::int64_t x_last = std::min(index(std::max({a.x, b.x, c.x}) - x_, lines_[0]) + 1, lines_[0] - 1);
    const std::int64_t y_first = std::max<std::int64_t>(index(std::min({a.y, b.y, c.y}) - y_, lines_[1]), 0);
    const std::int64_t y_last = std::min(index(std::max({a.y, b.y, c.y}) - y_, lines_[1]) + 1, lines_[1] - 1);
    const Vec3 normal = cross(b - a, c - a);
    for (std::int64_t i = x_first; i <= x_last; ++i)
    {
        for (std::int64_t j = y_first; j <= y_last; ++j)
        {
            const double x = x_ + step_ * static_cast<double>(i);
            const double y = y_ + step_ * static_cast<double>(j);
            const bool side = left_of_edge(surface.vertices, triangle[0], triangle[1], x, y);
            if (side != left_of_edge(surface.vertices, triangle[1], triangle[2], x, y) ||
                side != left_of_edge(surface.vertices, triangle[2], triangle[0], x, y))
            {
                continue;
            }
            const double height = a.z - (normal.x * (x - a.x) + normal.y * (y - a.y)) / normal.z;
            const double low = std::min({a.z, b.z, c.z});
            const double high = std::max({a.z, b.z, c.z});
            visit(i * lines_[1] + j, std::isfinite(height) ? std::clamp(height, low, high) : low);
        }
    }
}

LineLattice::LineLattice(const TriangleMesh& surface, double step) : step_(step)
{
    require_triangles(surface);
    require_finite("vertices of the surface", surface.vertices);
    require_positive("distance between lines [mm]", step);
    Vec3 low = surface.vertices[0];
    Vec3 high = surface.vertices[0];
    for (const Vec3& p : surface.vertices)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), 0.0};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), 0.0};
    }
    // Offsets with no simple relation to the step, so that no plane of symmetry of a surface meets a row of lines.
    x_ = low.x + 0.36602540378 * step;
    y_ = low.y + 0.41421356237 * step;
    lines_[0] = static_cast<std::int64_t>((high.x - low.x) / step) + 1;
    lines_[1] = static_cast<std::int64_t>((high.y - low.y) / step) + 1;
    begin_.assign(static_cast<std::size_t>(count()) + 1, 0);
    for (const Triangle& t : surface.triangles)
    {
        visit_crossings(surface, t, [&](std::int64_t line, double) { ++begin_[line + 1]; });
    }
    for (std::size_t k = 1; k < begin_.size(); ++k)
    {
        begin_[k] += begin_[k - 1];
    }
    heights_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const Triangle& t : surface.triangles)
    {
        visit_crossings(surface, t, [&](std::int64_t line, double height) { heights_[next[line]++] = height; });
    }
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k)
    {
        std::sort(heights_.begin() + static_cast<std::ptrdiff_t>(begin_[k]),
                  heights_.begin() + static_cast<std::ptrdiff_t>(begin_[k + 1]));
    }
}

} // namespace corticle::cloud
