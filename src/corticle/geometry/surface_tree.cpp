// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/surface_tree.hpp"

#include "corticle/base/box.hpp"
#include "corticle/geometry/triangle_tests.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace corticle::geometry
{

namespace
{

constexpr std::int32_t leaf_size = 4;
// The tree halves its ranges, so it is never deeper than 32 levels and a walk never holds more nodes than that.
constexpr int stack_size = 64;

double squared_distance_to_box(const Vec3& p, const Vec3& low, const Vec3& high)
{
    const double dx = std::max({low.x - p.x, p.x - high.x, 0.0});
    const double dy = std::max({low.y - p.y, p.y - high.y, 0.0});
    const double dz = std::max({low.z - p.z, p.z - high.z, 0.0});
    return dx * dx + dy * dy + dz * dz;
}

/// Does a + t d, 0 <= t <= length, meet the box? `inverse` = 1 / d by component, infinite where d is zero.
bool ray_meets_box(const Vec3& a, const Vec3& inverse, double length, const Vec3& low, const Vec3& high)
{
    // Widened by a few units in the last place, so that rounding never loses a triangle on the face of its box.
    constexpr double widen = 1e-14;
    double first = -widen * length;
    double last = length * (1.0 + widen);
    for (int axis = 0; axis < 3; ++axis)
    {
        const double t1 = (low[axis] - a[axis]) * inverse[axis];
        const double t2 = (high[axis] - a[axis]) * inverse[axis];
        // 0 * infinity is NaN: the ray runs in a face of the box, and the axis does not bound it.
        const double near = std::min(t1, t2);
        const double far = std::max(t1, t2);
        first = near > first ? near - widen * std::abs(near) : first;
        last = far < last ? far + widen * std::abs(far) : last;
    }
    return first <= last;
}

std::uint64_t edge_key(std::int32_t a, std::int32_t b)
{
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b));
}

TriangleMesh checked_copy(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    require_vertices(vertices, triangles);
    require_finite("vertices of the surface", vertices);
    return {{vertices.begin(), vertices.end()}, {triangles.begin(), triangles.end()}};
}

} // namespace

SurfaceTree::SurfaceTree(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
    : mesh_(checked_copy(vertices, triangles)), normals_(vertex_normals(vertices, triangles))
{
    compute_edge_normals();
    build();
}

void SurfaceTree::compute_edge_normals()
{
    const auto& x = mesh_.vertices;
    std::unordered_map<std::uint64_t, Vec3> sums;
    sums.reserve(2 * mesh_.triangles.size());
    for (const Triangle& t : mesh_.triangles)
    {
        const Vec3 normal = normalized(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
        for (int k = 0; k < 3; ++k)
        {
            sums[edge_key(t[(k + 1) % 3], t[(k + 2) % 3])] += normal;
        }
    }
    edge_normals_.resize(mesh_.triangles.size());
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f)
    {
        const Triangle& t = mesh_.triangles[f];
        for (int k = 0; k < 3; ++k)
        {
            edge_normals_[f][k] = sums[edge_key(t[(k + 1) % 3], t[(k + 2) % 3])];
        }
    }
}

void SurfaceTree::build()
{
    const std::size_t count = mesh_.triangles.size();
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<Vec3> centres(count);
    for (std::size_t f = 0; f < count; ++f)
    {
        const Triangle& t = mesh_.triangles[f];
        centres[f] = mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]];
    }
    nodes_.reserve(count + 1);
    if (count > 0)
    {
        nodes_.push_back({{}, {}, -1, -1, 0, static_cast<std::int32_t>(count)});
        split(0, centres);
    }
}

void SurfaceTree::split(std::int32_t node, std::span<const Vec3> centres)
{
    const std::int32_t first = nodes_[node].first;
    const std::int32_t count = nodes_[node].count;
    Box around;
    Box around_centres;
    for (std::int32_t k = first; k < first + count; ++k)
    {
        for (const std::int32_t vertex : mesh_.triangles[order_[k]])
        {
            around.include(mesh_.vertices[vertex]);
        }
        around_centres.include(centres[order_[k]]);
    }
    nodes_[node].low = around.low;
    nodes_[node].high = around.high;
    if (count <= leaf_size)
    {
        return;
    }
    const int axis = around_centres.longest_axis();
    const std::int32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count,
                     [&](std::int32_t a, std::int32_t b)
                     {
                         const double ca = centres[a][axis];
                         const double cb = centres[b][axis];
                         return ca < cb || (ca == cb && a < b);
                     });
    const auto left = static_cast<std::int32_t>(nodes_.size());
    nodes_[node].left = left;
    nodes_[node].right = left + 1;
    nodes_.push_back({{}, {}, -1, -1, first, half});
    nodes_.push_back({{}, {}, -1, -1, first + half, count - half});
    split(left, centres);
    split(left + 1, centres);
}

