// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/cell_grid.hpp"

#include "corticle/base/box.hpp"

namespace corticle
{

CellGrid::CellGrid(std::span<const Vec3> points, double cell_size) : cell_size_(cell_size)
{
    const Box box = points.empty() ? Box{{}, {}} : bounding_box(points);
    low_ = box.low;
    // More cells than this only cost memory: most would be empty.
    const double most_cells = 16.0 * static_cast<double>(points.size()) + 4096.0;
    const auto cells_along = [&](int axis) { return std::floor(box.size()[axis] / cell_size_) + 1.0; };
    while (cells_along(0) * cells_along(1) * cells_along(2) > most_cells)
    {
        cell_size_ *= 1.2;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        cells_[axis] = static_cast<std::int64_t>(cells_along(axis));
    }
    std::vector<std::int32_t> cell(points.size());
    begin_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const std::array<std::int64_t, 3> c = cell_of(points[i]);
        cell[i] = static_cast<std::int32_t>((c[0] * cells_[1] + c[1]) * cells_[2] + c[2]);
        ++begin_[cell[i] + 1];
    }
    for (std::size_t k = 1; k < begin_.size(); ++k)
    {
        begin_[k] += begin_[k - 1];
    }
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    index_.resize(points.size());
    sorted_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const std::int32_t slot = next[cell[i]]++;
        index_[slot] = static_cast<std::int32_t>(i);
        sorted_[slot] = points[i];
    }
}

} // namespace corticle
