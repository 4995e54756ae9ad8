// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace corticle
{

/// A k-d tree of points, for distances to the nearest ones however uneven their density. Queries are const and may run
/// concurrently.
class PointTree
{
  public:
    explicit PointTree(std::span<const Vec3> points);

    /// Squared distances from a place to the `Count` points nearest to it, ascending [mm²]; infinite where there are
    /// fewer. A point of the tree is its own nearest.
    template <std::size_t Count>
    std::array<double, Count> nearest_squared(const Vec3& place) const
    {
        std::array<double, Count> nearest;
        nearest.fill(std::numeric_limits<double>::infinity());
        search(0, std::ssize(points_), place, nearest);
        return nearest;
    }

  private:
    static constexpr std::int64_t leaf = 8;

    void build(std::int64_t begin, std::int64_t end);

    /// Looks through the points of [begin, end), whose split is entered at their middle.
    void search(std::int64_t begin, std::int64_t end, const Vec3& place, std::span<double> nearest) const;

    std::vector<Vec3> points_;       ///< in the order of the tree: the middle one of a range splits it
    std::vector<std::uint8_t> axis_; ///< along which a middle point splits
};

} // namespace corticle
