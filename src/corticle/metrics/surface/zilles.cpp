// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/zilles.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::metrics
{

namespace
{

using Point = std::array<double, 2>; ///< in the plane of a slice [mm]
using Segment = std::array<Point, 2>;

double turn(const Point& o, const Point& a, const Point& b)
{
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

double distance(const Point& a, const Point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Perimeter of the convex hull of points in a plane (monotone chains; Andrew 1979) [mm].
double hull_perimeter(std::vector<Point>& points)
{
    std::sort(points.begin(), points.end());
    std::vector<Point> chain;
    double perimeter = 0.0;
    for (int side = 0; side < 2; ++side)
    {
        chain.clear();
        for (const Point& p : points)
        {
            while (chain.size() >= 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0.0)
            {
                chain.pop_back();
            }
            chain.push_back(p);
        }
        for (std::size_t k = 1; k < chain.size(); ++k)
        {
            perimeter += distance(chain[k - 1], chain[k]);
        }
        std::reverse(points.begin(), points.end());
    }
    return perimeter;
}

/// The body laid into the frame of the slices.
struct Frame
{
    std::vector<double> height; ///< along the normal, of each vertex [mm]
    std::vector<Point> flat;    ///< across it
    double low = 0.0;
    double spacing = 0.0;
    int count = 0;

    double plane(std::int64_t slice) const { return low + (static_cast<double>(slice) + 0.5) * spacing; }
};

Frame make_frame(std::span<const Vec3> vertices, const SliceOptions& options)
{
    const Vec3 n = normalized(options.normal);
    if (!(norm(n) > 0.0) || options.count < 1)
    {
        throw InputError(fmt::format("slices: got {} of them across ({:g}, {:g}, {:g}); expected at least 1 and a "
                                     "direction",
                                     options.count, options.normal.x, options.normal.y, options.normal.z));
    }
    const Vec3 e1 = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 e2 = cross(n, e1);
    Frame frame;
    frame.count = options.count;
    for (const Vec3& v : vertices)
    {
        frame.height.push_back(dot(v, n));
        frame.flat.push_back({dot(v, e1), dot(v, e2)});
    }
    if (!vertices.empty())
    {
        const auto [low, high] = std::minmax_element(frame.height.begin(), frame.height.end());
        frame.low = *low;
        frame.spacing = (*high - *low) / options.count;
    }
    return frame;
}

/// Where a plane that a triangle straddles cuts it.
Segment cut(const Frame& frame, const Triangle& triangle, double plane)
{
    Segment ends{};
    int found = 0;
    for (int k = 0; k < 3 && found < 2; ++k)
    {
        const std::int32_t a = triangle[k];
        const std::int32_t b = triangle[(k + 1) % 3];
        if ((frame.height[a] < plane) != (frame.height[b] < plane))
        {
            const double s = (plane - frame.height[a]) / (frame.height[b] - frame.height[a]);
            ends[found++] = {frame.flat[a][0] + s * (frame.flat[b][0] - frame.flat[a][0]),
                             frame.flat[a][1] + s * (frame.flat[b][1] - frame.flat[a][1])};
        }
    }
    return ends;
}

std::vector<std::vector<Segment>> cut_all(const Frame& frame, std::span<const Triangle> triangles)
{
    std::vector<std::vector<Segment>> slices(frame.count);
    for (const Triangle& t : triangles)
    {
        const auto [low, high] = std::minmax({frame.height[t[0]], frame.height[t[1]], frame.height[t[2]]});
        const auto first = static_cast<int>(std::max(0.0, std::floor((low - frame.low) / frame.spacing - 0.5)));
        for (int k = first; k < frame.count && frame.plane(k) <= high; ++k)
        {
            if (low < frame.plane(k))
            {
                slices[k].push_back(cut(frame, t, frame.plane(k)));
            }
        }
    }
    return slices;
}

} // namespace

SliceGyrification zilles_index(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                               const SliceOptions& options)
{
    const Frame frame = make_frame(vertices, options);
    SliceGyrification result;
    if (!(frame.spacing > 0.0))
    {
        return result;
    }
    double whole_sum = 0.0;
    double outer_sum = 0.0;
    std::vector<Point> points;
    for (const std::vector<Segment>& slice : cut_all(frame, triangles))
    {
        points.clear();
        double whole = 0.0;
        for (const Segment& s : slice)
        {
            whole += distance(s[0], s[1]);
            points.insert(points.end(), s.begin(), s.end());
        }
        const double outer = hull_perimeter(points);
        if (outer > 0.0)
        {
            whole_sum += whole;
            outer_sum += outer;
            result.mean_of_slices += whole / outer;
            ++result.slices;
        }
    }
    if (result.slices > 0)
    {
        result.index = whole_sum / outer_sum;
        result.mean_of_slices /= result.slices;
    }
    return result;
}

} // namespace corticle::metrics