void SurfaceTree::improve(std::int32_t triangle, const Vec3& point, SurfacePoint& best) const
{
    const SurfacePoint candidate = closest_point_of_triangle(mesh_, triangle, point);
    const bool nearer = candidate.squared_distance < best.squared_distance;
    const bool tie = candidate.squared_distance == best.squared_distance;
    if (nearer || (tie && (best.triangle < 0 || triangle < best.triangle)))
    {
        best = candidate;
    }
}

SurfacePoint SurfaceTree::closest(const Vec3& point) const
{
    return closest_within(point, std::numeric_limits<double>::infinity());
}

SurfacePoint SurfaceTree::closest_within(const Vec3& point, double reach) const
{
    SurfacePoint best;
    best.squared_distance = reach * reach;
    if (nodes_.empty())
    {
        return best;
    }
    struct Entry
    {
        std::int32_t node;
        double squared_distance;
    };
    std::array<Entry, stack_size> stack;
    int top = 0;
    stack[top++] = {0, squared_distance_to_box(point, nodes_[0].low, nodes_[0].high)};
    while (top > 0)
    {
        const Entry entry = stack[--top];
        if (entry.squared_distance > best.squared_distance)
        {
            continue;
        }
        const Node& node = nodes_[entry.node];
        if (node.left < 0)
        {
            for (std::int32_t k = node.first; k < node.first + node.count; ++k)
            {
                improve(order_[k], point, best);
            }
            continue;
        }
        Entry near{node.left, squared_distance_to_box(point, nodes_[node.left].low, nodes_[node.left].high)};
        Entry far{node.right, squared_distance_to_box(point, nodes_[node.right].low, nodes_[node.right].high)};
        if (far.squared_distance < near.squared_distance)
        {
            std::swap(near, far);
        }
        stack[top++] = far;
        stack[top++] = near;
    }
    return best;
}

Vec3 SurfaceTree::interpolated_normal(const SurfacePoint& point) const
{
    const Triangle& t = mesh_.triangles[point.triangle];
    const Vec3 normal = point.barycentric[0] * normals_[t[0]] + point.barycentric[1] * normals_[t[1]] +
                        point.barycentric[2] * normals_[t[2]];
    return normalized(normal);
}

Vec3 SurfaceTree::pseudonormal(const SurfacePoint& foot) const
{
    const Triangle& t = mesh_.triangles[foot.triangle];
    const auto& w = foot.barycentric;
    const int zeros = (w[0] == 0.0) + (w[1] == 0.0) + (w[2] == 0.0);
    if (zeros == 2)
    {
        return normals_[t[w[0] != 0.0 ? 0 : (w[1] != 0.0 ? 1 : 2)]];
    }
    if (zeros == 1)
    {
        return edge_normals_[foot.triangle][w[0] == 0.0 ? 0 : (w[1] == 0.0 ? 1 : 2)];
    }
    const auto& x = mesh_.vertices;
    return cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
}

double SurfaceTree::signed_distance(const Vec3& point) const
{
    return signed_distance(point, closest(point));
}

double SurfaceTree::signed_distance(const Vec3& point, const SurfacePoint& foot) const
{
    if (foot.triangle < 0)
    {
        return std::numeric_limits<double>::infinity();
    }
    const double distance = std::sqrt(foot.squared_distance);
    return dot(point - foot.position, pseudonormal(foot)) < 0.0 ? -distance : distance;
}

bool SurfaceTree::segment_crosses(const Vec3& a, const Vec3& b) const
{
    if (nodes_.empty())
    {
        return false;
    }
    const Vec3 d = b - a;
    const Vec3 inverse{1.0 / d.x, 1.0 / d.y, 1.0 / d.z};
    std::array<std::int32_t, stack_size> stack;
    int top = 0;
    stack[top++] = 0;
    while (top > 0)
    {
        const Node& node = nodes_[stack[--top]];
        if (!ray_meets_box(a, inverse, 1.0, node.low, node.high))
        {
            continue;
        }
        if (node.left >= 0)
        {
            stack[top++] = node.right;
            stack[top++] = node.left;
            continue;
        }
        for (std::int32_t k = node.first; k < node.first + node.count; ++k)
        {
            if (segment_meets_triangle(mesh_, order_[k], a, b))
            {
                return true;
            }
        }
    }
    return false;
}

} // namespace corticle::geometry
