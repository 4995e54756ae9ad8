// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/study/sweep/sweep_runs.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace corticle
{

namespace
{

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

sweep::SweepFile parse(const std::string& axes)
{
    return sweep::parse_sweep("base = \"base.toml\"\n" + axes, "sweep.toml", "/sweeps");
}

std::vector<double> numbers(const sweep::SweepAxis& axis)
{
    std::vector<double> result;
    for (const std::vector<config::Value>& values : axis.values)
    {
        const auto* integer = std::get_if<std::int64_t>(&values.front());
        result.push_back(integer != nullptr ? static_cast<double>(*integer) : std::get<double>(values.front()));
    }
    return result;
}

std::string refusal(const std::string& axes)
{
    try
    {
        parse(axes);
        return "";
    }
    catch (const InputError& error)
    {
        return error.what();
    }
}

} // namespace

TEST(SweepFile, RangesHaveTheirEnds)
{
    const auto by_step = parse("[[axis]]\nkey = \"solver.cfl\"\nstart = 0.1\nstop = 0.5\nstep = 0.1\n").axes.front();
    EXPECT_THAT(numbers(by_step), ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5)); // the same bits as written by hand
    EXPECT_THAT(by_step.names, ElementsAre("cfl-0.1", "cfl-0.2", "cfl-0.3", "cfl-0.4", "cfl-0.5"));
    const auto down = parse("[[axis]]\nkey = \"solver.cfl\"\nstart = 0.5\nstop = 0.1\nstep = -0.2\n").axes.front();
    EXPECT_THAT(numbers(down), ElementsAre(0.5, 0.3, 0.1));
    const auto counted = parse("[[axis]]\nkey = \"solver.zeta\"\nstart = 0\nstop = 1\ncount = 5\n").axes.front();
    EXPECT_THAT(numbers(counted), ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
    const auto log =
        parse("[[axis]]\nkey = \"geometry.particles\"\nstart = 1000\nstop = 8000\ncount = 4\nspacing = \"log\"\n")
            .axes.front();
    EXPECT_THAT(numbers(log), ElementsAre(1000, 2000, 4000, 8000));
    EXPECT_TRUE(log.is_log);
    EXPECT_TRUE(std::holds_alternative<std::int64_t>(log.values.front().front()));
}

TEST(SweepFile, PathsAreThoseBesideTheSweep)
{
    const sweep::SweepFile sweep = parse("[[axis]]\nkey = \"geometry.file\"\nvalues = [\"a.stl\", \"../b.stl\"]\n");
    EXPECT_EQ(sweep.base, "/sweeps/base.toml");
    EXPECT_EQ(std::get<std::string>(sweep.axes.front().values[0][0]), "/sweeps/a.stl");
    EXPECT_EQ(std::get<std::string>(sweep.axes.front().values[1][0]), "/b.stl");
    EXPECT_THAT(sweep.axes.front().names, ElementsAre("file-a.stl", "file-b.stl"));
}

TEST(SweepFile, LikeNamesAreToldApartByTheirSections)
{
    const sweep::SweepFile sweep = parse("[[axis]]\nkey = \"contact.stiffness\"\nvalues = [0.1]\n[[axis]]\nkey = "
                                         "\"contact.distance\"\nvalues = [0.2]\n");
    EXPECT_THAT(sweep.axes[0].names, ElementsAre("stiffness-0.1"));
    EXPECT_THAT(sweep.axes[1].names, ElementsAre("distance-0.2"));
}

TEST(SweepFile, SettingsMayBeDottedOrNested)
{
    const sweep::SweepFile sweep = parse("[set]\nsolver.cfl = 0.4\n\"tissue.layer\" = \"binary\"\n[set.time]\nend = 1\n"
                                         "[[axis]]\nkey = \"solver.zeta\"\nvalues = [0.1]\n");
    EXPECT_THAT(sweep.settings,
                ::testing::UnorderedElementsAre("solver.cfl=0.4", "tissue.layer=\"binary\"", "time.end=1.0"));
}

TEST(SweepFile, RefusalsNameThePlace)
{
    EXPECT_THAT(refusal("[[axis]]\nkey = \"solver.clf\"\nvalues = [1]\n"), HasSubstr("sweep.toml:3"));
    EXPECT_THAT(refusal("[[axis]]\nkey = \"solver.cfl\"\nvalues = [2]\n"), HasSubstr("got 2"));
    EXPECT_THAT(refusal("[[axis]]\nkey = \"solver.cfl\"\nstart = nan\nstop = 1\ncount = 2\n"), HasSubstr("start"));
    EXPECT_THAT(refusal("measures = [\"gi_hull@\"]\n[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.2]\n"),
                HasSubstr("gi_hull@"));
    EXPECT_EQ(refusal("[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.2]\n"), "");
}

class SweepRuns : public ::testing::Test
{
  protected:
    SweepRuns() { std::ofstream(folder.path() / "base.toml") << "[geometry]\nparticles = 1000\n"; }
    sweep::SweepFile parse(const std::string& text) const
    {
        return sweep::parse_sweep("base = \"base.toml\"\n" + text, "sweep.toml", folder.path());
    }
    TemporaryFolder folder;
};

TEST_F(SweepRuns, TheLastAxisIsTheFastest)
{
    const sweep::SweepFile sweep = parse("[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1, 0.2]\n"
                                         "[[axis]]\nkey = \"solver.zeta\"\nvalues = [0.3, 0.4]\n");
    const std::vector<sweep::SweepRun> runs = sweep::sweep_runs(sweep);
    ASSERT_EQ(runs.size(), 4u);
    EXPECT_EQ(runs[1].name, "cfl-0.1_zeta-0.4");
    EXPECT_EQ(runs[2].options.dynamics.cfl, 0.2);
    EXPECT_EQ(runs[2].options.tlsph.zeta, 0.3);
    EXPECT_EQ(runs[2].options.geometry.particles, 1000);
}

TEST_F(SweepRuns, ASpacingReplacesTheParticlesOfTheBase)
{
    const std::vector<sweep::SweepRun> runs =
        sweep::sweep_runs(parse("[[axis]]\nkey = \"geometry.spacing_mm\"\nvalues = [1.0]\n"));
    EXPECT_FALSE(runs.front().options.geometry.particles);
    EXPECT_EQ(runs.front().options.geometry.spacing_mm, 1.0);
}

TEST_F(SweepRuns, ASettingOfTheCommandLineReplacesThatOfTheFile)
{
    sweep::SweepFile sweep = parse("[set]\ntime.end = 0.5\n[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1]\n");
    sweep::change_settings(sweep, std::vector<std::string>{"time.end=0.25"});
    EXPECT_THAT(sweep.settings, ElementsAre("time.end=0.25"));
    EXPECT_EQ(sweep::sweep_runs(sweep).front().options.time.end, 0.25);
    EXPECT_THROW(sweep::change_settings(sweep, std::vector<std::string>{"solver.cfl=0.2"}), InputError);
}

TEST_F(SweepRuns, IdentityLeavesOutWhatChangesNoNumber)
{
    const sweep::SweepFile sweep = parse("[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1]\n");
    const auto identity = [&](const std::string& setting)
    {
        sweep::SweepFile changed = sweep;
        sweep::change_settings(changed, std::vector{setting});
        return sweep::case_identity(sweep::sweep_runs(changed).front().options);
    };
    EXPECT_EQ(identity("output.pictures=\"off\""), identity("output.checkpoint_minutes=1"));
    EXPECT_NE(identity("output.count=7"), identity("output.count=8"));
    EXPECT_NE(identity("time.end=0.5"), identity("time.end=0.6"));
}

TEST_F(SweepRuns, ReferencesByValuesKeepTheOtherAxes)
{
    sweep::SweepFile sweep =
        parse("reference = { solver.cfl = 0.2 }\n[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1, 0.2]\n"
              "[[axis]]\nkey = \"solver.zeta\"\nvalues = [0.3, 0.4]\n");
    const std::vector<sweep::SweepRun> runs = sweep::sweep_runs(sweep);
    EXPECT_THAT(sweep::given_references(sweep, runs), ElementsAre(2u, 3u, 2u, 3u));
    sweep.reference.kind = sweep::SweepReference::Kind::number;
    sweep.reference.number = 5;
    EXPECT_THROW(sweep::given_references(sweep, runs), InputError);
}

TEST_F(SweepRuns, OnlyTakesNumbersNamesAndValues)
{
    const sweep::SweepFile sweep = parse("[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1, 1]\n"
                                         "[[axis]]\nkey = \"solver.zeta\"\nvalues = [0.3, 0.4]\n");
    const std::vector<sweep::SweepRun> runs = sweep::sweep_runs(sweep);
    const auto chosen = [&](std::vector<std::string> only) { return sweep::chosen_runs(sweep, runs, only); };
    EXPECT_THAT(chosen({}), ElementsAre(true, true, true, true));
    EXPECT_THAT(chosen({"2", "cfl-0.1_zeta-0.3"}), ElementsAre(true, true, false, false));
    EXPECT_THAT(chosen({"solver.cfl=1"}), ElementsAre(false, false, true, true));
    EXPECT_THROW(chosen({"0"}), InputError);
    EXPECT_THROW(chosen({"solver.cfl=2"}), InputError);
}

} // namespace corticle
