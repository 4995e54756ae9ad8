// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_pattern.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/polar.hpp"
#include "corticle/geometry/hull.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/surface/curvature.hpp"
#include "corticle/metrics/surface/sulcal_pits.hpp"
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

namespace corticle::metrics
{

namespace
{

constexpr int alignment_rounds = 40;
constexpr std::size_t alignment_points = 4000;
constexpr double ridge_height_mm = 1.0;     ///< between sulcal pits of fetal brains
constexpr double smoothing_length_mm = 2.0; ///< of the mean curvature: waves much shorter are no folds

/// What is known at the vertices of a surface.
struct Features
{
    std::vector<double> depth;     ///< below the convex hull [mm]
    std::vector<double> curvature; ///< mean, smoothed [1/mm]
    std::vector<Vec3> pits;
};

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

Features features_of(const SurfaceView& surface)
{
    Features result;
    result.depth = hull_depth(surface.vertices);
    result.curvature =
        smoothed(surface, vertex_curvature(surface.vertices, surface.triangles).mean, smoothing_length_mm);
    for (const std::int32_t pit : depth_extrema(result.depth, surface.triangles, ridge_height_mm).pits)
    {
        result.pits.push_back(surface.vertices[pit]);
    }
    return result;
}

Vec3 centroid_of(std::span<const Vec3> points)
{
    return std::accumulate(points.begin(), points.end(), Vec3{}) / static_cast<double>(points.size());
}

/// Every so manieth point.
std::vector<Vec3> some_of(std::span<const Vec3> points)
{
    std::vector<Vec3> some;
    const std::size_t step = std::max<std::size_t>(1, points.size() / alignment_points);
    for (std::size_t k = 0; k < points.size(); k += step)
    {
        some.push_back(points[k]);
    }
    return some;
}

/// The turn and shift that brings points nearest to their partners (Kabsch).
Similarity best_motion(std::span<const Vec3> points, std::span<const Vec3> partners)
{
    const Vec3 from = centroid_of(points);
    const Vec3 to = centroid_of(partners);
    Mat3 covariance{};
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        covariance = covariance + outer(partners[k] - to, points[k] - from);
    }
    Similarity motion;
    motion.rotation = determinant(covariance) > 0.0 ? polar_rotation(covariance) : Mat3::identity();
    motion.shift = to - motion.rotation * from;
    return motion;
}

/// Values of a surface at the points of another, from the closest point.
class Carrier
{
  public:
    Carrier(const SurfaceView& surface, std::vector<Vec3> places, std::span<const Vec3> target)
        : places_(std::move(places)), triangles_(surface.triangles), feet_(target.size())
    {
        const geometry::SurfaceTree tree(places_, surface.triangles);
        parallel_for(std::ssize(target), [&](std::int64_t v) { feet_[v] = tree.closest(target[v]); });
    }

    std::vector<double> carry(std::span<const double> values) const
    {
        std::vector<double> result(feet_.size());
        for (std::size_t v = 0; v < feet_.size(); ++v)
        {
            const Triangle& corners = triangles_[static_cast<std::size_t>(feet_[v].triangle)];
            for (std::size_t k = 0; k < 3; ++k)
            {
                result[v] += feet_[v].barycentric[k] * values[static_cast<std::size_t>(corners[k])];
            }
        }
        return result;
    }

  private:
    std::vector<Vec3> places_;
    std::span<const Triangle> triangles_;
    std::vector<geometry::SurfacePoint> feet_;
};

/// What a cubic polynomial of `known` does not explain; weighted with area.
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

/// Pearson's, weighted with area; 0 where one side is constant.
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

double share_near(std::span<const Vec3> real, std::span<const Vec3> predicted, double distance)
{
    const auto is_near = [&](const Vec3& pit)
    { return std::ranges::any_of(predicted, [&](const Vec3& p) { return norm(p - pit) <= distance; }); };
    return real.empty() ? 0.0
                        : static_cast<double>(std::ranges::count_if(real, is_near)) / static_cast<double>(real.size());
}

/// The real surface and what the first body says at its vertices.
struct Truth
{
    const SurfaceView& surface;
    Features features;
    std::vector<double> weights;
    std::vector<double> first_depth;
    std::vector<double> first_curvature;
};

/// A surface that lies where `places` says, beside the real one.
PatternScore score(std::string name, const Truth& truth, const SurfaceView& shape, const Features& features,
                   const Similarity& to_place)
{
    std::vector<Vec3> places(shape.vertices.begin(), shape.vertices.end());
    std::ranges::transform(places, places.begin(), to_place);
    std::vector<Vec3> pits(features.pits);
    std::ranges::transform(pits, pits.begin(), to_place);
    const Carrier carrier(shape, std::move(places), truth.surface.vertices);
    const std::vector<double> depth = carrier.carry(features.depth);
    const std::vector<double> curvature = carrier.carry(features.curvature);
    const auto partial = [&](const auto& values, const auto& real, const auto& known) {
        return correlation(taken_out(values, known, truth.weights), taken_out(real, known, truth.weights),
                           truth.weights);
    };
    return {std::move(name),
            partial(depth, truth.features.depth, truth.first_depth),
            partial(curvature, truth.features.curvature, truth.first_curvature),
            sulcal_dice(curvature, truth.features.curvature, truth.weights),
            share_near(truth.features.pits, pits, 5.0),
            share_near(truth.features.pits, pits, 10.0)};
}

/// A turn about the left-right axis through the centre of the real brain, after the alignment.
Similarity turned(const Similarity& to_place, const Vec3& centre, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Mat3 turn{{{1, 0, 0}, {0, c, s}, {0, -s, c}}};
    return {to_place.scale, turn * to_place.rotation, turn * (to_place.shift - centre) + centre};
}

} // namespace

