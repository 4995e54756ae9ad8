// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/robust_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace corticle
{

TEST(RobustRange, OneCleftDoesNotDecide)
{
    std::vector<double> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        values[i] = 0.01 * static_cast<double>(i);
    }
    values.push_back(500.0);
    const view::Range range = view::robust_range(values);
    EXPECT_NEAR(range.low, 0.0, 1e-12);
    EXPECT_NEAR(range.high, 10.0, 1e-12);
    EXPECT_DOUBLE_EQ(view::full_range(values).high, 500.0);
}

TEST(RobustRange, ALongTailDoesNotDecide)
{
    // As the depth of sulci with the walls of the fissure between the hemispheres, every tenth value far beyond.
    std::vector<double> values;
    for (int i = 0; i < 900; ++i)
    {
        values.push_back(0.01 * i);
    }
    for (int i = 0; i < 100; ++i)
    {
        values.push_back(30.0 + 0.3 * i);
    }
    // Quartiles 2.5 and 7.5: 7.5 + 1.5 * 5 = 15; the 98th percentile is 54.
    EXPECT_NEAR(view::robust_range(values).high, 15.0, 1.1);
    EXPECT_NEAR(view::robust_range(values).low, 0.0, 1e-12);
}

TEST(RobustRange, TailsOfAConstantAreShown)
{
    // Growth that is the same in the cortex, and less in one vertex of ten.
    std::vector<double> values(900, 2.35);
    values.resize(1000, 1.4);
    EXPECT_LE(view::robust_range(values).low, 1.4 + 1e-12);
    EXPECT_GE(view::robust_range(values).high, 2.35 - 1e-12);
}

TEST(RobustRange, ConstantsLieInTheMiddle)
{
    const std::vector<double> values{2.82805, 2.8281, 2.82824};
    const view::Range range = view::robust_range(values);
    EXPECT_LT(range.low, 2.75);
    EXPECT_GT(range.high, 2.9);
    EXPECT_LT(std::abs(0.5 * (range.low + range.high) - 2.828), 0.3 * (range.high - range.low));
}

TEST(RobustRange, WithoutNumbers)
{
    const std::vector<double> values{std::nan("")};
    EXPECT_DOUBLE_EQ(view::robust_range(values).high, 1.0);
    EXPECT_DOUBLE_EQ(view::full_range({}).low, 0.0);
}

TEST(RobustRange, TicksAreRound)
{
    const std::vector<double> ticks = view::round_ticks(0.03, 2.43, 5);
    ASSERT_EQ(ticks.size(), 4u);
    EXPECT_NEAR(ticks.front(), 0.5, 1e-12);
    EXPECT_NEAR(ticks.back(), 2.0, 1e-12);
    EXPECT_EQ(view::round_ticks(3.0, 3.0, 5).size(), 1u);
}

} // namespace corticle
