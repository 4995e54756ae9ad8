// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Points sorted into cubic cells, for all points near a place. z varies fastest, so three cells of a row are one
/// range.
class CellGrid
{
  public:
    /// Cells no smaller than `cell_size` [mm]; larger where the box of the points would hold too many.
    CellGrid(std::span<const Vec3> points, double cell_size);

    /// Calls visit(index, position) for the points in the 27 cells about `place`: all those within a cell size are
    /// there.
    template <class Visit>
    void near(const Vec3& place, Visit&& visit) const
    {
        const std::array<std::int64_t, 3> c = cell_of(place);
        const std::int64_t z_first = std::max<std::int64_t>(c[2] - 1, 0);
        const std::int64_t z_last = std::min<std::int64_t>(c[2] + 1, cells_[2] - 1);
        for (std::int64_t x = std::max<std::int64_t>(c[0] - 1, 0); x <= std::min(c[0] + 1, cells_[0] - 1); ++x)
        {
            for (std::int64_t y = std::max<std::int64_t>(c[1] - 1, 0); y <= std::min(c[1] + 1, cells_[1] - 1); ++y)
            {
                visit_cells((x * cells_[1] + y) * cells_[2], z_first, z_last, visit);
            }
        }
    }

    /// Calls visit(index, position) for the points in the 9 rows of cells along z about a line parallel to z.
    template <class Visit>
    void near_line(double line_x, double line_y, Visit&& visit) const
    {
        const std::array<std::int64_t, 3> c = cell_of({line_x, line_y, low_.z});
        for (std::int64_t x = std::max<std::int64_t>(c[0] - 1, 0); x <= std::min(c[0] + 1, cells_[0] - 1); ++x)
        {
            for (std::int64_t y = std::max<std::int64_t>(c[1] - 1, 0); y <= std::min(c[1] + 1, cells_[1] - 1); ++y)
            {
                visit_cells((x * cells_[1] + y) * cells_[2], 0, cells_[2] - 1, visit);
            }
        }
    }

    double cell_size() const { return cell_size_; }

  private:
    /// Cell of a place, clamped to one cell outside the grid.
    std::array<std::int64_t, 3> cell_of(const Vec3& place) const
    {
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis)
        {
            const double steps = (place[axis] - low_[axis]) / cell_size_;
            const double bounded = std::clamp(steps, -2.0, static_cast<double>(cells_[axis]) + 2.0);
            cell[axis] = static_cast<std::int64_t>(bounded + 4.0) - 4; // floor
        }
        return cell;
    }

    template <class Visit>
    void visit_cells(std::int64_t row, std::int64_t z_first, std::int64_t z_last, Visit&& visit) const
    {
        if (z_first > z_last)
        {
            return;
        }
        for (std::int32_t k = begin_[row + z_first]; k < begin_[row + z_last + 1]; ++k)
        {
            visit(index_[k], sorted_[k]);
        }
    }

    Vec3 low_;
    double cell_size_ = 1.0;
    std::array<std::int64_t, 3> cells_{};
    std::vector<std::int32_t> begin_; ///< first point of each cell
    std::vector<std::int32_t> index_; ///< points by cell, in ascending order within one
    std::vector<Vec3> sorted_;        ///< their positions
};

} // namespace corticle
