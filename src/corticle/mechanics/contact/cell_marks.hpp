// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/box.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace corticle::contact
{

/// Cubic cells of space, some of which are marked; what lies beyond the bounds counts with the outermost cells.
class CellMarks
{
  public:
    /// @param cell  edge length, enlarged where there would be too many [mm]
    CellMarks(const Box& bounds, double cell) : low_(bounds.low)
    {
        const double longest = 2.0 * bounds.half_width();
        const double edge = std::max(cell, longest / most_along_an_edge);
        per_mm_ = edge > 0.0 ? 1.0 / edge : 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
            count_[static_cast<std::size_t>(axis)] = 1 + static_cast<std::int64_t>(bounds.size()[axis] * per_mm_);
        }
        marked_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
    }

    /// Marks the cells that a box meets.
    void mark(const Box& box)
    {
        visit(box,
              [this](std::size_t cell)
              {
                  marked_[cell] = 1;
                  return false;
              });
    }
    /// Whether a box meets a marked cell.
    bool meets(const Box& box) const
    {
        return visit(box, [this](std::size_t cell) { return marked_[cell] != 0; });
    }

  private:
    static constexpr double most_along_an_edge = 256.0;

    /// Calls ends(cell) for the cells that a box meets until it is true.
    template <class Ends>
    bool visit(const Box& box, Ends&& ends) const
    {
        if (!(box.low.x <= box.high.x))
        {
            return false;
        }
        std::array<std::int64_t, 3> first{};
        std::array<std::int64_t, 3> last{};
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto k = static_cast<std::size_t>(axis);
            first[k] = along(box.low[axis], axis);
            last[k] = along(box.high[axis], axis);
        }
        for (std::int64_t z = first[2]; z <= last[2]; ++z)
        {
            for (std::int64_t y = first[1]; y <= last[1]; ++y)
            {
                for (std::int64_t x = first[0]; x <= last[0]; ++x)
                {
                    if (ends(static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x)))
                    {
                        return true;
                    }
                }
            }
        }
        return false;
    }
    std::int64_t along(double coordinate, int axis) const
    {
        const double cell = std::floor((coordinate - low_[axis]) * per_mm_);
        const auto last = static_cast<double>(count_[static_cast<std::size_t>(axis)] - 1);
        return static_cast<std::int64_t>(std::clamp(cell, 0.0, last));
    }

    Vec3 low_;
    double per_mm_ = 0.0;
    std::array<std::int64_t, 3> count_{};
    std::vector<std::uint8_t> marked_;
};

} // namespace corticle::contact
