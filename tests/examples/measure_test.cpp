// SPDX-License-Identifier: GPL-3.0-or-later
// How a measure is added: this file is all that a new column of measures.csv and key of summary.json needs.
#include "corticle/metrics/measure_table.hpp"

#include "corticle/metrics/measuring.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

/// Largest distance of a surface vertex from the origin [mm].
double farthest_vertex(const model::OutputView& view)
{
    return test::largest_norm(view.surface);
}

TEST(MeasureExample, IsAColumnLikeAnyOther)
{
    metrics::add_measure("farthest_vertex_mm", "mm", "largest distance of the surface from the origin",
                         farthest_vertex);
    model::Simulation simulation(test::small_model(), test::sphere_options(2500));
    metrics::Measuring measuring;
    model::Observer* const observers[]{&measuring};
    const std::vector<double> times{0.0, 0.02};
    model::fold(simulation, times, 0, observers, [] { return false; });
    const metrics::MeasureColumn& column = metrics::measure_columns().back();
    EXPECT_EQ(column.key, "farthest_vertex_mm");
    EXPECT_NEAR(column.of(measuring.rows()[0]), 12.496, 0.05); // the polyhedron has the volume of the sphere
    EXPECT_GT(column.of(measuring.rows()[1]), 12.6);
    const std::string text = metrics::measures_csv(measuring.rows());
    EXPECT_THAT(text, testing::HasSubstr(",farthest_vertex_mm [mm]\n"));
    const std::vector<metrics::Measures> back = metrics::parse_measures_csv(text, "measures.csv");
    EXPECT_EQ(column.of(back[1]), column.of(measuring.rows()[1]));
    EXPECT_THAT(metrics::measures_markdown(), testing::HasSubstr("| `farthest_vertex_mm` | mm | largest distance"));
}

} // namespace
} // namespace corticle
