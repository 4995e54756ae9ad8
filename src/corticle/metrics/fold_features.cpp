// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_features.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/surface/curvature.hpp"
#include "corticle/metrics/surface/sulcal_pits.hpp"
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::metrics
{

namespace
{

constexpr double ridge_height_mm = 1.0;     ///< between sulcal pits of fetal brains
constexpr double smoothing_length_mm = 2.0; ///< of the mean curvature: waves much shorter are no folds

/// Mean over neighbours, again and again: a Gaussian along the surface of about this standard deviation.
std::vector<double> smoothed(const SurfaceView& surface, std::vector<double> values, double length)
{
    const VertexLists adjacent = adjacent_vertices(surface.vertices.size(), surface.triangles);
    const double edge = std::sqrt(2.31 * surface_area(surface.vertices, surface.triangles) /
                                  static_cast<double>(surface.triangles.size())); // of equilateral triangles
    const int rounds = static_cast<int>(std::ceil(2.0 * std::pow(length / edge, 2)));
    std::vector<double> next(values.size());
    for (int round = 0; round < rounds; ++round)
    {
        for (std::int32_t v = 0; v < adjacent.size(); ++v)
        {
            double sum = values[v];
            for (const std::int32_t other : adjacent.of(v))
            {
                sum += values[other];
            }
            next[v] = sum / static_cast<double>(adjacent.of(v).size() + 1);
        }
        values.swap(next);
    }
    return values;
}

/// Distance of vertices to the nearest plane of the convex hull [mm].
std::vector<double> hull_depth(std::span<const Vec3> vertices)
{
    const TriangleMesh hull = geometry::convex_hull(vertices);
    std::vector<Vec3> normals;
    std::vector<double> offsets;
    for (const Triangle& t : hull.triangles)
    {
        const Vec3& a = hull.vertices[t[0]];
        normals.push_back(normalized(cross(hull.vertices[t[1]] - a, hull.vertices[t[2]] - a)));
        offsets.push_back(dot(normals.back(), a));
    }
    std::vector<double> depth(vertices.size());
    parallel_for(std::ssize(vertices),
                 [&](std::int64_t v)
                 {
                     double least = std::numeric_limits<double>::infinity();
                     for (std::size_t k = 0; k < normals.size(); ++k)
                     {
                         least = std::min(least, offsets[k] - dot(normals[k], vertices[v]));
                     }
                     depth[v] = std::max(0.0, least);
                 });
    return depth;
}

} // namespace

FoldFeatures fold_features(const SurfaceView& surface)
{
    FoldFeatures result;
    result.depth = hull_depth(surface.vertices);
    result.curvature =
        smoothed(surface, vertex_curvature(surface.vertices, surface.triangles).mean, smoothing_length_mm);
    for (const std::int32_t pit : depth_extrema(result.depth, surface.triangles, ridge_height_mm).pits)
    {
        result.pits.push_back(surface.vertices[pit]);
    }
    return result;
}

std::vector<double> taken_out(std::span<const double> values, std::span<const double> known,
                              std::span<const double> weights)
{
    const auto size_of = [](double k) { return std::abs(k); };
    const double scale = std::max(1e-300, size_of(*std::ranges::max_element(known, {}, size_of)));
    const auto powers = [&](std::size_t v)
    {
        const double k = known[v] / scale;
        return Eigen::Vector4d(1.0, k, k * k, k * k * k);
    };
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    for (std::size_t v = 0; v < values.size(); ++v)
    {
        const Eigen::Vector4d p = powers(v);
        A += weights[v] * p * p.transpose();
        b += weights[v] * values[v] * p;
    }
    const Eigen::Vector4d c = A.completeOrthogonalDecomposition().solve(b);
    std::vector<double> rest(values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
    {
        rest[v] = values[v] - c.dot(powers(v));
    }
    return rest;
}

double correlation(std::span<const double> a, std::span<const double> b, std::span<const double> weights)
{
    double total = 0.0;
    double mean_a = 0.0;
    double mean_b = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v)
    {
        total += weights[v];
        mean_a += weights[v] * a[v];
        mean_b += weights[v] * b[v];
    }
    mean_a /= total;
    mean_b /= total;
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v)
    {
        aa += weights[v] * (a[v] - mean_a) * (a[v] - mean_a);
        bb += weights[v] * (b[v] - mean_b) * (b[v] - mean_b);
        ab += weights[v] * (a[v] - mean_a) * (b[v] - mean_b);
    }
    return aa * bb <= 1e-24 * total * total ? 0.0 : ab / std::sqrt(aa * bb); // NaN stays NaN
}

double sulcal_dice(std::span<const double> a, std::span<const double> b, std::span<const double> weights)
{
    double common = 0.0;
    double sum = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v)
    {
        common += a[v] < 0.0 && b[v] < 0.0 ? weights[v] : 0.0;
        sum += (a[v] < 0.0 ? weights[v] : 0.0) + (b[v] < 0.0 ? weights[v] : 0.0);
    }
    return sum > 0.0 ? 2.0 * common / sum : 0.0;
}

} // namespace corticle::metrics
