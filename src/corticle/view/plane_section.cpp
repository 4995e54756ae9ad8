// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/plane_section.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::view
{

namespace
{

/// Particles sorted into square cells of the plane, those nearest to the plane first in each cell.
class PlaneCells
{
  public:
    PlaneCells(std::span<const Vec3> particles, const Plane& plane) : particles_(particles), plane_(plane)
    {
        low_ = {particles[0][plane.right()], particles[0][plane.up()]};
        std::array<double, 2> high = low_;
        for (const Vec3& particle : particles)
        {
            low_ = {std::min(low_[0], particle[plane.right()]), std::min(low_[1], particle[plane.up()])};
            high = {std::max(high[0], particle[plane.right()]), std::max(high[1], particle[plane.up()])};
        }
        // About as many cells as the plane has particles: a section of N particles meets N^(2/3) of them.
        const double along = std::clamp(std::cbrt(static_cast<double>(particles.size())), 1.0, 2000.0);
        size_ =
            std::max({(high[0] - low_[0]) / along, (high[1] - low_[1]) / along, std::numeric_limits<double>::min()});
        count_ = {cell_of(high[0], 0) + 1, cell_of(high[1], 1) + 1};
        fill();
    }

    /// The particle nearest to a point of the plane: rings of cells outward, until no farther ring can hold a nearer
    /// one.
    std::int32_t nearest(double right, double up) const
    {
        const std::int64_t column = std::clamp<std::int64_t>(cell_of(right, 0), 0, count_[0] - 1);
        const std::int64_t row = std::clamp<std::int64_t>(cell_of(up, 1), 0, count_[1] - 1);
        Best best{right, up, std::numeric_limits<double>::infinity(), -1};
        const std::int64_t rings = std::max(count_[0], count_[1]);
        for (std::int64_t ring = 0; ring < rings; ++ring)
        {
            const double reach = static_cast<double>(ring - 1) * size_;
            if (ring > 0 && reach > 0.0 && reach * reach > best.squared_distance)
            {
                break;
            }
            visit_ring(column, row, ring, best);
        }
        return best.particle;
    }

  private:
    struct Best
    {
        double right;
        double up;
        double squared_distance;
        std::int32_t particle;
    };

    std::int64_t cell_of(double position, std::size_t direction) const
    {
        return static_cast<std::int64_t>(std::clamp(std::floor((position - low_[direction]) / size_), -1.0, 1e6));
    }

    std::size_t cell_of(const Vec3& particle) const
    {
        return static_cast<std::size_t>(cell_of(particle[plane_.up()], 1) * count_[0] +
                                        cell_of(particle[plane_.right()], 0));
    }

    double depth(std::int32_t particle) const
    {
        return std::abs(particles_[static_cast<std::size_t>(particle)][plane_.axis] - plane_.coordinate);
    }

    void fill()
    {
        begin_.assign(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
        for (const Vec3& particle : particles_)
        {
            ++begin_[cell_of(particle) + 1];
        }
        for (std::size_t cell = 1; cell < begin_.size(); ++cell)
        {
            begin_[cell] += begin_[cell - 1];
        }
        sorted_.resize(particles_.size());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t i = 0; i < particles_.size(); ++i)
        {
            sorted_[next[cell_of(particles_[i])]++] = static_cast<std::int32_t>(i);
        }
        parallel_for(count_[0] * count_[1],
                     [&](std::int64_t cell)
                     {
                         const auto first =
                             sorted_.begin() + static_cast<std::ptrdiff_t>(begin_[static_cast<std::size_t>(cell)]);
                         const auto last =
                             sorted_.begin() + static_cast<std::ptrdiff_t>(begin_[static_cast<std::size_t>(cell) + 1]);
                         std::sort(first, last,
                                   [&](std::int32_t a, std::int32_t b)
                                   { return std::pair(depth(a), a) < std::pair(depth(b), b); });
                     });
    }

    void visit_ring(std::int64_t column, std::int64_t row, std::int64_t ring, Best& best) const
    {
        for (std::int64_t y = std::max<std::int64_t>(row - ring, 0); y <= std::min(row + ring, count_[1] - 1); ++y)
        {
            const bool is_edge = std::abs(y - row) == ring;
            const std::int64_t step = is_edge || ring == 0 ? 1 : 2 * ring;
            for (std::int64_t x = column - ring; x <= column + ring; x += step)
            {
                if (x >= 0 && x < count_[0])
                {
                    visit_cell(static_cast<std::size_t>(y * count_[0] + x), best);
                }
            }
        }
    }

    void visit_cell(std::size_t cell, Best& best) const
    {
        for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
        {
            const Vec3& particle = particles_[static_cast<std::size_t>(sorted_[k])];
            const double away = particle[plane_.axis] - plane_.coordinate;
            if (away * away > best.squared_distance)
            {
                return; // the rest of the cell lies still farther from the plane
            }
            const double dx = particle[plane_.right()] - best.right;
            const double dy = particle[plane_.up()] - best.up;
            const double squared_distance = dx * dx + dy * dy + away * away;
            if (squared_distance < best.squared_distance)
            {
                best.squared_distance = squared_distance;
                best.particle = sorted_[k];
            }
        }
    }

    std::span<const Vec3> particles_;
    Plane plane_;
    std::array<double, 2> low_{};
    double size_ = 1.0;
    std::array<std::int64_t, 2> count_{1, 1};
    std::vector<std::size_t> begin_;
    std::vector<std::int32_t> sorted_;
};

} // namespace

std::vector<Segment> section_outline(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                     const Plane& plane)
{
    std::vector<Segment> outline;
    for (const Triangle& triangle : triangles)
    {
        Segment segment{};
        int ends = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vec3& a = points[static_cast<std::size_t>(triangle[k])];
            const Vec3& b = points[static_cast<std::size_t>(triangle[(k + 1) % 3])];
            const double height_a = a[plane.axis] - plane.coordinate;
            const double height_b = b[plane.axis] - plane.coordinate;
            if ((height_a >= 0.0) == (height_b >= 0.0))
            {
                continue;
            }
            // From the lower to the upper end, so that both triangles of an edge find the same point.
            const bool rises = height_a < 0.0;
            const Vec3& low = rises ? a : b;
            const Vec3& high = rises ? b : a;
            const double fraction = (plane.coordinate - low[plane.axis]) / (high[plane.axis] - low[plane.axis]);
            const Vec3 crossing = low + fraction * (high - low);
            (rises ? segment.from : segment.to) = {crossing[plane.right()], crossing[plane.up()]};
            ++ends;
        }
        if (ends == 2)
        {
            outline.push_back(segment);
        }
    }
    return outline;
}

