// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/curved_surface.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mesh/sizes.hpp"

#include <array>

namespace corticle::metrics
{

namespace
{

/// Of the angle between edge and tangent plane. Below it no arc of a circle is meant but a crease: the end of the edge
/// loses its tangent as the normal comes to lie along it.
constexpr double least_cosine = 0.5;

struct QuadraturePoint
{
    std::array<double, 3> at; ///< barycentric coordinates
    double weight;            ///< of the area of the triangle
};

/// The rule of degree 8 of Dunavant 1985 (International Journal for Numerical Methods in Engineering 21): exact for the
/// volume under a cubic patch, a polynomial of degree 7.
constexpr std::array<QuadraturePoint, 16> quadrature_rule()
{
    std::array<QuadraturePoint, 16> rule{};
    std::size_t count = 0;
    const auto add = [&](double a, double b, double c, double weight) { rule[count++] = {{a, b, c}, weight}; };
    add(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.144315607677787);
    for (const auto& [a, b, weight] : {std::array{0.081414823414554, 0.459292588292723, 0.095091634267285},
                                       std::array{0.658861384496480, 0.170569307751760, 0.103217370534718},
                                       std::array{0.898905543365938, 0.050547228317031, 0.032458497623198}})
    {
        add(a, b, b, weight);
        add(b, a, b, weight);
        add(b, b, a, weight);
    }
    constexpr double a = 0.008394777409958;
    constexpr double b = 0.263112829634638;
    constexpr double c = 0.728492392955404;
    constexpr double weight = 0.027230314174435;
    add(a, b, c, weight);
    add(b, c, a, weight);
    add(c, a, b, weight);
    add(a, c, b, weight);
    add(b, a, c, weight);
    add(c, b, a, weight);
    return rule;
}
constexpr auto rule = quadrature_rule();

/// A cubic triangle of Bezier: corners, two points along each edge, one in the middle. As the PN triangles of Vlachos
/// et al. 2001 (Symposium on Interactive 3D Graphics) but for the edges.
struct Patch
{
    std::array<Vec3, 3> corner;
    std::array<Vec3, 3> leaving;  ///< next to the corner, on the edge towards the next corner
    std::array<Vec3, 3> arriving; ///< next to the corner, on the edge from the corner before
    Vec3 middle;
};

/// Unit vertex normals with the weights of Max 1999 (Journal of Graphics Tools 4): exact on spheres, whatever the
/// triangles, and of second order elsewhere, where angles as weights are of first.
std::vector<Vec3> sphere_normals(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    std::vector<Vec3> normals(vertices.size());
    for (const Triangle& t : triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            const Vec3 next = vertices[t[(k + 1) % 3]] - vertices[t[k]];
            const Vec3 last = vertices[t[(k + 2) % 3]] - vertices[t[k]];
            const double squares = squared_norm(next) * squared_norm(last);
            normals[t[k]] += squares > 0.0 ? cross(next, last) / squares : Vec3{};
        }
    }
    for (Vec3& normal : normals)
    {
        normal = normalized(normal);
    }
    return normals;
}

/// Point of the edge from a to b next to a, in the plane tangent at a: so far from a that the edge is an arc of a
/// circle where the normal at b mirrors that at a (Goldapp 1991, Computer Aided Geometric Design 8).
Vec3 edge_point(const Vec3& a, const Vec3& b, const Vec3& normal)
{
    const Vec3 way = b - a;
    const Vec3 along = way - dot(way, normal) * normal;
    const double squared_length = squared_norm(way);
    if (squared_length == 0.0)
    {
        return a;
    }
    const double cosine = std::max(least_cosine, norm(along) / std::sqrt(squared_length));
    return a + 2.0 / (3.0 * cosine * (1.0 + cosine)) * along;
}

Patch patch_of(const std::array<Vec3, 3>& corner, const std::array<Vec3, 3>& normal)
{
    Patch p{corner, {}, {}, {}};
    Vec3 edges;
    for (int k = 0; k < 3; ++k)
    {
        p.leaving[k] = edge_point(corner[k], corner[(k + 1) % 3], normal[k]);
        p.arriving[k] = edge_point(corner[k], corner[(k + 2) % 3], normal[k]);
        edges += p.leaving[k] + p.arriving[k];
    }
    // So a patch whose edges belong to a quadratic surface is that surface.
    p.middle = edges / 4.0 - (corner[0] + corner[1] + corner[2]) / 6.0;
    return p;
}

struct Place
{
    Vec3 x;
    Vec3 area; ///< cross product of the derivatives: twice the area of the triangle as it is stretched here
};

Place place_on(const Patch& p, const std::array<double, 3>& at)
{
    // de Casteljau: the points of the three quadratic parts, of which the derivatives are differences.
    std::array<Vec3, 3> part;
    for (int k = 0; k < 3; ++k)
    {
        const int l = (k + 1) % 3;
        const int m = (k + 2) % 3;
        part[k] = at[k] * at[k] * p.corner[k] + at[l] * at[l] * p.arriving[l] + at[m] * at[m] * p.leaving[m] +
                  2.0 * (at[k] * at[l] * p.leaving[k] + at[k] * at[m] * p.arriving[k] + at[l] * at[m] * p.middle);
    }
    return {at[0] * part[0] + at[1] * part[1] + at[2] * part[2], 9.0 * cross(part[1] - part[0], part[2] - part[0])};
}

CurvedSize size_of(const Patch& patch)
{
    CurvedSize size;
    for (const QuadraturePoint& point : rule)
    {
        const auto [x, area] = place_on(patch, point.at);
        size.area_mm2 += 0.5 * point.weight * norm(area);
        size.volume_mm3 += point.weight * dot(x, area) / 6.0;
    }
    return size;
}

} // namespace

CurvedSize curved_size(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    require_triangles(vertices, triangles);
    const std::vector<Vec3> normals = sphere_normals(vertices, triangles);
    const Vec3 apex = vertices[triangles[0][0]]; // no cancellation for a surface far from the origin
    return parallel_reduce(
        std::ssize(triangles), CurvedSize{},
        [&](std::int64_t begin, std::int64_t end)
        {
            CurvedSize sum;
            for (std::int64_t k = begin; k < end; ++k)
            {
                const auto [a, b, c] = triangles[k];
                const CurvedSize size = size_of(patch_of({vertices[a] - apex, vertices[b] - apex, vertices[c] - apex},
                                                         {normals[a], normals[b], normals[c]}));
                sum.area_mm2 += size.area_mm2;
                sum.volume_mm3 += size.volume_mm3;
            }
            return sum;
        },
        [](CurvedSize& total, const CurvedSize& part)
        {
            total.area_mm2 += part.area_mm2;
            total.volume_mm3 += part.volume_mm3;
        });
}

} // namespace corticle::metrics
