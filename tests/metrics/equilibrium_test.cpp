// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/equilibrium.hpp"

#include "corticle/record/run_warnings.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "model/same_bits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const record::RunSize run{0.0, 1000.0, 5000.0};

std::vector<std::string_view> kinds(const metrics::Measures& row)
{
    std::vector<std::string_view> result;
    for (const record::RunWarning& warning : record::run_warnings(row, run))
    {
        result.push_back(warning.kind);
    }
    return result;
}

double residual_of(const model::Simulation& simulation)
{
    return metrics::residual_force(simulation, simulation.deformation_gradients());
}

} // namespace

TEST(Equilibrium, SharesOfEnergies)
{
    const metrics::EquilibriumMeasures m =
        metrics::equilibrium_measures({80.0, 4.0, 10.0, 8.0, 6.0, 100.0, 200.0}, 1000.0);
    EXPECT_DOUBLE_EQ(m.zero_mode_share, 0.05);
    EXPECT_DOUBLE_EQ(m.kinetic_share, 0.1);
    EXPECT_DOUBLE_EQ(m.dissipated_share, 0.5);
    EXPECT_DOUBLE_EQ(m.energy_balance_error, 0.0);
    // Energies that came from nowhere count against themselves: the error stays below 1.
    EXPECT_DOUBLE_EQ(
        metrics::equilibrium_measures({400.0, 0.0, 0.0, 0.0, 0.0, 0.0, 100.0}, 1000.0).energy_balance_error, 0.75);
}

TEST(Equilibrium, EnergiesOfRoundOffHaveNoShares)
{
    metrics::Measures row;
    static_cast<metrics::EquilibriumMeasures&>(row) =
        metrics::equilibrium_measures({-3.0e-12, -3.7e-13, 0.0, 0.0, 0.0, 1e-13, -1e-12}, 8000.0);
    EXPECT_EQ(row.zero_mode_share, 0.0);
    EXPECT_EQ(row.energy_balance_error, 0.0);
    EXPECT_THAT(record::run_warnings(row, run), IsEmpty());
}

TEST(Equilibrium, ABodyAtRestHasNoResidual)
{
    const model::Model body = *test::small_model();
    const config::Options options = test::sphere_options(2500);
    EXPECT_EQ(residual_of(model::Simulation(test::shared(body), options)), 0.0);
}

/// A body that keeps its shape while its cortex grows is far from equilibrium; one that follows its growth is nearer.
TEST(Equilibrium, TheResidualTellsABodyThatLags)
{
    const model::Model body = *test::small_model();
    const config::Options options = test::sphere_options(2500);
    model::Simulation held(test::shared(body), options);
    model::State state;
    state.motion.x = body.cloud.positions;
    state.motion.v.resize(state.motion.x.size());
    state.t = 0.2;
    held.restore(state);
    EXPECT_GT(residual_of(held), 1.0);

    model::Simulation free(test::shared(body), options);
    while (free.state().t < 0.2)
    {
        free.step(0.2);
    }
    EXPECT_LT(residual_of(free), 0.5 * residual_of(held));
}

TEST(RunWarnings, EachMeasureThatIsTooLargeIsNamedOnce)
{
    metrics::Measures row;
    row.t = 0.5;
    EXPECT_THAT(kinds(row), IsEmpty());
    row.residual_force = 2.0;
    row.energy_balance_error = 0.06;
    EXPECT_THAT(kinds(row), ElementsAre("residual_force", "energy_balance_error"));
    EXPECT_THAT(record::run_warnings(row, run)[0].text,
                HasSubstr("at t = 0.500 the residual force is 200.0 % of the internal force"));
    row.residual_force = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(kinds(row), ElementsAre("residual_force", "energy_balance_error"));
}

TEST(RunWarnings, BrokenStatesTellHowManyAndWhere)
{
    metrics::Measures row;
    row.t = 0.25;
    row.inverted_elements = 6.0;
    row.smallest_J_place = {1.5, -2.0, 3.0};
    row.overlap_area_share = 2e-5;
    row.overlap_place = {4.0, 5.0, 6.0};
    ASSERT_THAT(kinds(row), ElementsAre("inverted_elements", "overlap_area_share"));
    EXPECT_THAT(record::run_warnings(row, run)[0].text, HasSubstr("at t = 0.250 6 tets are inverted (det F <= 0)"));
    EXPECT_THAT(record::run_warnings(row, run)[0].text, HasSubstr("(1.5, -2, 3) mm"));
    EXPECT_THAT(record::run_warnings(row, run)[1].text, HasSubstr("0.002 % of the surface"));
    EXPECT_THAT(record::run_warnings(row, run)[1].text, HasSubstr("(4, 5, 6) mm"));
}

TEST(RunWarnings, SurfacesThatCrossOrAreHeldByTheTravelLimitAreSaid)
{
    metrics::Measures row;
    row.t = 0.25;
    row.work_growth = 100.0;
    row.energy_contact_limit = 0.9;
    EXPECT_THAT(record::run_warnings(row, run), IsEmpty());
    row.intersecting_triangles = 2.0;
    row.energy_contact_limit = 1.1;
    ASSERT_THAT(kinds(row), ElementsAre("intersecting_triangles", "energy_contact_limit"));
    EXPECT_THAT(record::run_warnings(row, run)[0].text, HasSubstr("2 triangles of the surface intersect"));
    EXPECT_THAT(record::run_warnings(row, run)[1].text, HasSubstr("1.1 % of the work of growth"));
}

/// A few squeezed particles and flat tets belong to creases.
TEST(RunWarnings, CreasesMaySqueezeAFew)
{
    metrics::Measures row;
    row.barrier_particles = 99.0;
    row.extrapolated_elements = 49.0;
    EXPECT_THAT(kinds(row), IsEmpty());
    row.barrier_particles = 101.0;
    row.extrapolated_elements = 51.0;
    EXPECT_THAT(kinds(row), ElementsAre("extrapolated_elements", "barrier_particles"));
}

/// Growth sets in with a jerk; by t = 0.05 after the start it is over.
TEST(RunWarnings, TheFirstMomentsOfGrowthAreNotJudged)
{
    metrics::Measures row;
    row.t = 0.24;
    row.residual_force = 5.0;
    EXPECT_THAT(kinds(row), ElementsAre("residual_force"));
    EXPECT_THAT(record::run_warnings(row, {0.2, 1000.0, 0.0}), IsEmpty());
}

} // namespace corticle
