// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace corticle
{

struct Box
{
    Vec3 low;
    Vec3 high;
};

/// Uniform grids over boxes, one for each size of boxes (twice as large, twice as wide cells): finds those that overlap
/// a query box. Each box lies in the cell of its lower corner, so those of a row of cells follow each other in memory.
class BoxGrid
{
  public:
    BoxGrid(std::span<const Box> boxes, double cell_size)
    {
        std::vector<std::vector<std::int32_t>> members;
        for (std::size_t k = 0; k < boxes.size(); ++k)
        {
            const Vec3 edges = boxes[k].high - boxes[k].low;
            const double cells = std::max({edges.x, edges.y, edges.z}) / cell_size;
            const auto level = static_cast<std::size_t>(std::max(0.0, std::ceil(std::log2(cells / widest_in_cells))));
            members.resize(std::max(members.size(), level + 1));
            members[level].push_back(static_cast<std::int32_t>(k));
        }
        for (std::size_t level = 0; level < members.size(); ++level)
        {
            if (!members[level].empty())
            {
                levels_.emplace_back(boxes, members[level], std::ldexp(cell_size, static_cast<int>(level)));
            }
        }
    }

    /// Sets `found` to every box k > above that overlaps the query, once each, in an order that depends on the boxes
    /// alone; also to one that misses it by the rounding of a float.
    void query(const Box& box, std::int32_t above, std::vector<std::int32_t>& found) const
    {
        found.clear();
        for (const Level& level : levels_)
        {
            level.query(box, above, found);
        }
    }

  private:
    static constexpr double widest_in_cells = 3.0; ///< of a box, or it goes to the next level

    using Cell = std::array<std::int32_t, 3>;
    using Corner = std::array<float, 3>;
    struct Item
    {
        Corner low;  ///< not above that of the box
        Corner high; ///< not below
        std::int32_t index;
    };

    /// A float not above a number.
    static float rounded_down(double a)
    {
        const auto near = static_cast<float>(a);
        return near - std::abs(near) * std::numeric_limits<float>::epsilon() - std::numeric_limits<float>::min();
    }
    static Item item(const Box& box, std::int32_t index)
    {
        return {{rounded_down(box.low.x), rounded_down(box.low.y), rounded_down(box.low.z)},
                {-rounded_down(-box.high.x), -rounded_down(-box.high.y), -rounded_down(-box.high.z)},
                index};
    }
    static bool overlap(const Item& a, const Item& b)
    {
        return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1] &&
               a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
    }

    class Level
    {
      public:
        Level(std::span<const Box> boxes, std::span<const std::int32_t> members, double cell_size)
        {
            Box corners{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}}; // around the lower corners
            for (const std::int32_t k : members)
            {
                const Box& box = boxes[static_cast<std::size_t>(k)];
                for (int axis = 0; axis < 3; ++axis)
                {
                    corners.low[axis] = std::min(std::as_const(corners.low)[axis], box.low[axis]);
                    corners.high[axis] = std::max(std::as_const(corners.high)[axis], box.low[axis]);
                    largest_[axis] = std::max(std::as_const(largest_)[axis], box.high[axis] - box.low[axis]);
                }
            }
            origin_ = corners.low;
            // At most some millions of cells, however large the body.
            const Vec3 extent = corners.high - corners.low;
            const double coarsest = std::cbrt(extent.x * extent.y * extent.z / 4e6);
            inverse_cell_ = 1.0 / std::max(cell_size, coarsest);
            for (int axis = 0; axis < 3; ++axis)
            {
                size_[static_cast<std::size_t>(axis)] =
                    static_cast<std::int32_t>(std::as_const(extent)[axis] * inverse_cell_) + 1;
            }
            begin_.assign(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                                  static_cast<std::size_t>(size_[2]) +
                              1,
                          0);
            std::vector<std::size_t> cell;
            cell.reserve(members.size());
            for (const std::int32_t k : members)
            {
                const Cell at = cell_of(boxes[static_cast<std::size_t>(k)].low);
                cell.push_back(flat(at[0], at[1], at[2]));
                ++begin_[cell.back() + 1];
            }
            for (std::size_t c = 1; c < begin_.size(); ++c)
            {
                begin_[c] += begin_[c - 1];
            }
            items_.resize(members.size());
            std::vector<std::int32_t> fill(begin_.begin(), begin_.end() - 1);
            for (std::size_t m = 0; m < members.size(); ++m)
            {
                items_[static_cast<std::size_t>(fill[cell[m]]++)] =
                    item(boxes[static_cast<std::size_t>(members[m])], members[m]);
            }
        }

        void query(const Box& box, std::int32_t above, std::vector<std::int32_t>& found) const
        {
            const Item asked = item(box, above);
            const Cell low = cell_of(box.low - largest_);
            const Cell high = cell_of(box.high);
            for (std::int32_t z = low[2]; z <= high[2]; ++z)
            {
                for (std::int32_t y = low[1]; y <= high[1]; ++y)
                {
                    const std::int32_t end = begin_[flat(high[0], y, z) + 1];
                    for (std::int32_t m = begin_[flat(low[0], y, z)]; m < end; ++m)
                    {
                        const Item& other = items_[static_cast<std::size_t>(m)];
                        if (other.index > above && overlap(asked, other))
                        {
                            found.push_back(other.index);
                        }
                    }
                }
            }
        }

      private:
        Cell cell_of(const Vec3& p) const
        {
            Cell cell{};
            for (int axis = 0; axis < 3; ++axis)
            {
                const double at = (p[axis] - origin_[axis]) * inverse_cell_;
                const std::int32_t last = size_[static_cast<std::size_t>(axis)] - 1;
                cell[static_cast<std::size_t>(axis)] =
                    at > 0.0 ? static_cast<std::int32_t>(std::min(at, static_cast<double>(last))) : 0;
            }
            return cell;
        }
        std::size_t flat(std::int32_t x, std::int32_t y, std::int32_t z) const
        {
            return static_cast<std::size_t>(x) +
                   static_cast<std::size_t>(size_[0]) *
                       (static_cast<std::size_t>(y) + static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(z));
        }

        Vec3 origin_;
        Vec3 largest_; ///< edges of the boxes
        double inverse_cell_ = 1.0;
        Cell size_{};
        std::vector<std::int32_t> begin_;
        std::vector<Item> items_;
    };

    std::vector<Level> levels_;
};

} // namespace corticle
