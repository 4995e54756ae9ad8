// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/measure_table.hpp"
#include "corticle/metrics/surface_arrays.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/metrics/measures.hpp"
#include "corticle/record/frames.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// The sphere with a bulge of degree l on every particle's radius.
model::State bulged(const model::Model& body, int l, double amplitude)
{
    model::State state;
    for (const Vec3& X : body.cloud.positions)
    {
        state.motion.x.push_back((1.0 + amplitude * std::legendre(l, normalized(X).x)) * X);
    }
    state.motion.v.resize(state.motion.x.size());
    return state;
}

struct Measured
{
    metrics::SurfaceArrays arrays;
    metrics::Measures row;
};

Measured measured(const model::Simulation& simulation)
{
    const model::OutputView view = model::output_view(simulation);
    Measured m{metrics::surface_arrays(view), {}};
    m.row = metrics::measure(view, m.arrays);
    return m;
}

TEST(SurfaceArrays, MillimetresAtTheirWeek)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    const model::Simulation simulation(test::shared(body), options);
    const metrics::Measures run = measured(simulation).row;
    const model::PhysicalScale twice{30.0, 2.0};
    const model::OutputView view = model::output_view(simulation, 0, twice);
    const metrics::SurfaceArrays arrays = metrics::surface_arrays(view);
    const metrics::Measures m = metrics::measure(view, arrays);
    constexpr double round_off = 1e-9; // relative; powers of two, but sums of sampled slices and paths
    const auto expect = [&](double got, double expected)
    { EXPECT_NEAR(got, expected, round_off * std::abs(expected)); };
    EXPECT_EQ(m.week, 30.0);
    EXPECT_EQ(m.length_scale, 2.0);
    EXPECT_TRUE(std::isnan(run.week));
    EXPECT_EQ(run.length_scale, 1.0);
    expect(m.length_mm, 2.0 * run.length_mm);
    expect(m.area_mm2, 4.0 * run.area_mm2);
    expect(m.volume_mm3, 8.0 * run.volume_mm3);
    expect(m.thickness_mean_mm, 2.0 * run.thickness_mean_mm);
    expect(m.abs_mean_curvature_per_mm, 0.5 * run.abs_mean_curvature_per_mm);
    expect(m.area_ratio, run.area_ratio);
    expect(m.volume_ratio, run.volume_ratio);
    expect(m.curved_area_mm2, 4.0 * run.curved_area_mm2);
    expect(m.curved_volume_mm3, 8.0 * run.curved_volume_mm3);
    expect(m.curved_area_ratio, run.curved_area_ratio);
    expect(m.curved_volume_ratio, run.curved_volume_ratio);
    expect(m.gi_hull, run.gi_hull);
    expect(m.gi_zilles, run.gi_zilles);
    expect(m.asymmetry_area + 1.0, run.asymmetry_area + 1.0);
    EXPECT_EQ(m.J_mean, run.J_mean);

    const record::Frame frame = record::make_frame(view, arrays, "0000");
    EXPECT_EQ(frame.week, 30.0);
    EXPECT_EQ(frame.particles[7], 2.0 * simulation.state().motion.x[7]);
    EXPECT_EQ(frame.origins[7], 2.0 * body.cloud.positions[7]);
    EXPECT_EQ(frame.surface[7], 2.0 * simulation.surface_positions()[7]);
    expect(frame.spacing, 2.0 * record::mean_spacing(body.cloud.volumes));
}

TEST(SurfaceArrays, OfAnUndeformedSphere)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    const model::Simulation simulation(test::shared(body), options);
    const Measured m = measured(simulation);
    for (const double t : m.arrays.thickness)
    {
        EXPECT_NEAR(t, options.tissue.thickness_mm, 0.01 * options.tissue.thickness_mm);
    }
    EXPECT_NEAR(m.row.thickness_mean_mm, options.tissue.thickness_mm, 0.005);
    EXPECT_NEAR(m.row.sulcal_depth_max_mm, 0.0, 1e-6);
    EXPECT_NEAR(m.row.gi_zilles, 1.0, 1e-4);
    EXPECT_NEAR(m.row.gi_local_mean, 1.0, 0.01);
    EXPECT_NEAR(m.row.abs_mean_curvature_per_mm * 12.496, 1.0, 0.02);
    EXPECT_EQ(m.row.sulcal_pits, 0.0);
    EXPECT_EQ(m.row.fold_wavelength_mm, 0.0);
    EXPECT_EQ(m.row.fold_wavelength_reference_mm, 0.0);
    EXPECT_EQ(m.row.fold_degree, 0.0);
}

TEST(SurfaceArrays, FindAnImposedDegree)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    simulation.restore(bulged(body, 8, 0.1));
    const Measured m = measured(simulation);
    EXPECT_EQ(m.row.fold_degree, 8.0);
    EXPECT_NEAR(m.row.fold_wavelength_reference_mm * std::sqrt(8.0 * 9.0) / (2.0 * std::numbers::pi * 12.496), 1.0,
                0.02);
    EXPECT_GT(m.row.sulcal_depth_max_mm, 0.2);
}

TEST(SurfaceArrays, DoNotDependOnTheNumberOfThreads)
{
    const config::Options options = test::sphere_options(2500);
    const model::Model body = *test::small_model();
    model::Simulation simulation(test::shared(body), options);
    simulation.restore(bulged(body, 6, 0.05));
    const int threads = thread_count();
    set_thread_count(1);
    const Measured one = measured(simulation);
    set_thread_count(3);
    const Measured three = measured(simulation);
    set_thread_count(threads);
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        EXPECT_TRUE(column.of(one.row) == column.of(three.row) || column.key == "week") << column.key;
    }
    EXPECT_EQ(one.arrays.folds.curvature.gaussian, three.arrays.folds.curvature.gaussian);
    EXPECT_EQ(one.arrays.folds.sulcal_depth, three.arrays.folds.sulcal_depth);
    EXPECT_EQ(one.arrays.folds.local_gyrification, three.arrays.folds.local_gyrification);
    EXPECT_EQ(one.arrays.thickness, three.arrays.thickness);
}

TEST(Measures, ReadBackFromTheirTable)
{
    std::vector<metrics::Measures> rows(2);
    rows[1].t = 0.5;
    rows[1].week = 25.5;
    rows[1].gi_zilles = 1.25;
    rows[1].thickness_mean_mm = 1.0 / 3.0;
    const std::string text = metrics::measures_csv(rows);
    EXPECT_NE(text.find("area_mm2 [mm2]"), std::string::npos);
    const std::vector<metrics::Measures> back = metrics::parse_measures_csv(text, "measures.csv");
    ASSERT_EQ(back.size(), 2u);
    EXPECT_TRUE(std::isnan(back[0].week)); // no clock
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        EXPECT_TRUE(column.of(back[1]) == column.of(rows[1]) || std::isnan(column.of(rows[1]))) << column.key;
    }
}

} // namespace
} // namespace corticle
