// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/orientation.hpp"

#include "corticle/base/box.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace corticle::imaging
{

namespace
{

using Axes = std::array<int, 3>;

/// The axis of the scanner that each axis of an image follows: the assignment with the largest cosines.
Axes nearest_axes(const VoxelFrame& frame)
{
    constexpr std::array<Axes, 6> assignments{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    const Vec3 edges = voxel_edges(frame);
    Axes best = assignments.front();
    double most = -1.0;
    for (const Axes& axes : assignments)
    {
        double sum = 0.0;
        for (int column = 0; column < 3; ++column)
        {
            const int row = axes[static_cast<std::size_t>(column)];
            sum += std::abs(frame.linear(row, column)) / edges[column];
        }
        if (sum > most + 1e-9)
        {
            most = sum;
            best = axes;
        }
    }
    return best;
}

} // namespace

std::string orientation_of(const VoxelFrame& frame)
{
    const Axes axes = nearest_axes(frame);
    std::string letters;
    for (int column = 0; column < 3; ++column)
    {
        const int row = axes[static_cast<std::size_t>(column)];
        const std::size_t sense = frame.linear(row, column) > 0.0 ? 0 : 1;
        constexpr std::array<std::array<char, 2>, 3> names{{{'R', 'L'}, {'A', 'P'}, {'S', 'I'}}};
        letters += names[static_cast<std::size_t>(row)][sense];
    }
    return letters;
}

std::string describe(const LabelVolume& image)
{
    const Vec3 edges = voxel_edges(image.frame);
    return fmt::format("image of {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, orientation {}", image.size[0],
                       image.size[1], image.size[2], edges.x, edges.y, edges.z, orientation_of(image.frame));
}

std::string describe_place(std::span<const Vec3> points)
{
    const Box box = bounding_box(points);
    const double tolerance = 0.02 * box.size().x; // a hemisphere may cross the middle by that
    const char* const side = box.low.x >= -tolerance   ? "right of x = 0"
                             : box.high.x <= tolerance ? "left of x = 0"
                                                       : "on both sides of x = 0";
    return fmt::format("the body lies at x {:.4g} to {:.4g}, y {:.4g} to {:.4g}, z {:.4g} to {:.4g} mm (x to the "
                       "right, y forward, z up): {}",
                       box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z, side);
}

} // namespace corticle::imaging
