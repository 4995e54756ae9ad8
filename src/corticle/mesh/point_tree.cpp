// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/point_tree.hpp"

#include "corticle/base/box.hpp"

#include <algorithm>

namespace corticle
{

namespace
{

/// Puts a value into an ascending list and drops the largest.
void insert(std::span<double> ascending, double value)
{
    std::size_t slot = ascending.size();
    while (slot > 0 && ascending[slot - 1] > value)
    {
        --slot;
        if (slot + 1 < ascending.size())
        {
            ascending[slot + 1] = ascending[slot];
        }
    }
    if (slot < ascending.size())
    {
        ascending[slot] = value;
    }
}

} // namespace

PointTree::PointTree(std::span<const Vec3> points) : points_(points.begin(), points.end()), axis_(points.size())
{
    build(0, std::ssize(points_));
}

void PointTree::build(std::int64_t begin, std::int64_t end)
{
    if (end - begin <= leaf)
    {
        return;
    }
    const std::int64_t middle = begin + (end - begin) / 2;
    const int axis = bounding_box(std::span(points_).subspan(begin, end - begin)).longest_axis();
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    build(begin, middle);
    build(middle + 1, end);
}

void PointTree::search(std::int64_t begin, std::int64_t end, const Vec3& place, std::span<double> nearest) const
{
    if (end - begin <= leaf)
    {
        for (std::int64_t k = begin; k < end; ++k)
        {
            insert(nearest, squared_norm(points_[k] - place));
        }
        return;
    }
    const std::int64_t middle = begin + (end - begin) / 2;
    const int axis = axis_[middle];
    const double beyond = place[axis] - points_[middle][axis];
    insert(nearest, squared_norm(points_[middle] - place));
    const bool low_first = beyond < 0.0;
    search(low_first ? begin : middle + 1, low_first ? middle : end, place, nearest);
    if (beyond * beyond < nearest.back())
    {
        search(low_first ? middle + 1 : begin, low_first ? end : middle, place, nearest);
    }
}

} // namespace corticle
