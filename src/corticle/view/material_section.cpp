// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/material_section.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace corticle::view
{

namespace
{

constexpr std::int32_t none = -1;
constexpr double support = 2.0; // [spacing]
constexpr double farthest = 2.0 * support;

/// Wendland's C2 function.
double weight_of(double q)
{
    const double rest = 1.0 - q;
    return rest * rest * rest * rest * (1.0 + 4.0 * q);
}

/// The part of a row of pixels that a block of consecutive pixels holds.
struct RowPart
{
    int row;
    int first;
    int last;

    /// Index of the first pixel in the picture.
    std::size_t pixel(const PixelGrid& grid) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(first);
    }
};

bool any(std::span<const std::uint8_t> mask)
{
    return std::any_of(mask.begin(), mask.end(), [](std::uint8_t pixel) { return pixel != 0; });
}

/// The pixels of the mask that show no particle.
std::vector<std::uint8_t> still_empty(std::span<const std::uint8_t> mask, std::span<const std::int32_t> shown)
{
    std::vector<std::uint8_t> empty(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
        empty[i] = mask[i] != 0 && shown[i] == none;
    }
    return empty;
}

/// Calls visit(part) for the parts of rows in a picture, concurrently, each pixel once.
template <class Visit>
void for_row_parts(const PixelGrid& grid, Visit&& visit)
{
    parallel_blocks(std::int64_t{grid.width} * grid.height,
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        while (begin < end)
                        {
                            const std::int64_t row = begin / grid.width;
                            const std::int64_t next = std::min(end, (row + 1) * grid.width);
                            visit(RowPart{static_cast<int>(row), static_cast<int>(begin - row * grid.width),
                                          static_cast<int>(next - 1 - row * grid.width)});
                            begin = next;
                        }
                    });
}

/// The particles whose surroundings, balls in the undeformed material, meet the rows of a picture.
class MaterialBalls
{
  public:
    /// Only rows with a pixel wanted are looked at. `radius` [mm].
    MaterialBalls(const CutInput& input, const PixelGrid& grid, double radius, std::span<const std::uint8_t> wanted)
        : grid_(grid), rows_(static_cast<std::size_t>(grid.height))
    {
        std::vector<std::uint8_t> is_wanted(rows_.size(), 0);
        for (std::size_t row = 0; row < rows_.size(); ++row)
        {
            const auto width = static_cast<std::size_t>(grid.width);
            is_wanted[row] = any(wanted.subspan(row * width, width));
        }
        for (std::size_t i = 0; i < input.positions.size(); ++i)
        {
            add(input, i, radius, is_wanted);
        }
    }

    /// Calls seen(column, particle, q², place) for the pixels of the part that lie in balls: `place` in the unit ball,
    /// q < 1 from its centre. For each pixel the particles come in ascending order.
    template <class Visit>
    void visit(const RowPart& part, Visit&& seen) const
    {
        for (const std::size_t index : rows_[static_cast<std::size_t>(part.row)])
        {
            // Along the row q² = least + curvature (column - middle)².
            const Ball& ball = balls_[index];
            const Vec3 start = ball.offset + grid_.right_of(0) * ball.right + grid_.up_of(part.row) * ball.up;
            const Vec3 step = grid_.pixel * ball.right;
            const double curvature = squared_norm(step);
            const double middle = -dot(start, step) / curvature;
            const double least = squared_norm(start + middle * step);
            if (!(least < 1.0))
            {
                continue;
            }
            const double half = std::sqrt((1.0 - least) / curvature);
            const int first = clamped(std::ceil(middle - half), part.first, part.last + 1);
            const int last = clamped(std::floor(middle + half), part.first - 1, part.last);
            for (int column = first; column <= last; ++column)
            {
                const double away = column - middle;
                const double squared = least + curvature * away * away;
                if (squared < 1.0)
                {
                    seen(column, ball.particle, squared, start + (1.0 * column) * step);
                }
            }
        }
    }

  private:
    /// A point (right, up) of the plane lies at offset + right_coordinate right + up_coordinate up in the unit ball.
    struct Ball
    {
        std::size_t particle;
        Vec3 offset;
        Vec3 right;
        Vec3 up;
    };

    static int clamped(double value, int low, int high)
    {
        return static_cast<int>(std::clamp(value, 1.0 * low, 1.0 * high));
    }

