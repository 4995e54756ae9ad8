// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_pattern.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/polar.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/fold_features.hpp"

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
    FoldFeatures features;
    std::vector<double> weights;
    std::vector<double> first_depth;
    std::vector<double> first_curvature;
};

/// A surface that lies where `places` says, beside the real one.
PatternScore score(std::string name, const Truth& truth, const SurfaceView& shape, const FoldFeatures& features,
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
    FoldFeatures first_features = fold_features(first);
    const FoldFeatures grown_features = fold_features(grown);
    std::vector<Vec3> first_positions(first.vertices.begin(), first.vertices.end());
    std::ranges::transform(first_positions, first_positions.begin(), first_place);
    const Carrier from_first(first, std::move(first_positions), target.vertices);
    Truth truth{target, fold_features(target), vertex_areas(target.vertices, target.triangles),
                from_first.carry(first_features.depth), from_first.carry(first_features.curvature)};

    std::vector<Vec3> mirrored(grown.vertices.begin(), grown.vertices.end());
    std::ranges::for_each(mirrored, [](Vec3& x) { x.x = -x.x; });
    std::vector<Triangle> flipped(grown.triangles.begin(), grown.triangles.end());
    std::ranges::for_each(flipped, [](Triangle& t) { std::swap(t[1], t[2]); });
    const SurfaceView mirror{mirrored, flipped};
    FoldFeatures mirror_features = grown_features;
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
    const auto plain = [&](const SurfaceView& shape, const FoldFeatures& features, const Similarity& place)
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