std::vector<std::uint8_t> inside_mask(std::span<const Segment> outline, const PixelGrid& grid)
{
    // Crossings of the outline with the centre lines of the rows: where, and whether it goes up or down.
    std::vector<std::vector<std::pair<double, int>>> crossings(static_cast<std::size_t>(grid.height));
    for (const Segment& segment : outline)
    {
        const bool rises = segment.from[1] < segment.to[1];
        const auto& low = rises ? segment.from : segment.to;
        const auto& high = rises ? segment.to : segment.from;
        const double first =
            std::clamp(std::ceil((low[1] - grid.bottom) / grid.pixel - 0.5) - 1.0, 0.0, 1.0 * grid.height);
        for (int row = static_cast<int>(first); row < grid.height && grid.up_of(row) < high[1]; ++row)
        {
            if (grid.up_of(row) >= low[1])
            {
                const double fraction = (grid.up_of(row) - low[1]) / (high[1] - low[1]);
                crossings[static_cast<std::size_t>(row)].emplace_back(low[0] + fraction * (high[0] - low[0]),
                                                                      rises ? 1 : -1);
            }
        }
    }
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0);
    for (int row = 0; row < grid.height; ++row)
    {
        auto& line = crossings[static_cast<std::size_t>(row)];
        std::sort(line.begin(), line.end());
        std::size_t next = 0;
        int winding = 0;
        for (int column = 0; column < grid.width; ++column)
        {
            for (; next < line.size() && line[next].first <= grid.right_of(column); ++next)
            {
                winding += line[next].second;
            }
            mask[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>(column)] = winding != 0;
        }
    }
    return mask;
}

std::vector<std::int32_t> nearest_particles(std::span<const Vec3> particles, const Plane& plane, const PixelGrid& grid,
                                            std::span<const std::uint8_t> mask)
{
    std::vector<std::int32_t> nearest(mask.size(), -1);
    if (particles.empty())
    {
        return nearest;
    }
    const PlaneCells cells(particles, plane);
    parallel_for(static_cast<std::int64_t>(mask.size()),
                 [&](std::int64_t pixel)
                 {
                     const auto i = static_cast<std::size_t>(pixel);
                     if (mask[i] != 0)
                     {
                         nearest[i] = cells.nearest(grid.right_of(static_cast<int>(pixel % grid.width)),
                                                    grid.up_of(static_cast<int>(pixel / grid.width)));
                     }
                 });
    return nearest;
}

std::vector<double> outline_cover(std::span<const Segment> outline, const PixelGrid& grid)
{
    constexpr double half_line = 0.8; // [px]
    // The most that any piece of the line covers, lest joints come out darker.
    std::vector<double> cover(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0.0);
    for (const Segment& segment : outline)
    {
        const Vec3 from{(segment.from[0] - grid.left) / grid.pixel - 0.5,
                        (segment.from[1] - grid.bottom) / grid.pixel - 0.5, 0.0};
        const Vec3 to{(segment.to[0] - grid.left) / grid.pixel - 0.5, (segment.to[1] - grid.bottom) / grid.pixel - 0.5,
                      0.0};
        const auto bound = [](double place, int count)
        { return static_cast<int>(std::clamp(place, -1.0, 1.0 * count)); };
        const int first_x = std::max(bound(std::min(from.x, to.x) - 2.0, grid.width), 0);
        const int last_x = std::min(bound(std::max(from.x, to.x) + 2.0, grid.width), grid.width - 1);
        const int first_y = std::max(bound(std::min(from.y, to.y) - 2.0, grid.height), 0);
        const int last_y = std::min(bound(std::max(from.y, to.y) + 2.0, grid.height), grid.height - 1);
        const double squared_length = std::max(squared_norm(to - from), std::numeric_limits<double>::min());
        for (int y = first_y; y <= last_y; ++y)
        {
            for (int x = first_x; x <= last_x; ++x)
            {
                const Vec3 place{1.0 * x, 1.0 * y, 0.0};
                const double along = std::clamp(dot(place - from, to - from) / squared_length, 0.0, 1.0);
                const double distance = norm(place - from - along * (to - from));
                double& covered = cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                                        static_cast<std::size_t>(x)];
                covered = std::max(covered, std::clamp(half_line + 0.5 - distance, 0.0, 1.0));
            }
        }
    }
    return cover;
}

} // namespace corticle::view
