// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace corticle
{

/// An axis-aligned box [mm]; it holds nothing until something is included.
struct Box
{
    static constexpr double beyond = std::numeric_limits<double>::infinity();

    Vec3 low{beyond, beyond, beyond};
    Vec3 high{-beyond, -beyond, -beyond};

    void include(const Vec3& point)
    {
        low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
    }
    Vec3 center() const { return 0.5 * (low + high); }
    Vec3 size() const { return high - low; }
    /// Axis of the longest edge, the first of several as long.
    int longest_axis() const
    {
        const Vec3 edge = size();
        return edge.x >= edge.y && edge.x >= edge.z ? 0 : (edge.y >= edge.z ? 1 : 2);
    }
    /// Half of the longest edge [mm].
    double half_width() const { return 0.5 * size()[longest_axis()]; }
};

/// The smallest box around points [mm].
inline Box bounding_box(std::span<const Vec3> points)
{
    Box box;
    for (const Vec3& point : points)
    {
        box.include(point);
    }
    return box;
}

} // namespace corticle
