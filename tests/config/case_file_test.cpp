// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/starter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

namespace corticle
{

namespace
{

using Overrides = std::vector<std::string>;

config::Options parse(std::string_view text, const Overrides& overrides = {})
{
    return config::parse_case(text, "case.toml", overrides, "/cases");
}

std::filesystem::path case_path(const std::string& name)
{
    return std::filesystem::path(CORTICLE_SOURCE_DIR) / "cases" / name;
}

} // namespace

TEST(CaseFile, AnEmptyCaseHasTheDefaults)
{
    const config::Options options = parse("");
    EXPECT_EQ(options.geometry.particles, 45000);
    EXPECT_FALSE(options.geometry.spacing_mm);
    const prepare::GeometryOptions defaults;
    EXPECT_EQ(options.geometry.radius_mm, defaults.radius_mm);
    EXPECT_EQ(options.tlsph.support, tlsph::TlsphOptions{}.support);
}

TEST(CaseFile, ReadsEveryType)
{
    const config::Options options =
        parse("[geometry]\nshape = \"ellipsoid\"\nsemi_axes_mm = [10, 9.5, 8]\nspacing_mm = 0.5\n"
              "seed = 7\n[tissue]\nlayer = \"binary\"\nbulk = 'uniform'\nmu_cortex = 1\n"
              "[contact]\nenabled = false\n[output]\ntimes = [0.1, 0.5, 1]\n");
    EXPECT_EQ(options.geometry.shape, prepare::Shape::ellipsoid);
    EXPECT_EQ(options.geometry.semi_axes_mm, (std::array<double, 3>{10.0, 9.5, 8.0}));
    EXPECT_EQ(options.geometry.spacing_mm, 0.5);
    EXPECT_FALSE(options.geometry.particles);
    EXPECT_EQ(options.geometry.seed, 7);
    EXPECT_EQ(options.tissue.layer, material::Layer::binary);
    EXPECT_EQ(options.tissue.bulk, material::BulkRule::uniform);
    EXPECT_EQ(options.tissue.mu_cortex, 1.0);
    EXPECT_FALSE(options.contact.enabled);
    EXPECT_EQ(options.output.times, (std::vector<double>{0.1, 0.5, 1.0}));
}

TEST(CaseFile, OverridesAreTomlOrBareStrings)
{
    const config::Options options = parse(
        "[time]\nend = 0.5\n", {"time.end = 0.25", "geometry.shape=ellipsoid", "contact.enabled=false",
                                "output.times=[0.1, 0.2]", "output.pictures=\"off\"", "geometry.particles=1_000"});
    EXPECT_EQ(options.time.end, 0.25);
    EXPECT_EQ(options.geometry.shape, prepare::Shape::ellipsoid);
    EXPECT_FALSE(options.contact.enabled);
    EXPECT_EQ(options.output.times, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(options.output.pictures, config::PictureRule::off);
    EXPECT_EQ(options.geometry.particles, 1000);
}

TEST(CaseFile, TheLastOverrideWins)
{
    EXPECT_EQ(parse("", {"time.end=0.1", "time.end=0.2"}).time.end, 0.2);
}

TEST(CaseFile, AnOverrideReplacesTheAlternativeInTheFile)
{
    const config::Options spacing = parse("[geometry]\nparticles = 1000\n", {"geometry.spacing_mm=1"});
    EXPECT_EQ(spacing.geometry.spacing_mm, 1.0);
    EXPECT_FALSE(spacing.geometry.particles);
    const config::Options particles = parse("[geometry]\nspacing_mm = 1.0\n", {"geometry.particles=1000"});
    EXPECT_EQ(particles.geometry.particles, 1000);
    EXPECT_FALSE(particles.geometry.spacing_mm);
    EXPECT_TRUE(parse("[output]\ntimes = [0.5]\n", {"output.count=4"}).output.times.empty());
}

TEST(CaseFile, FilesAreRelativeToTheCaseOrToTheWorkingDirectory)
{
    const std::string text = "[geometry]\nshape = \"file\"\nfile = \"a/../brain.stl\"\n";
    EXPECT_EQ(parse(text).geometry.file, "/cases/brain.stl");
    EXPECT_EQ(parse(text, {"geometry.file=/other/b.ply"}).geometry.file, "/other/b.ply");
    EXPECT_EQ(parse(text, {"geometry.file=b.ply"}).geometry.file, std::filesystem::current_path() / "b.ply");
}

TEST(CaseFile, LabelsAreIntegersInAnyOrder)
{
    const std::string text = "[geometry]\nshape = \"file\"\nfile = \"a.nii\"\nlabels = [9, 2]\n";
    EXPECT_EQ(parse(text).geometry.mask.labels, (std::vector<std::int64_t>{9, 2}));
    EXPECT_EQ(parse(text, {"geometry.labels=[2,3,5,7,9]"}).geometry.mask.labels.size(), 5u);
    EXPECT_EQ(parse("[map]\nstill_file = \"m.nii\"\n").map.still_file, "/cases/m.nii");
}

TEST(CaseFile, AResolvedCaseReadsBackEqual)
{
    const Overrides changes[] = {
        {},
        {"geometry.spacing_mm=0.7", "tissue.alpha_t=0.1", "output.times=[0.1, 0.30000000000000004]"},
        {"geometry.shape=ellipsoid", "tissue.layer=binary", "tissue.lambda=0.6", "solver.cfl=1e-7"},
        {"geometry.shape=file", "geometry.file=a \"quoted\" \\ name.stl", "geometry.unit=cm", "geometry.repair=auto"},
        {"geometry.shape=file", "geometry.file=a.nii", "geometry.labels=[3,2]", "geometry.image_volume=1"},
        {"map.region_file=a.nii", "map.region_table=a.csv", "map.growth_array=m"},
    };
    for (const Overrides& overrides : changes)
    {
        const std::string resolved = config::to_toml(parse("", overrides));
        EXPECT_EQ(config::to_toml(parse(resolved)), resolved);
        EXPECT_TRUE(config::differing_keys(resolved, config::to_toml(parse(resolved))).empty());
    }
}

TEST(CaseFile, DifferingKeysLeaveOutWhatAResumeMayChange)
{
    const std::string a = config::to_toml(parse(""));
    const std::string b = config::to_toml(parse("", {"time.end=0.5", "output.count=3", "tissue.mu_white=2"}));
    EXPECT_EQ(config::differing_keys(a, b), (std::vector<std::string>{"tissue.mu_white: 1.0 -> 2.0"}));
    const std::string c = config::to_toml(parse("", {"geometry.spacing_mm=1"}));
    EXPECT_EQ(config::differing_keys(a, c).size(), 2u);
}

TEST(CaseFile, ABodyDependsOnGeometryAndMapsAlone)
{
    const std::string a = config::to_toml(parse(""));
    EXPECT_TRUE(
        config::differing_body_keys(a, config::to_toml(parse("", {"tissue.mu_white=2", "time.end=0.5"}))).empty());
    EXPECT_EQ(config::differing_body_keys(a, config::to_toml(parse("", {"geometry.seed=7"}))),
              (std::vector<std::string>{"geometry.seed: 1 -> 7"}));
}

TEST(CaseFile, StarterCasesAreValid)
{
    for (const prepare::Shape shape : {prepare::Shape::sphere, prepare::Shape::ellipsoid, prepare::Shape::file})
    {
        EXPECT_EQ(parse(config::starter_case(shape)).geometry.shape, shape);
    }
}

TEST(CaseFile, ShippedCasesAreValid)
{
    EXPECT_EQ(config::read_case(case_path("sphere.toml"), {}).tissue.lambda, 0.75);
    EXPECT_EQ(config::read_case(case_path("ellipsoid.toml"), {}).geometry.shape, prepare::Shape::ellipsoid);
    const Overrides surface{"geometry.file=brain.stl"};
    EXPECT_EQ(config::read_case(case_path("brain.toml"), surface).geometry.particles, 60000);
    EXPECT_THROW(config::read_case(case_path("brain.toml"), {}), InputError);
    EXPECT_THROW(config::read_case(case_path("segmentation.toml"), {}), InputError);
}

TEST(CaseFile, EveryKeyIsInTheSchema)
{
    for (const std::string key : {"radius_mm", "barrier_J", "max_halvings", "stiffness", "checkpoint_minutes"})
    {
        EXPECT_NE(config::schema_text().find(key), std::string::npos) << key;
        EXPECT_NE(config::schema_markdown().find("`" + key + "`"), std::string::npos) << key;
    }
}

TEST(CaseFile, WarnsOfWhatIsProbablyNotMeant)
{
    EXPECT_TRUE(config::case_warnings(parse("")).empty());
    EXPECT_EQ(config::case_warnings(parse("[contact]\nenabled = false\n")).size(), 1u);
    EXPECT_EQ(config::case_warnings(parse("[output]\ntimes = [0.1, 0.9]\n[time]\nend = 0.5\n")).size(), 1u);
}

TEST(CaseFile, NamesTheOutputsThatTheRunDoesNotReach)
{
    const config::Options options =
        parse("[output]\ntimes = [0.05, 0.1, 0.2, 0.9]\npicture_times = [0.1, 0.7]\n[time]\nend = "
              "0.5\n");
    EXPECT_EQ(config::dropped_outputs(options, 0.0),
              (std::vector<std::string>{"output.times: 0.9 outside the run, t = 0 to 0.5: left out",
                                        "output.picture_times: 0.7 outside the run, t = 0 to 0.5: left out"}));
    // Resumed at 0.15, when 0.1 had been written.
    const std::vector<double> recorded{0.0, 0.1};
    const std::vector<std::string> resumed = config::dropped_outputs(options, 0.15, recorded);
    ASSERT_EQ(resumed.size(), 3u);
    EXPECT_EQ(resumed[1], "output.times: 0.05 passed before the run is resumed at t = 0.15: left out");
    EXPECT_EQ(config::dropped_outputs(parse("[output]\ntimes = [0.5]\n[time]\nend = 0.5\n"), 0.0),
              std::vector<std::string>{});
}

} // namespace corticle
