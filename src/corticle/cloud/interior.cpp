// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/interior.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/geometry/repulsion.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::cloud
{

namespace
{

constexpr double start_depth = 0.5; ///< of the scattered points, in spacings
constexpr double wall_depth = 0.6;  ///< that the relaxation keeps, in spacings
constexpr double least_depth = 0.3; ///< the same where the body is thin
constexpr int relaxation_sweeps = 40;
constexpr double repulsion_range = 1.7; ///< in spacings
constexpr double repulsion_step = 0.3;
constexpr double longest_move = 0.1; ///< in spacings

/// A lattice of cubic cells over the box of a surface.
struct Lattice
{
    Vec3 low;
    double width = 0.0;
    std::array<std::int64_t, 3> cells{};

    std::int64_t count() const { return cells[0] * cells[1] * cells[2]; }

    /// A point at random in a cell.
    Vec3 random_point(std::int64_t cell, std::uint64_t seed) const
    {
        const auto counter = static_cast<std::uint64_t>(3 * cell);
        const std::int64_t row = cell / cells[2];
        const std::int64_t layer = row / cells[1];
        const auto x = static_cast<double>(layer);
        const auto y = static_cast<double>(row % cells[1]);
        const auto z = static_cast<double>(cell % cells[2]);
        return low + width * Vec3{x + hash_uniform(seed, counter), y + hash_uniform(seed, counter + 1),
                                  z + hash_uniform(seed, counter + 2)};
    }
};

Lattice lattice_over(const std::vector<Vec3>& vertices, double width)
{
    const Box box = bounding_box(vertices);
    Lattice lattice{box.low, width, {}};
    for (int axis = 0; axis < 3; ++axis)
    {
        lattice.cells[axis] = static_cast<std::int64_t>(box.size()[axis] / width) + 1;
    }
    return lattice;
}

bool is_inside(const geometry::SurfaceTree& tree, const Vec3& point, double depth)
{
    return tree.closest_within(point, depth).triangle < 0 && tree.winding_number(point) == 1;
}

std::vector<Vec3> points_of_lattice(const geometry::SurfaceTree& tree, const Lattice& lattice, double depth,
                                    std::uint64_t seed)
{
    std::vector<Vec3> points;
    parallel_list(lattice.count(), points,
                  [&](std::int64_t begin, std::int64_t end, std::vector<Vec3>& found)
                  {
                      for (std::int64_t cell = begin; cell < end; ++cell)
                      {
                          const Vec3 point = lattice.random_point(cell, seed);
                          if (is_inside(tree, point, depth))
                          {
                              found.push_back(point);
                          }
                      }
                  });
    return points;
}

/// Keeps each with the probability that the spacing there asks for.
void thin_by_spacing(const geometry::SurfaceTree& tree, const CloudOptions& options, std::vector<Vec3>& points)
{
    const std::vector<double> spacings = local_spacings(tree, options, points);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (hash_uniform(hash_bits(options.seed, 1), i) < std::pow(options.spacing / spacings[i], 3.0))
        {
            points[kept++] = points[i];
        }
    }
    points.resize(kept);
}

/// Leaves `count` points, dropped at random.
void thin_out(std::vector<Vec3>& points, std::size_t count, std::uint64_t seed)
{
    std::vector<std::pair<std::uint64_t, std::size_t>> draw(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        draw[i] = {hash_bits(~seed, i), i};
    }
    std::nth_element(draw.begin(), draw.begin() + static_cast<std::ptrdiff_t>(count), draw.end());
    draw.resize(count);
    std::sort(draw.begin(), draw.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<Vec3> kept;
    kept.reserve(count);
    for (const auto& [hash, index] : draw)
    {
        kept.push_back(points[index]);
    }
    points = std::move(kept);
}

/// Where a moved particle goes: to the wall depth if it came closer to the surface, back if there is no room.
Vec3 keep_inside(const geometry::SurfaceTree& tree, const Vec3& old_place, const Vec3& new_place, double spacing,
                 double& depth)
{
    const double wall = wall_depth * spacing;
    geometry::SurfacePoint foot = tree.closest_within(new_place, 2.0 * spacing);
    depth = foot.triangle < 0 ? 2.0 * spacing : -tree.signed_distance(new_place, foot);
    if (depth >= wall)
    {
        return new_place;
    }
    const Vec3 away = (depth > 0.0 ? 1.0 : -1.0) * normalized(new_place - foot.position);
    const Vec3 pushed = foot.position + wall * away;
    foot = tree.closest_within(pushed, 2.0 * spacing);
    const double pushed_depth = foot.triangle < 0 ? 2.0 * spacing : -tree.signed_distance(pushed, foot);
    if (pushed_depth >= least_depth * spacing)
    {
        depth = pushed_depth;
        return pushed;
    }
    depth = 0.0; // unknown: asks again after the next move
    return old_place;
}

} // namespace

std::vector<Vec3> scatter_inside(const geometry::SurfaceTree& tree, std::int64_t count, const CloudOptions& options)
{
    require_positive("spacing of the particles [mm]", options.spacing);
    require_triangles(tree.mesh());
    if (count <= 0)
    {
        return {};
    }
    const auto wanted = static_cast<double>(count);
    const double depth = start_depth * options.spacing;
    // A few more than wanted, to be thinned out: a lattice cannot be fitted to an exact count.
    constexpr double surplus = 1.004;
    constexpr int most_tries = 12;
    double width = options.spacing;
    std::vector<Vec3> points;
    for (int attempt = 0; attempt < most_tries; ++attempt)
    {
        points = points_of_lattice(tree, lattice_over(tree.mesh().vertices, width), depth, options.seed);
        if (!options.grading.is_uniform())
        {
            thin_by_spacing(tree, options, points);
        }
        const auto found = static_cast<double>(points.size());
        if (found >= wanted && found <= 1.02 * wanted + 20.0)
        {
            break;
        }
        width *= std::cbrt(std::clamp(found / (surplus * wanted + 4.0), 0.1, 4.0));
    }
    if (points.size() > static_cast<std::size_t>(count))
    {
        thin_out(points, static_cast<std::size_t>(count), options.seed);
    }
    return points;
}

std::vector<Vec3> places_inside(const geometry::SurfaceTree& tree, double width)
{
    constexpr double anywhere = 0.0;
    return points_of_lattice(tree, lattice_over(tree.mesh().vertices, width), anywhere, 1);
}

std::vector<double> local_spacings(const geometry::SurfaceTree& tree, const CloudOptions& options,
                                   std::span<const Vec3> points)
{
    std::vector<double> spacings(points.size(), options.spacing);
    if (!options.grading.is_uniform())
    {
        parallel_for(std::ssize(points),
                     [&](std::int64_t i)
                     {
                         const double depth = std::sqrt(tree.closest(points[i]).squared_distance);
                         spacings[i] = options.grading.spacing_at(options.spacing, depth);
                     });
    }
    return spacings;
}

void relax_inside(const geometry::SurfaceTree& tree, const CloudOptions& options, std::vector<Vec3>& points)
{
    const double spacing = options.spacing;
    require_positive("spacing of the particles [mm]", spacing);
    const auto first = static_cast<std::int64_t>(tree.mesh().vertices.size());
    std::vector<Vec3> moves;
    // A lower bound of the distance to the surface: only those that may be near it ask for it again.
    std::vector<double> depth(points.size(), 0.0);
    std::vector<double> ranges;
    for (int sweep = 0; sweep < relaxation_sweeps; ++sweep)
    {
        constexpr int sweeps_per_range = 8; // points move a tenth of a spacing at most
        if (sweep % sweeps_per_range == 0)
        {
            ranges = local_spacings(tree, options, points);
            std::ranges::for_each(ranges, [](double& range) { range *= repulsion_range; });
        }
        geometry::repulsion_moves(points, first, ranges, repulsion_step, longest_move / repulsion_range, moves);
        parallel_for(static_cast<std::int64_t>(moves.size()),
                     [&](std::int64_t k)
                     {
                         const std::int64_t i = first + k;
                         const Vec3 place = points[i] + moves[k];
                         depth[i] -= norm(moves[k]);
                         points[i] = depth[i] >= wall_depth * spacing
                                         ? place
                                         : keep_inside(tree, points[i], place, spacing, depth[i]);
                     });
    }
}

} // namespace corticle::cloud
