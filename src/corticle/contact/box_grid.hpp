// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// A uniform grid over boxes: finds those that overlap a query box, each once.
class BoxGrid
{
  public:
    BoxGrid(std::span<const Box> boxes, double cell_size) : boxes_(boxes)
    {
        Box all{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
        for (const Box& box : boxes)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                all.low[axis] = std::min(std::as_const(all.low)[axis], box.low[axis]);
                all.high[axis] = std::max(std::as_const(all.high)[axis], box.high[axis]);
            }
        }
        origin_ = all.low;
        // At most some millions of cells, however large the body.
        const Vec3 extent = all.high - all.low;
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
        for (const Box& box : boxes)
        {
            for_cells(cell_of(box.low), cell_of(box.high), [&](std::size_t cell) { ++begin_[cell + 1]; });
        }
        for (std::size_t cell = 1; cell < begin_.size(); ++cell)
        {
            begin_[cell] += begin_[cell - 1];
        }
        item_.resize(static_cast<std::size_t>(begin_.back()));
        std::vector<std::int32_t> fill(begin_.begin(), begin_.end() - 1);
        for (std::size_t k = 0; k < boxes.size(); ++k)
        {
            for_cells(cell_of(boxes[k].low), cell_of(boxes[k].high),
                      [&](std::size_t cell)
                      { item_[static_cast<std::size_t>(fill[cell]++)] = static_cast<std::int32_t>(k); });
        }
    }

    /// Calls found(k) for every box k > above that overlaps the query, once each, in an order that depends on the
    /// boxes alone.
    template <class Found>
    void query(const Box& box, std::int32_t above, Found&& found) const
    {
        const Cell low = cell_of(box.low);
        for_cells(low, cell_of(box.high),
                  [&](std::size_t cell)
                  {
                      // Items ascend within a cell: from the back, the first that is too low ends the search.
                      for (std::int32_t m = begin_[cell + 1] - 1; m >= begin_[cell]; --m)
                      {
                          const std::int32_t k = item_[static_cast<std::size_t>(m)];
                          if (k <= above)
                          {
                              break;
                          }
                          const Box& other = boxes_[static_cast<std::size_t>(k)];
                          if (overlap(box, other) && first_common_cell(low, cell_of(other.low)) == cell)
                          {
                              found(k);
                          }
                      }
                  });
    }

  private:
    using Cell = std::array<std::int32_t, 3>;

    static bool overlap(const Box& a, const Box& b)
    {
        return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
               a.low.z <= b.high.z && b.low.z <= a.high.z;
    }
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
    std::size_t first_common_cell(const Cell& a, const Cell& b) const
    {
        return flat(std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2]));
    }
    template <class Visit>
    void for_cells(const Cell& low, const Cell& high, Visit&& visit) const
    {
        for (std::int32_t z = low[2]; z <= high[2]; ++z)
        {
            for (std::int32_t y = low[1]; y <= high[1]; ++y)
            {
                for (std::int32_t x = low[0]; x <= high[0]; ++x)
                {
                    visit(flat(x, y, z));
                }
            }
        }
    }

    std::span<const Box> boxes_;
    Vec3 origin_;
    double inverse_cell_ = 1.0;
    Cell size_{};
    std::vector<std::int32_t> begin_;
    std::vector<std::int32_t> item_;
};

} // namespace corticle
