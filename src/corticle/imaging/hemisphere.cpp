// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/hemisphere.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace corticle::imaging
{

namespace
{

/// The mask on one side of a plane: its normal's for +1.
Mask side_of(const VoxelGrid& grid, const Mask& mask, const Plane& plane, double side)
{
    Mask half(mask.size(), 0);
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        const bool is_there = side * (dot(plane.normal, grid.position(voxel)) - plane.offset) >= 0.0;
        half[voxel] = is_there ? mask[voxel] : 0;
    }
    return half;
}

/// Where a mask lies along x and y [mm].
struct Place
{
    double mean_x[2] = {0.0, 0.0}; ///< of what is left and right of the plane
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0.0};
    Vec3 high = -low;
};

Place place_of(const VoxelGrid& grid, const Mask& mask, const Plane& plane)
{
    Place place;
    double count[2] = {0.0, 0.0};
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        if (mask[voxel] != 1)
        {
            continue;
        }
        const Vec3 x = grid.position(voxel);
        const int side = dot(plane.normal, x) >= plane.offset ? 1 : 0;
        place.mean_x[side] += x.x;
        count[side] += 1.0;
        for (const int axis : {0, 1})
        {
            place.low[axis] = std::min(place.low[axis], x[axis]);
            place.high[axis] = std::max(place.high[axis], x[axis]);
        }
    }
    for (const int side : {0, 1})
    {
        place.mean_x[side] /= std::max(count[side], 1.0);
    }
    return place;
}

} // namespace

void keep_largest_of_each_side(const VoxelGrid& grid, Mask& mask)
{
    const Plane plane = midsagittal_plane(grid, mask);
    Mask seeds = side_of(grid, mask, plane, -1.0);
    keep_largest_component(grid, seeds);
    Mask right = side_of(grid, mask, plane, 1.0);
    keep_largest_component(grid, right);
    std::transform(seeds.begin(), seeds.end(), right.begin(), seeds.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
    keep_components_of(grid, seeds, mask);
}

void require_both_hemispheres(const GridMask& body, const Plane& plane, std::string_view hemisphere,
                              std::vector<std::string>& warnings)
{
    require_voxels(body.grid, "mask", body.mask.size());
    const Place place = place_of(body.grid, body.mask, plane);
    const auto lie_beside = [&](double x) { return (place.mean_x[0] - x) * (place.mean_x[1] - x) > 0.0; };
    if (!lie_beside(0.0))
    {
        return;
    }
    constexpr double narrow = 0.65; // of the length: a hemisphere has about 0.4, a brain 0.8
    const Vec3 size = place.high - place.low;
    const std::string where = fmt::format("the mask lies {} of the scanner's x = 0 (x from {:.4g} to {:.4g} mm)",
                                          place.mean_x[0] > 0.0 ? "right" : "left", place.low.x, place.high.x);
    if (lie_beside(body.middle_x) || size.x < narrow * size.y)
    {
        throw InputError(
            fmt::format("hemisphere = \"{}\": {} and seems to be one hemisphere already; expected a mask of "
                        "both, or hemisphere = \"both\" to take it whole",
                        hemisphere, where));
    }
    warnings.push_back(
        fmt::format("{}: the origin of the image is not between the hemispheres; they were distinguished by "
                    "the direction of x",
                    where));
}

} // namespace corticle::imaging
