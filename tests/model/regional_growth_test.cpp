// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace corticle
{
namespace
{

constexpr double radius = 12.496;

/// Sphere of the thesis at 5,000 particles with a regional rate m(X), prepared once a rate.
model::Model sphere_with(const std::function<double(const Vec3&)>& regional_rate)
{
    config::Options options = test::sphere_options(5000);
    model::Model body = prepare::prepare_body(options).model;
    for (std::size_t i = 0; i < body.cloud.positions.size(); ++i)
    {
        body.tissue.regional_rate[i] = regional_rate(body.cloud.positions[i]);
    }
    return body;
}

/// Root mean square angle between neighbouring triangles whose reference centroids lie in the region: about the edge
/// over the radius, 0.1, on the sphere, and of order one once it has folded.
double roughness(const model::Simulation& simulation, const std::function<bool(const Vec3&)>& in_region)
{
    const std::vector<Vec3> x = simulation.surface_positions();
    const std::vector<Vec3>& X = simulation.model().surface.vertices;
    std::map<std::pair<std::int32_t, std::int32_t>, Vec3> normals;
    double sum = 0.0;
    double count = 0.0;
    for (const Triangle& triangle : simulation.model().cloud.surface_triangles)
    {
        const auto at = [&](const std::vector<Vec3>& points, std::size_t k)
        { return points[static_cast<std::size_t>(triangle[k])]; };
        if (!in_region((at(X, 0) + at(X, 1) + at(X, 2)) / 3.0))
        {
            continue;
        }
        const Vec3 normal = normalized(cross(at(x, 1) - at(x, 0), at(x, 2) - at(x, 0)));
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto edge = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            const auto [other, is_first] = normals.emplace(std::pair{edge.first, edge.second}, normal);
            if (!is_first)
            {
                sum += std::pow(std::acos(std::clamp(dot(normal, other->second), -1.0, 1.0)), 2);
                count += 1.0;
            }
        }
    }
    return std::sqrt(sum / count);
}

void grow(model::Simulation& simulation, double t)
{
    while (simulation.state().t < t)
    {
        simulation.step(t);
    }
}

TEST(RegionalGrowth, OnlyTheHalfThatGrowsFolds)
{
    const config::Options options = test::sphere_options(5000);
    model::Model body = sphere_with([](const Vec3& X) { return X.x > 0.0 ? 1.0 : 0.0; });
    model::Simulation simulation(test::shared(body), options);
    // A spacing and more away from the border, which bends between the two.
    const auto growing = [](const Vec3& X) { return X.x > 3.0; };
    const auto still = [](const Vec3& X) { return X.x < -3.0; };
    const double smooth = roughness(simulation, growing);
    const double smooth_still = roughness(simulation, still);
    grow(simulation, 0.42);
    std::printf("growing half: roughness %.3f -> %.3f, still half: %.3f -> %.3f, %ld steps\n", smooth,
                roughness(simulation, growing), smooth_still, roughness(simulation, still), simulation.state().steps);
    EXPECT_GT(roughness(simulation, growing), 3.0 * smooth);
    EXPECT_LT(roughness(simulation, still), 1.3 * smooth_still);
}

TEST(RegionalGrowth, ADoubledRateFoldsFirst)
{
    const config::Options options = test::sphere_options(5000);
    const auto fast = [](const Vec3& X) { return X.z > 0.7 * radius; };
    const auto opposite = [](const Vec3& X) { return X.z < -0.7 * radius; };
    model::Model body = sphere_with([&](const Vec3& X) { return X.z > 0.5 * norm(X) ? 2.0 : 1.0; });
    model::Simulation simulation(test::shared(body), options);
    const double smooth = roughness(simulation, fast);
    const double smooth_opposite = roughness(simulation, opposite);
    double onset_fast = 1.0;
    double onset_opposite = 1.0;
    for (double t = 0.1; t < 0.42; t += 0.02)
    {
        grow(simulation, t);
        onset_fast = roughness(simulation, fast) > 2.0 * smooth ? std::min(onset_fast, t) : onset_fast;
        onset_opposite =
            roughness(simulation, opposite) > 2.0 * smooth_opposite ? std::min(onset_opposite, t) : onset_opposite;
    }
    std::printf("onset of folds: t = %.2f where growth is doubled, %.2f opposite\n", onset_fast, onset_opposite);
    EXPECT_LT(onset_fast, 0.24);
    EXPECT_GT(onset_opposite, onset_fast + 0.06);
    EXPECT_LT(onset_opposite, 0.42);
}

} // namespace
} // namespace corticle
