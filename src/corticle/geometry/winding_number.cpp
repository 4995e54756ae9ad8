// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/geometry/triangle_tests.hpp"

#include <algorithm>

namespace corticle::geometry
{

namespace
{

// Directions with no rational relation between their components; the later ones serve where a ray meets an edge.
constexpr std::array<Vec3, 5> directions{{{0.577312893, 0.211324871, 0.788675139},
                                          {-0.707106781, 0.618033989, 0.343559201},
                                          {0.301029996, -0.848048096, 0.434294482},
                                          {0.693147181, 0.314159265, -0.648721271},
                                          {-0.271828183, -0.523598776, -0.807354922}}};

/// Does the ray from `point` meet the box? All components of the direction differ from zero.
bool ray_meets_box(const Vec3& point, const Vec3& inverse, const Vec3& low, const Vec3& high)
{
    constexpr double widen = 1e-14;
    const double x1 = (low.x - point.x) * inverse.x;
    const double x2 = (high.x - point.x) * inverse.x;
    const double y1 = (low.y - point.y) * inverse.y;
    const double y2 = (high.y - point.y) * inverse.y;
    const double z1 = (low.z - point.z) * inverse.z;
    const double z2 = (high.z - point.z) * inverse.z;
    const double first = std::max({std::min(x1, x2), std::min(y1, y2), std::min(z1, z2), 0.0});
    const double last = std::min({std::max(x1, x2), std::max(y1, y2), std::max(z1, z2)});
    return first <= last + widen * std::abs(last);
}

} // namespace

int SurfaceTree::winding_number(const Vec3& point) const
{
    int crossings = 0;
    for (const Vec3& direction : directions)
    {
        if (count_crossings(point, direction, crossings))
        {
            break;
        }
    }
    return crossings;
}

/// Signed crossings of one ray; false where the ray met an edge.
bool SurfaceTree::count_crossings(const Vec3& point, const Vec3& direction, int& crossings) const
{
    crossings = 0;
    bool clean = true;
    const Vec3 inverse{1.0 / direction.x, 1.0 / direction.y, 1.0 / direction.z};
    std::array<std::int32_t, 64> stack;
    int top = 0;
    if (!nodes_.empty())
    {
        stack[top++] = 0;
    }
    while (top > 0)
    {
        const Node& node = nodes_[stack[--top]];
        if (!ray_meets_box(point, inverse, node.low, node.high))
        {
            continue;
        }
        if (node.left >= 0)
        {
            stack[top++] = node.left;
            stack[top++] = node.right;
            continue;
        }
        for (std::int32_t k = node.first; k < node.first + node.count; ++k)
        {
            const RayHit hit = ray_hit(mesh_, order_[k], point, direction);
            crossings += (hit == RayHit::outward) - (hit == RayHit::inward);
            clean = clean && hit != RayHit::degenerate;
        }
    }
    return clean;
}

} // namespace corticle::geometry