Similarity align(const SurfaceView& moving, const SurfaceView& target, double* residual_mm)
{
    require_triangles(moving.vertices, moving.triangles);
    require_triangles(target.vertices, target.triangles);
    Similarity result;
    result.scale = std::cbrt(std::abs(enclosed_volume(target.vertices, target.triangles) /
                                      enclosed_volume(moving.vertices, moving.triangles)));
    result.shift = centroid_of(target.vertices) - result.scale * centroid_of(moving.vertices);
    const geometry::SurfaceTree tree(target.vertices, target.triangles);
    const std::vector<Vec3> some = some_of(moving.vertices);
    std::vector<Vec3> points(some.size());
    std::vector<Vec3> partners(some.size());
    double squares = 0.0;
    for (int round = 0; round < alignment_rounds; ++round)
    {
        std::ranges::transform(some, points.begin(), result);
        parallel_for(std::ssize(points), [&](std::int64_t k) { partners[k] = tree.closest(points[k]).position; });
        const Similarity motion = best_motion(points, partners);
        result.rotation = motion.rotation * result.rotation;
        result.shift = motion(result.shift);
        squares = 0.0;
        for (std::size_t k = 0; k < points.size(); ++k)
        {
            squares += squared_norm(points[k] - partners[k]);
        }
    }
    if (residual_mm != nullptr)
    {
        *residual_mm = std::sqrt(squares / static_cast<double>(points.size()));
    }
    return result;
}

FoldPattern fold_pattern(const SurfaceView& first, const SurfaceView& grown, const SurfaceView& target)
{
    FoldPattern result;
    result.alignment = align(grown, target, &result.residual_mm);
    const Similarity first_place = align(first, target);
    Features first_features = features_of(first);
    const Features grown_features = features_of(grown);
    std::vector<Vec3> first_positions(first.vertices.begin(), first.vertices.end());
    std::ranges::transform(first_positions, first_positions.begin(), first_place);
    const Carrier from_first(first, std::move(first_positions), target.vertices);
    Truth truth{target, features_of(target), vertex_areas(target.vertices, target.triangles),
                from_first.carry(first_features.depth), from_first.carry(first_features.curvature)};

    std::vector<Vec3> mirrored(grown.vertices.begin(), grown.vertices.end());
    std::ranges::for_each(mirrored, [](Vec3& x) { x.x = -x.x; });
    std::vector<Triangle> flipped(grown.triangles.begin(), grown.triangles.end());
    std::ranges::for_each(flipped, [](Triangle& t) { std::swap(t[1], t[2]); });
    const SurfaceView mirror{mirrored, flipped};
    Features mirror_features = grown_features;
    std::ranges::for_each(mirror_features.pits, [](Vec3& pit) { pit.x = -pit.x; });

    result.scores.push_back(score("run", truth, grown, grown_features, result.alignment));
    result.scores.push_back(score("first body", truth, first, first_features, first_place));
    result.scores.push_back(score("mirrored", truth, mirror, mirror_features, align(mirror, target)));
    const Vec3 centre = centroid_of(target.vertices);
    for (const double degrees : {-30.0, -15.0, 15.0, 30.0})
    {
        result.scores.push_back(score(fmt::format("turned by {:g} degrees", degrees), truth, grown, grown_features,
                                      turned(result.alignment, centre, degrees)));
    }
    const auto plain = [&](const SurfaceView& shape, const Features& features, const Similarity& place)
    {
        std::vector<Vec3> places(shape.vertices.begin(), shape.vertices.end());
        std::ranges::transform(places, places.begin(), place);
        return correlation(Carrier(shape, std::move(places), target.vertices).carry(features.depth),
                           truth.features.depth, truth.weights);
    };
    result.plain_depth = plain(grown, grown_features, result.alignment);
    result.trivial_depth = plain(first, first_features, first_place);
    return result;
}

} // namespace corticle::metrics
