// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/imperfection.hpp"

#include "corticle/model/simulation.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include "material/own_tissue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle
{
namespace
{

/// A place of a cube of 200 mm.
Vec3 place(std::uint64_t counter)
{
    return 100.0 * test::random_vector(11, counter);
}

TEST(RandomWaves, HaveMeanZeroVarianceOneAndTheirBand)
{
    const double shortest = 6.0;
    const double longest = 15.0;
    const material::RandomWaves waves(1, shortest, longest);
    constexpr std::uint64_t count = 20000;
    constexpr double apart = 0.05;
    double sum = 0.0;
    double squares = 0.0;
    double slopes = 0.0;
    for (std::uint64_t i = 0; i < count; ++i)
    {
        const double value = waves.at(place(i));
        sum += value;
        squares += value * value;
        for (const Vec3& step : {Vec3{apart, 0, 0}, Vec3{0, apart, 0}, Vec3{0, 0, apart}})
        {
            slopes += std::pow((waves.at(place(i) + step) - value) / apart, 2);
        }
    }
    EXPECT_NEAR(sum / count, 0.0, 0.03); // 4 / sqrt(20,000)
    EXPECT_NEAR(squares / count, 1.0, 0.05);
    // The mean square of the slope is the mean of k², and k is spread evenly.
    const double low = 2.0 * std::numbers::pi / longest;
    const double high = 2.0 * std::numbers::pi / shortest;
    EXPECT_NEAR(slopes / count / ((low * low + low * high + high * high) / 3.0), 1.0, 0.1);
}

TEST(RandomWaves, FollowTheirSeed)
{
    const material::RandomWaves first(1, 6.0, 15.0);
    const material::RandomWaves again(1, 6.0, 15.0);
    const material::RandomWaves other(2, 6.0, 15.0);
    EXPECT_EQ(first.at(place(0)), again.at(place(0)));
    EXPECT_NE(first.at(place(0)), other.at(place(0)));
}

TEST(Imperfection, AColumnOfCortexGrowsAsOne)
{
    test::OwnTissue tissue;
    tissue.depth = {0.0, 1.5};
    tissue.normal = {{0, 0, 1}, {0, 0, 1}};
    tissue.regional_rate = {1.0, 0.5};
    const std::vector<Vec3> places{{3, 4, 10}, {3, 4, 8.5}};
    const material::RandomWaves waves(1, 6.0, 15.0);
    material::apply_imperfection(waves, 0.1, places, tissue);
    EXPECT_NEAR(tissue.regional_rate[0], 1.0 + 0.1 * waves.at(places[0]), 1e-15);
    EXPECT_NEAR(tissue.regional_rate[1], 0.5 * tissue.regional_rate[0], 1e-12);
}

TEST(Imperfection, BuiltInShapesHaveOneAndOthersDoNot)
{
    config::Options from_file;
    from_file.geometry.shape = prepare::Shape::file;
    EXPECT_EQ(prepare::imperfection_amplitude(config::Options()), 0.05);
    EXPECT_EQ(prepare::imperfection_amplitude(from_file), 0.0);
    from_file.imperfection.amplitude = 0.02;
    EXPECT_EQ(prepare::imperfection_amplitude(from_file), 0.02);
    config::Options thesis;
    thesis.formulation = thesis::Formulation::thesis;
    EXPECT_EQ(prepare::imperfection_amplitude(thesis), 0.0);
}

/// A run that goes on to a later end must find the growth it began with.
TEST(Imperfection, KnowsNothingOfTheEndOfTheRun)
{
    config::Options options = test::sphere_options(2500);
    options.imperfection.amplitude = 0.05;
    options.tissue.thickness_rate_mm = -0.5;
    options.time.end = 0.4;
    const model::Model shorter = prepare::prepare_body(options).model;
    options.time.end = 1.0;
    const model::Model longer = prepare::prepare_body(options).model;
    ASSERT_FALSE(shorter.tissue.regional_rate.empty());
    EXPECT_EQ(shorter.tissue.regional_rate, longer.tissue.regional_rate);
}

TEST(Imperfection, ParticlesAndTetsGetTheSameFieldAndRestWithoutStress)
{
    config::Options options = test::sphere_options(2500);
    options.imperfection.amplitude.reset();
    prepare::Preparation made = prepare::prepare_body(options);
    model::Model& body = made.model;
    const std::vector<double> once = body.tissue.regional_rate;
    prepare::connect_body(options, made);
    EXPECT_EQ(body.tissue.regional_rate, once); // not applied twice

    const material::RandomWaves waves(1, 4.0 * options.tissue.thickness_mm, 10.0 * options.tissue.thickness_mm);
    const auto expect_field = [&](const model::Model& of)
    {
        double squares = 0.0;
        for (const std::int32_t i : of.cloud.surface_particles)
        {
            const auto k = static_cast<std::size_t>(i);
            const double deviation = of.tissue.regional_rate[k] - 1.0;
            const Vec3 place = of.fem ? of.cloud.positions[k] : of.cloud.centroids[k];
            const Vec3 foot = place + of.tissue.depth[k] * of.tissue.normal[k];
            ASSERT_LT(norm(foot - of.cloud.positions[k]), 0.5 * of.cloud.spacing);
            ASSERT_NEAR(deviation, 0.05 * waves.at(foot), 1e-12);
            squares += deviation * deviation;
        }
        // One sphere of some hundred wavelengths' squares: not exactly that of all space.
        EXPECT_NEAR(std::sqrt(squares / static_cast<double>(of.cloud.surface_particles.size())), 0.05, 0.01);
    };
    expect_field(body);
    constexpr double round_off = 1e-9; // of a body of 8,000 mm³ whose folds hold thousands
    EXPECT_LT(std::abs(model::Simulation(test::shared(body), options).internal().elastic_energy), round_off);

    options.method = model::Method::fem;
    model::Model tets = prepare::prepare_body(options).model;
    expect_field(tets);
    const auto [least, most] = std::ranges::minmax(tets.fem->tissue.regional_rate);
    EXPECT_LT(least, 0.9);
    EXPECT_GT(most, 1.1);
    EXPECT_LT(std::abs(model::Simulation(test::shared(tets), options).internal().elastic_energy), round_off);
}

} // namespace
} // namespace corticle
