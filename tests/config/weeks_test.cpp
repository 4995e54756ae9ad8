// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/record/run_files.hpp"

#include <gtest/gtest.h>

#include <array>

namespace corticle
{
namespace
{

using Overrides = std::vector<std::string>;

constexpr std::string_view weeks_case = "[time]\nclock = \"wang\"\nstart_week = 23\nend_week = 38\n";

config::Options parse(std::string_view text, const Overrides& overrides = {})
{
    return config::parse_case(text, "case.toml", overrides, "/cases");
}

std::string refusal(std::string_view text, const Overrides& overrides = {})
{
    try
    {
        parse(text, overrides);
        return "";
    }
    catch (const InputError& error)
    {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
}

TEST(Weeks, SetTheGrowthTimesOfARun)
{
    const config::Options options = parse(weeks_case);
    EXPECT_EQ(options.time.start, material::growth_time(material::GestationalClock::wang, 23.0));
    EXPECT_EQ(options.time.end, material::growth_time(material::GestationalClock::wang, 38.0));
    const std::vector<double> times = record::output_times(options);
    EXPECT_EQ(times.front(), options.time.start);
    EXPECT_EQ(times.back(), options.time.end);
    EXPECT_EQ(times.size(), 11u);
    EXPECT_NEAR(times[1] - times[0], times[10] - times[9], 1e-14); // even in t
    EXPECT_EQ(parse("[time]\nclock = \"cubic\"\nstart_week = 22\nend_week = 44\n").time.start, 0.0);
}

TEST(Weeks, OutputsAtChosenWeeks)
{
    const config::Options options = parse(weeks_case, {"output.weeks=[22, 25, 30, 38, 40]"});
    const std::vector<double> times = record::output_times(options);
    ASSERT_EQ(times.size(), 4u); // the start, two of the weeks, the end
    EXPECT_EQ(times[1], material::growth_time(material::GestationalClock::wang, 25.0));
    EXPECT_EQ(times[2], material::growth_time(material::GestationalClock::wang, 30.0));
    ASSERT_EQ(config::case_warnings(options).size(), 1u);
    EXPECT_NE(config::case_warnings(options)[0].find("output.weeks: 22, 40 outside the run, weeks 23 to 38"),
              std::string::npos);
}

TEST(Weeks, TheResolvedCaseReadsBack)
{
    const config::Options options =
        parse(weeks_case, {"output.weeks=[25, 30.5]", "size.law=quadratic", "tissue.normal=current",
                           "tissue.growth_law=gompertz", "tissue.alpha_r=0.1", "size.applies_to=body"});
    const std::string text = config::to_toml(options);
    EXPECT_EQ(config::to_toml(parse(text)), text);
    EXPECT_EQ(parse(text).time.start, options.time.start);
    EXPECT_EQ(parse(text).size.applies_to, material::SizedState::body);
    EXPECT_EQ(parse(text).tissue.normal, material::NormalFrame::current);
    EXPECT_EQ(parse(text).tissue.growth_law, material::GrowthLaw::gompertz);
    // A run may be resumed to a later week, from another week it is another run.
    EXPECT_TRUE(config::differing_keys(text, config::to_toml(parse(text, {"time.end_week=40"}))).empty());
    EXPECT_EQ(config::differing_keys(text, config::to_toml(parse(text, {"time.start_week=24"}))).size(), 1u);
}

TEST(Weeks, AnOverrideWithWeeksReplacesTheTimesOfTheFile)
{
    const config::Options options =
        parse("[time]\nend = 0.5\n[output]\ntimes = [0.1]\n",
              {"time.clock=wang", "time.start_week=23", "time.end_week=30", "output.weeks=[25]"});
    EXPECT_EQ(options.time.end, material::growth_time(material::GestationalClock::wang, 30.0));
    EXPECT_TRUE(options.output.times.empty());
}

TEST(Weeks, NeedAClock)
{
    EXPECT_EQ(refusal("[time]\nstart_week = 23\n"),
              "time.start_week (case.toml:2) is given, but time.clock is \"none\": expected a clock, \"wang\" or "
              "\"cubic\"");
    for (const std::string override : {"time.end_week=30", "output.weeks=[30]", "size.law=quadratic"})
    {
        const std::string message = refusal("", {override});
        EXPECT_NE(message.find(override.substr(0, override.find('='))), std::string::npos) << message;
        EXPECT_NE(message.find("expected a clock"), std::string::npos) << message;
    }
}

TEST(Weeks, AClockNeedsWeeksOfItsRange)
{
    EXPECT_EQ(refusal("[time]\nclock = \"cubic\"\nend_week = 30\n"),
              "time.start_week is missing: got none, expected 22 to 44 weeks, as time.clock (case.toml:2) is "
              "\"cubic\"");
    EXPECT_EQ(refusal("[time]\nclock = \"cubic\"\nstart_week = 22\nend_week = 45\n"),
              "time.end_week (case.toml:4) is out of range: got 45, expected 22 to 44 weeks, as time.clock "
              "(case.toml:2) is \"cubic\"");
    EXPECT_EQ(refusal(weeks_case, {"time.end_week=23"}),
              "time.end_week (--set time.end_week=23) is out of range: got 23, expected more than time.start_week = "
              "23");
    EXPECT_NE(refusal(weeks_case, {"output.weeks=[12]"}).find("output.weeks (--set"), std::string::npos);
    EXPECT_NE(refusal(weeks_case, {"time.clock=sundial"}).find("\"wang\""), std::string::npos);
}

TEST(Weeks, OneWayOfTellingTheTime)
{
    EXPECT_NE(refusal(weeks_case, {"time.end=0.5"}).find("expected time.end_week"), std::string::npos);
    EXPECT_NE(refusal(weeks_case, {"time.start=0.5"}).find("expected time.start_week"), std::string::npos);
    EXPECT_NE(refusal(weeks_case, {"output.weeks=[25]", "output.times=[0.5]"}).find("both given"), std::string::npos);
    EXPECT_EQ(refusal("[time]\nstart = 0.5\nend = 0.5\n"),
              "time.start (case.toml:2) is out of range: got 0.5, expected less than time.end = 0.5");
}

TEST(Weeks, TheLengthLawOfTheOtherClockWarns)
{
    EXPECT_EQ(config::case_warnings(parse(weeks_case, {"size.law=hyperbolic"})).size(), 1u);
    EXPECT_TRUE(config::case_warnings(parse(weeks_case, {"size.law=quadratic"})).empty());
    EXPECT_TRUE(config::case_warnings(parse("[time]\nclock = \"cubic\"\nstart_week = 22\nend_week = 30\n[size]\nlaw = "
                                            "\"hyperbolic\"\n"))
                    .empty());
}

TEST(Weeks, TheCortexThinsOnlyWithAScaledReferenceState)
{
    EXPECT_TRUE(parse(weeks_case, {"size.law=quadratic", "size.thin_cortex=true"}).size.thin_cortex);
    EXPECT_EQ(refusal(weeks_case, {"size.thin_cortex=true"}),
              "size.thin_cortex (--set size.thin_cortex=true) is true: expected a size.law with size.applies_to = "
              "\"reference\"");
    EXPECT_NE(refusal(weeks_case, {"size.thin_cortex=true", "size.law=quadratic", "size.applies_to=body"}), "");
}

TEST(GrowthKeys, HaveRanges)
{
    EXPECT_NE(refusal("[tissue]\nalpha_r = -1\n").find("tissue.alpha_r is out of range (case.toml:2)"),
              std::string::npos);
    EXPECT_NE(refusal("[tissue]\ngrowth_rate = 0\n").find("(0, 100]"), std::string::npos);
    EXPECT_NE(refusal("[tissue]\nnormal = \"outward\"\n").find("\"reference\" or \"current\""), std::string::npos);
    EXPECT_NE(refusal("[tissue]\ngrowth_law = \"logistic\"\n").find("\"gompertz\""), std::string::npos);
    EXPECT_NE(refusal("[size]\nlaw = \"eq15\"\n").find("\"hyperbolic\""), std::string::npos);
}

} // namespace
} // namespace corticle