    void add(const CutInput& input, std::size_t i, double radius, std::span<const std::uint8_t> is_wanted)
    {
        const Plane plane{input.axis, input.coordinate};
        const double J = determinant(input.F[i]);
        // A gradient that cannot be inverted says nothing of the surroundings: they count as undeformed.
        const Mat3 F = J > 1e-9 && std::isfinite(J) ? input.F[i] : Mat3::identity();
        const Vec3& x = input.positions[i];
        const auto reach = [&](int axis) { return radius * norm(Vec3{F(axis, 0), F(axis, 1), F(axis, 2)}); };
        if (!(std::abs(x[plane.axis] - plane.coordinate) < reach(plane.axis)))
        {
            return;
        }
        const double low = (x[plane.up()] - reach(plane.up()) - grid_.bottom) / grid_.pixel - 0.5;
        const double high = (x[plane.up()] + reach(plane.up()) - grid_.bottom) / grid_.pixel - 0.5;
        if (!std::isfinite(low) || !std::isfinite(high))
        {
            return;
        }
        const Mat3 to_ball = (1.0 / radius) * inverse(F);
        const int last = clamped(std::floor(high), -1, grid_.height - 1);
        for (int row = clamped(std::ceil(low), 0, grid_.height); row <= last; ++row)
        {
            if (is_wanted[static_cast<std::size_t>(row)] != 0)
            {
                rows_[static_cast<std::size_t>(row)].push_back(balls_.size());
            }
        }
        const Vec3& right = to_ball.column[plane.right()];
        const Vec3& up = to_ball.column[plane.up()];
        balls_.push_back({i,
                          (plane.coordinate - x[plane.axis]) * to_ball.column[plane.axis] - x[plane.right()] * right -
                              x[plane.up()] * up,
                          right, up});
    }

    PixelGrid grid_;
    std::vector<Ball> balls_;
    std::vector<std::vector<std::size_t>> rows_; ///< balls that may meet each row
};

/// The particle that came from nearest to a place, if there is one near.
std::int32_t particle_from(const CellGrid& origins, const Vec3& place)
{
    std::int32_t best = none;
    double least = std::numeric_limits<double>::infinity();
    if (std::isfinite(squared_norm(place)))
    {
        origins.near(place,
                     [&](std::int32_t particle, const Vec3& origin)
                     {
                         const double squared = squared_norm(origin - place);
                         if (squared < least || (squared == least && particle < best))
                         {
                             least = squared;
                             best = particle;
                         }
                     });
    }
    return best;
}

/// Fills the pixels by the means of where the particles around take them to have come from.
void fill_by_origin(const CutInput& input, const PixelGrid& grid, std::span<const std::uint8_t> mask,
                    std::span<std::int32_t> shown)
{
    struct Mean
    {
        double weight = 0.0;
        Vec3 origin;
    };
    const double radius = support * input.spacing;
    const MaterialBalls balls(input, grid, radius, mask);
    const CellGrid origins(input.origins, input.spacing);
    for_row_parts(grid,
                  [&](const RowPart& part)
                  {
                      std::vector<Mean> means(static_cast<std::size_t>(part.last - part.first + 1));
                      balls.visit(part,
                                  [&](int column, std::size_t particle, double squared, const Vec3& place)
                                  {
                                      const double weight = weight_of(std::sqrt(squared));
                                      Mean& mean = means[static_cast<std::size_t>(column - part.first)];
                                      mean.weight += weight;
                                      mean.origin += weight * (input.origins[particle] + radius * place);
                                  });
                      for (std::size_t k = 0; k < means.size(); ++k)
                      {
                          const std::size_t pixel = part.pixel(grid) + k;
                          if (mask[pixel] != 0 && means[k].weight > 0.0)
                          {
                              shown[pixel] = particle_from(origins, (1.0 / means[k].weight) * means[k].origin);
                          }
                      }
                  });
}

/// Fills the pixels left with the particle nearest to them, in the material or else in space.
void fill_by_distance(const CutInput& input, const PixelGrid& grid, std::span<const std::uint8_t> left,
                      std::span<std::int32_t> shown)
{
    const MaterialBalls balls(input, grid, farthest * input.spacing, left);
    for_row_parts(grid,
                  [&](const RowPart& part)
                  {
                      std::vector<double> least(static_cast<std::size_t>(part.last - part.first + 1), 1.0);
                      balls.visit(part,
                                  [&](int column, std::size_t particle, double squared, const Vec3&)
                                  {
                                      const auto k = static_cast<std::size_t>(column - part.first);
                                      const std::size_t pixel = part.pixel(grid) + k;
                                      if (left[pixel] != 0 && squared < least[k])
                                      {
                                          least[k] = squared;
                                          shown[pixel] = static_cast<std::int32_t>(particle);
                                      }
                                  });
                  });
    const std::vector<std::uint8_t> far = still_empty(left, shown);
    if (any(far))
    {
        const auto nearest = nearest_particles(input.positions, {input.axis, input.coordinate}, grid, far);
        std::transform(nearest.begin(), nearest.end(), shown.begin(), shown.begin(),
                       [](std::int32_t a, std::int32_t b) { return std::max(a, b); });
    }
}

} // namespace

std::vector<std::int32_t> material_particles(const CutInput& input, const PixelGrid& grid,
                                             std::span<const std::uint8_t> mask)
{
    assert(input.positions.empty() || input.spacing > 0.0);
    std::vector<std::int32_t> shown(mask.size(), none);
    if (input.positions.empty())
    {
        return shown;
    }
    fill_by_origin(input, grid, mask, shown);
    const std::vector<std::uint8_t> left = still_empty(mask, shown);
    if (any(left))
    {
        fill_by_distance(input, grid, left, shown);
    }
    return shown;
}

} // namespace corticle::view
