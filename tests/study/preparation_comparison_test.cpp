// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/preparation_comparison.hpp"

#include "corticle/base/parallel.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <numeric>

namespace corticle
{
namespace
{

config::Options thesis_sphere()
{
    config::Options options = test::sphere_options(4000);
    options.tissue.layer = material::Layer::binary;
    options.tissue.lambda = 0.75;
    return options;
}

struct Compared
{
    model::Model body;
    study::PreparationComparison comparison;
};

const Compared& compared()
{
    static const Compared once = []
    {
        Compared result{prepare::prepare_body(thesis_sphere()).model, {}};
        result.comparison = study::compare_preparation(result.body, thesis_sphere());
        return result;
    }();
    return once;
}

TEST(PreparationComparison, OursIsNearTheExactAnswerAndTheThesisIsNot)
{
    const study::PreparationComparison& c = compared().comparison;
    EXPECT_EQ(c.reference, "sphere");
    ASSERT_EQ(c.normals.size(), 4u);
    for (std::size_t k = 1; k < 4; ++k)
    {
        EXPECT_GT(c.normals[k].mean, 3.0 * c.normals[0].mean);
        EXPECT_GE(c.normals[k].largest, c.normals[k].percentile_95);
        EXPECT_GE(c.normals[k].percentile_95, c.normals[k].mean);
    }
    EXPECT_LT(c.normals[0].mean_in_cortex, 0.5);

    ASSERT_EQ(c.volumes.size(), 2u);
    const study::VolumeErrors& ours = c.volumes[0];
    const study::VolumeErrors& counts = c.volumes[1];
    EXPECT_NEAR(ours.sum, 0.0, 1e-12);
    EXPECT_NEAR(counts.sum, 0.0, 1e-9); // both sum to the volume; the thesis only shares it out wrongly
    EXPECT_LT(ours.rms, 0.02);
    EXPECT_NEAR(ours.surface_ratio, 1.0, 0.01);
    EXPECT_NEAR(ours.deep_ratio, 1.0, 0.01);
    EXPECT_GT(counts.surface_ratio, 2.0); // a half cell, counted as more than a whole one
    EXPECT_LT(counts.deep_ratio, 0.9);

    ASSERT_EQ(c.depths.size(), 2u);
    EXPECT_LT(c.depths[0].largest, 0.05); // the sagitta of a triangle, 1.1² / (8 · 12.5), and what scaling adds
    EXPECT_GT(c.depths[1].largest, 5.0 * c.depths[0].largest);
}

TEST(PreparationComparison, CortexOfTheThesisHoldsTooMuchVolume)
{
    const study::PreparationComparison& c = compared().comparison;
    EXPECT_NEAR(c.exact_cortex_share, 1.0 - std::pow(0.75, 1.5), 1e-12);
    ASSERT_EQ(c.layers.size(), 4u);
    EXPECT_NEAR(c.layers[0].cortex_share, c.exact_cortex_share, 1e-9);
    EXPECT_GT(c.layers[2].cortex_share, 1.2 * c.exact_cortex_share); // with its own volumes
    EXPECT_NEAR(c.layers[3].cortex_share, c.exact_cortex_share, 1e-9);
    const auto wrong = [](double disagreement) { return disagreement != 0.0; };
    EXPECT_EQ(std::any_of(c.layer_disagreement.begin(), c.layer_disagreement.end(), wrong),
              c.layers[1].misassigned_share > 0.0);
}

TEST(PreparationComparison, RandomThinningIsUneven)
{
    const study::PreparationComparison& c = compared().comparison;
    ASSERT_EQ(c.clouds.size(), 3u);
    const study::Regularity& ours = c.clouds[0].regularity;
    const study::Regularity& random = c.clouds[1].regularity;
    EXPECT_EQ(ours.particles, c.particles);
    EXPECT_EQ(random.particles, c.particles);
    EXPECT_GT(random.neighbors_variation, 1.3 * ours.neighbors_variation);
    EXPECT_GT(random.worst_condition, 2.0 * ours.worst_condition);
    EXPECT_LT(random.closest_pair, 0.8 * ours.closest_pair);
    EXPECT_GT(c.clouds[2].regularity.closest_pair, random.closest_pair);
}

TEST(PreparationComparison, OffTheSphereEq24IsNoLayerOfOneThickness)
{
    config::Options options = thesis_sphere();
    options.geometry.shape = prepare::Shape::ellipsoid;
    options.geometry.semi_axes_mm = {20.0, 10.0, 8.0};
    options.geometry.particles = 3000;
    options.tissue.layer = material::Layer::smooth;
    options.tissue.thickness_mm = 2.0;
    const model::Model body = prepare::prepare_body(options).model;
    const study::PreparationComparison c = study::compare_preparation(body, options);
    EXPECT_EQ(c.reference, "triangulated surface");
    EXPECT_EQ(c.depths[0].largest, 0.0);
    EXPECT_NEAR(c.layers[0].cortex_share, c.exact_cortex_share, 0.01);
    // With the right volume it still lies in the wrong place.
    EXPECT_GT(c.layers[3].misassigned_share, 0.03);
    EXPECT_GT(c.layers[3].misassigned_share, 1.5 * c.layers[0].misassigned_share);
    EXPECT_GT(c.normals[2].mean, 2.0 * c.normals[0].mean);
}

TEST(PreparationComparison, HasFieldsOfEveryParticle)
{
    const auto& [body, comparison] = compared();
    const std::vector<formats::Field> fields = study::comparison_fields(comparison);
    ASSERT_EQ(fields.size(), 4u);
    for (const formats::Field& field : fields)
    {
        EXPECT_EQ(field.values.size(), body.cloud.positions.size()) << field.name;
    }
    // The same figures as in the tables: of eight divisions, and of the counts.
    const double mean = std::accumulate(fields[0].values.begin(), fields[0].values.end(), 0.0) /
                        static_cast<double>(comparison.particles);
    EXPECT_NEAR(mean, comparison.normals[2].mean, 1e-9);
    EXPECT_NE(comparison.normals[2].choice.find("8 divisions"), std::string::npos);
}

TEST(PreparationComparison, JsonAndTextHoldTheFigures)
{
    study::PreparationComparison comparison = compared().comparison;
    comparison.clouds[1].regularity.worst_condition = std::numeric_limits<double>::infinity();
    const auto j = nlohmann::json::parse(study::comparison_json(comparison));
    EXPECT_EQ(j["particles"], comparison.particles);
    EXPECT_EQ(j["normals"].size(), 4u);
    EXPECT_EQ(j["normals"][1]["mean_deg"], comparison.normals[1].mean);
    EXPECT_EQ(j["volumes"][1]["surface_ratio"], comparison.volumes[1].surface_ratio);
    EXPECT_EQ(j["layers"][0]["choice"], "exact");
    EXPECT_TRUE(j["clouds"][1]["worst_condition"].is_null());
    const std::string text = study::comparison_text(comparison);
    for (const char* part : {"| thesis: random thinning |", "surface_ratio", "| exact | 0.3505 |"})
    {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

TEST(PreparationComparison, IsTheSameForAnyNumberOfThreads)
{
    const int threads = thread_count();
    set_thread_count(1);
    const study::PreparationComparison one = study::compare_preparation(compared().body, thesis_sphere());
    set_thread_count(threads);
    EXPECT_EQ(study::comparison_json(one), study::comparison_json(compared().comparison));
    EXPECT_EQ(one.normal_error, compared().comparison.normal_error);
    EXPECT_EQ(one.volume_ratio, compared().comparison.volume_ratio);
}

} // namespace
} // namespace corticle
