// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <cmath>
#include <functional>

namespace corticle
{

/// A rotation about a skew axis [rad] (Rodrigues).
inline Mat3 skew_rotation(double angle)
{
    const Vec3 n = normalized({1.0, -2.0, 0.7});
    const Mat3 cross_n{{{0, n.z, -n.y}, {-n.z, 0, n.x}, {n.y, -n.x, 0}}};
    return Mat3::identity() + std::sin(angle) * cross_n + (1.0 - std::cos(angle)) * (cross_n * cross_n);
}

/// An image of voxels with the given edges (their directions are the columns of `axes`) about a centre [mm] that
/// reaches `reach` [mm] along each axis, labelled by a function of the place relative to the centre.
inline imaging::LabelVolume label_image(const Mat3& axes, const Vec3& edges, const Vec3& centre, double reach,
                                        const std::function<std::int32_t(const Vec3&)>& label)
{
    imaging::LabelVolume image;
    image.frame.linear = axes * Mat3::diagonal(edges.x, edges.y, edges.z);
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis)
    {
        image.size[axis] = 2 * static_cast<std::int64_t>(std::ceil(reach / edges[axis])) + 1;
        middle[axis] = 0.5 * static_cast<double>(image.size[axis] - 1) + 0.37; // no voxel at the very centre
    }
    image.frame.origin = centre - image.frame.linear * middle;
    for (std::int64_t z = 0; z < image.size[2]; ++z)
    {
        for (std::int64_t y = 0; y < image.size[1]; ++y)
        {
            for (std::int64_t x = 0; x < image.size[0]; ++x)
            {
                const Vec3 index{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                image.labels.push_back(label(image.frame.position(index) - centre));
            }
        }
    }
    return image;
}

/// Below 1 inside the ellipsoid of these semi-axes.
inline double ellipsoid(const Vec3& p, const Vec3& semi_axes)
{
    return norm({p.x / semi_axes.x, p.y / semi_axes.y, p.z / semi_axes.z});
}

/// Distance to a circle about z.
inline double ring_distance(const Vec3& p, double radius)
{
    return std::hypot(std::hypot(p.x, p.y) - radius, p.z);
}

} // namespace corticle
