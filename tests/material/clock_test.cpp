// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/clock.hpp"

#include "corticle/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace corticle
{
namespace
{

constexpr material::GestationalClock clocks[] = {material::GestationalClock::wang, material::GestationalClock::cubic};
constexpr double digits = 0.0005; // tables are printed to three

TEST(Clock, WangTable)
{
    const double weeks[] = {22, 25, 28, 30, 34, 38, 40, 44};
    const double times[] = {.066, .161, .294, .391, .574, .719, .774, .856};
    for (int k = 0; k < 8; ++k)
    {
        EXPECT_NEAR(material::growth_time(material::GestationalClock::wang, weeks[k]), times[k], digits) << weeks[k];
    }
}

TEST(Clock, CubicTable)
{
    const double weeks[] = {22, 30, 40, 44};
    const double times[] = {0.000, 0.366, 0.774, 1.007};
    for (int k = 0; k < 4; ++k)
    {
        EXPECT_NEAR(material::growth_time(material::GestationalClock::cubic, weeks[k]), times[k], digits) << weeks[k];
    }
}

TEST(Clock, IncreasesAndItsInverseUndoesIt)
{
    for (const material::GestationalClock clock : clocks)
    {
        const auto [first, last] = material::week_range(clock);
        double before = -1.0;
        for (int k = 0; k <= 4000; ++k)
        {
            const double week = k == 4000 ? last : first + (last - first) * k / 4000.0;
            const double t = material::growth_time(clock, week);
            EXPECT_GT(t, before);
            before = t;
            // t is rounded to 1e-16, and dt/dweek is nowhere below 1e-3 within the ranges.
            EXPECT_NEAR(material::gestational_week(clock, t), week, 1e-12) << week;
        }
        double week_before = 0.0;
        const double earliest = material::growth_time(clock, first);
        const double latest = material::growth_time(clock, last);
        for (int k = 0; k <= 1000; ++k)
        {
            const double t = k == 1000 ? latest : earliest + (latest - earliest) * k / 1000.0;
            const double week = material::gestational_week(clock, t);
            EXPECT_GT(week, week_before);
            week_before = week;
            EXPECT_NEAR(material::growth_time(clock, week), t, 1e-14) << t;
        }
    }
}

TEST(Clock, ItsRateIsTheSlope)
{
    for (const material::GestationalClock clock : clocks)
    {
        for (double week = 22.5; week < 44.0; week += 0.5)
        {
            const double h = 1e-4;
            const double slope =
                (material::growth_time(clock, week + h) - material::growth_time(clock, week - h)) / (2.0 * h);
            EXPECT_NEAR(material::growth_time_rate(clock, week), slope, 1e-9) << week;
        }
    }
}

TEST(Clock, BeyondItsRangeIsAnErrorThatSaysTheRange)
{
    const auto message = [](auto&& call) -> std::string
    {
        try
        {
            call();
            return "";
        }
        catch (const InputError& error)
        {
            return error.what();
        }
    };
    for (const material::GestationalClock clock : clocks)
    {
        const auto [first, last] = material::week_range(clock);
        for (const double week : {first - 0.01, last + 0.01, -1.0, 1e300, std::nan("")})
        {
            EXPECT_THROW(material::growth_time(clock, week), InputError) << week;
        }
        for (const double t : {-0.01, 0.987, 1.1, 1e300, -1e300, std::nan("")})
        {
            const bool reached = clock == material::GestationalClock::cubic && t == 0.987;
            EXPECT_EQ(message([&] { material::gestational_week(clock, t); }).empty(), reached) << t;
        }
    }
    EXPECT_EQ(message([] { material::growth_time(material::GestationalClock::cubic, 45.0); }),
              "time.clock = \"cubic\": got 45 weeks, expected 22 to 44");
    EXPECT_NE(
        message([] { material::gestational_week(material::GestationalClock::wang, 0.99); }).find("16 to 60 weeks"),
        std::string::npos);
    EXPECT_THROW(material::growth_time(material::GestationalClock::none, 30.0), InputError);
    EXPECT_THROW(material::gestational_week(material::GestationalClock::none, 0.5), InputError);
}

} // namespace
} // namespace corticle
