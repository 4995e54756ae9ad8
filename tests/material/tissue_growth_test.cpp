// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue_growth.hpp"

#include "corticle/base/error.hpp"
#include "corticle/material/tissue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle::material
{
namespace
{

using ::testing::HasSubstr;

const std::vector<GrowthRow> two_tissues{{20.0, TissueKind::cortex, 1.0, 1.0},
                                         {40.0, TissueKind::cortex, 4.0, 2.0},
                                         {20.0, TissueKind::white, 1.0, 1.0},
                                         {30.0, TissueKind::white, 2.0, 2.0},
                                         {40.0, TissueKind::white, 3.0, 3.0}};

TEST(TissueGrowth, IsRelativeToTheStartAndGoesOnInPerCent)
{
    const TissueGrowth growth(two_tissues, GestationalClock::wang, 25.0, 38.0);
    const auto at = [&](TissueKind tissue, double week)
    { return growth.at(tissue, growth_time(GestationalClock::wang, week)); };
    EXPECT_DOUBLE_EQ(at(TissueKind::cortex, 25.0).tangential, 1.0);
    // 512 intervals, g linear in each: a curvature of order 1 leaves (1/512)²/8.
    EXPECT_NEAR(at(TissueKind::cortex, 35.0).tangential, std::pow(4.0, 10.0 / 20.0), 1e-4);
    EXPECT_NEAR(at(TissueKind::cortex, 35.0).radial, std::pow(2.0, 10.0 / 20.0), 1e-4);
    EXPECT_NEAR(at(TissueKind::white, 35.0).tangential, std::sqrt(2.0 * 3.0) / std::sqrt(2.0), 1e-4);
    EXPECT_EQ(at(TissueKind::deep, 35.0).tangential, 1.0);
    EXPECT_EQ(at(TissueKind::deep, 35.0).tangential_rate, 0.0);
}

TEST(TissueGrowth, RatesAreDerivatives)
{
    const TissueGrowth growth(two_tissues, GestationalClock::wang, 23.0, 38.0);
    for (const double t : {0.1, 0.3, 0.65})
    {
        constexpr double h = 1e-7;
        const double slope =
            (growth.at(TissueKind::cortex, t + h).tangential - growth.at(TissueKind::cortex, t - h).tangential) /
            (2 * h);
        EXPECT_NEAR(growth.at(TissueKind::cortex, t).tangential_rate, slope, 1e-6 * slope) << t;
    }
}

TEST(TissueGrowth, MeanRateIsThatOfTheGrownVolume)
{
    const TissueGrowth growth(two_tissues, GestationalClock::wang, 23.0, 38.0);
    const PerTissue<double> volumes{3.0, 5.0, 2.0}; // deep tissue does not grow
    const auto length = [&](double t)
    {
        double volume = 2.0;
        for (const TissueKind kind : {TissueKind::cortex, TissueKind::white})
        {
            const TissueGrowthAt g = growth.at(kind, t);
            volume += volumes[static_cast<std::size_t>(kind)] * g.tangential * g.tangential * g.radial;
        }
        return std::cbrt(volume);
    };
    constexpr double t = 0.3;
    constexpr double h = 1e-6;
    EXPECT_NEAR(growth.mean_rate(volumes, t), std::log(length(t + h) / length(t - h)) / (2 * h), 1e-6);
}

std::string refusal(std::vector<GrowthRow> rows, double start = 23.0, double end = 38.0)
{
    try
    {
        const TissueGrowth growth(rows, GestationalClock::wang, start, end);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

TEST(TissueGrowth, RefusesRowsThatSayTooLittleOrTooMuch)
{
    EXPECT_THAT(refusal(two_tissues, 19.0), HasSubstr("rows of weeks 20 to 40"));
    EXPECT_THAT(refusal(two_tissues, 23.0, 41.0), HasSubstr("23 to 41"));
    EXPECT_THAT(refusal({two_tissues[0], two_tissues[0], two_tissues[1]}), HasSubstr("two rows of week 20"));
    EXPECT_THAT(refusal({two_tissues[0], {40.0, TissueKind::cortex, -1.0, 1.0}}), HasSubstr("above 0"));
}

TEST(TissueGrowth, OfAFetalBrainKeepsTheVolumesOfItsTissues)
{
    // Tissue labels of an atlas, week 23 to 38: cortex 18.6 to 118.8 ml, white matter 30.5 to 151.9 ml (see
    // docs/theory/growth-law.md), passed within the tolerances that the law is calibrated to.
    const TissueGrowth growth(fetal_growth(23.0), GestationalClock::wang, 23.0, 38.0);
    const double t = growth_time(GestationalClock::wang, 38.0);
    const auto volume = [&](TissueKind tissue)
    {
        const TissueGrowthAt now = growth.at(tissue, t);
        return now.tangential * now.tangential * now.radial;
    };
    EXPECT_NEAR(volume(TissueKind::cortex), 118.8 / 18.6, 0.05 * 118.8 / 18.6);
    EXPECT_NEAR(volume(TissueKind::white), 151.9 / 30.5, 0.06 * 151.9 / 30.5);
    EXPECT_EQ(volume(TissueKind::still), 1.0);
}

TEST(TissueGrowth, OfAFetalBrainImagedLaterMakesUpForTheStressItHad)
{
    const double t = growth_time(GestationalClock::wang, 38.0);
    // ln q, by what growth along and across the cortex is beyond that of its volume
    const auto excess = [&](double start_week)
    {
        const TissueGrowthAt now =
            TissueGrowth(fetal_growth(start_week), GestationalClock::wang, start_week, 38.0).at(TissueKind::cortex, t);
        return std::log(now.tangential / now.radial) / 3.0;
    };
    const double of_the_course = excess(23.0);
    EXPECT_NEAR(of_the_course, 0.227, 1e-3);
    // At 28 weeks ln q is 0.146; 0.1025 of it comes back but for exp(-10/4).
    EXPECT_NEAR(excess(28.0), of_the_course - 0.146 + 0.1025 * (1.0 - std::exp(-2.5)), 1e-3);
    // A younger brain than that of the calibration has none.
    EXPECT_NEAR(excess(21.0), of_the_course + 0.0653, 1e-3);
}

TEST(LabelledTissue, MixesWhatIsThereByShare)
{
    TissueOptions options;
    options.mu_deep = 2.0;
    options.bulk_ratio[static_cast<std::size_t>(TissueKind::deep)] = 20.0;
    TissueFields fields;
    fields.regional_rate = {1.0, 1.0};
    fields.kind = {TissueKind::deep, TissueKind::still};
    TissueState state;
    state.theta = {0.25, 0.0};
    const Tissue tissue{options, fields, state};
    const MaterialPoint point = tissue.point(0, 0.5);
    EXPECT_FALSE(tissue.grows_plainly());
    EXPECT_DOUBLE_EQ(point.shear_modulus, 0.25 * options.mu_cortex + 0.75 * 2.0);
    EXPECT_DOUBLE_EQ(point.bulk_modulus, 0.25 * 5.0 * options.mu_cortex + 0.75 * 40.0);
    EXPECT_DOUBLE_EQ(point.growth, 1.0 + 0.25 * options.alpha_t * 0.5);
    EXPECT_EQ(tissue.point(1, 0.5).growth, 1.0);
}

TEST(LabelledTissue, WhiteMatterAloneIsThatOfTheKeys)
{
    TissueOptions options;
    options.alpha_white = 0.7;
    options.alpha_r = 0.3;
    options.growth_law = GrowthLaw::gompertz;
    TissueFields plain;
    plain.regional_rate = {1.3};
    TissueFields labelled = plain;
    labelled.kind = {TissueKind::white};
    TissueState state;
    state.theta = {0.4};
    state.theta_rate = {0.2};
    state.past = {{1.1, 1.05}};
    const MaterialPoint a = Tissue{options, plain, state}.point(0, 0.4);
    const MaterialPoint b = Tissue{options, labelled, state}.point(0, 0.4);
    EXPECT_NEAR(a.growth, b.growth, 1e-14);
    EXPECT_NEAR(a.growth_rate, b.growth_rate, 1e-13);
    EXPECT_NEAR(a.radial_growth, b.radial_growth, 1e-14);
    EXPECT_NEAR(a.radial_growth_rate, b.radial_growth_rate, 1e-13);
    EXPECT_NEAR(a.shear_modulus, b.shear_modulus, 1e-14);
    EXPECT_NEAR(a.bulk_modulus, b.bulk_modulus, 1e-14);
    EXPECT_NEAR(a.shear_rate, b.shear_rate, 1e-14);
    EXPECT_NEAR(a.bulk_rate, b.bulk_rate, 1e-14);
}

} // namespace
} // namespace corticle::material
