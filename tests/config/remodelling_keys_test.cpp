// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using testing::HasSubstr;

std::string refusal(std::string_view text)
{
    try
    {
        config::parse_case(text, "case.toml", {}, "/cases");
        return "";
    }
    catch (const InputError& error)
    {
        return error.what();
    }
}

TEST(RemodellingKeys, ThatDoNothingAreRefused)
{
    EXPECT_EQ(
        refusal("[relaxation]\ntime = 0.2\n"),
        "relaxation.time (case.toml:2) is given, but relaxation.share is 0: expected a number above 0, or no such "
        "key");
    EXPECT_THAT(refusal("[stress_growth]\nshrinks = true\n"), HasSubstr("stress_growth.rate is 0"));
    EXPECT_THAT(refusal("[fibres]\nstiffness = 1\n"), HasSubstr("fibres.direction is \"none\""));
    EXPECT_THAT(refusal("[fibres]\ndirection = \"radial\"\n"), HasSubstr("fibres carry nothing"));
    EXPECT_THAT(refusal("[fibres]\ndirection = \"radial\"\nstiffness = 1\nramp = 0.2\n"),
                HasSubstr("fibres.active_stress is 0"));
    EXPECT_THAT(refusal("[fibres]\ndirection = \"radial\"\nactive_stress = 1\ngrowth_rate = 2\n"),
                HasSubstr("fibres.stiffness is 0"));
    EXPECT_THAT(refusal("[map]\nprotomap_seed = 3\n"), HasSubstr("map.protomap_amplitude is 0"));
}

TEST(RemodellingKeys, FilesAndTheirKeysGoTogether)
{
    EXPECT_THAT(refusal("[fibres]\ndirection = \"file\"\nstiffness = 1\n"), HasSubstr("fibres.file is missing"));
    EXPECT_THAT(refusal("[fibres]\ndirection = \"depth\"\nstiffness = 1\nfile = \"v.nii\"\n"),
                HasSubstr("fibres.direction (case.toml:2) is not \"file\""));
    EXPECT_THAT(refusal("[map]\ngrowth_times = [0.1, 0.5]\n"), HasSubstr("got 0 names"));
    EXPECT_THAT(refusal("[map]\ngrowth_file = \"g.csv\"\ngrowth_array = \"a\"\ngrowth_times = [0.1, 0.5]\n"),
                HasSubstr("has 2 times: got 1 names"));
}

TEST(RemodellingKeys, AreNotOfTheThesis)
{
    EXPECT_THAT(refusal("[solver]\nformulation = \"thesis\"\n[relaxation]\nshare = 0.5\n"),
                HasSubstr("knows no history of the tissue"));
}

TEST(RemodellingKeys, AResolvedCaseReadsBack)
{
    const std::string text = "[fibres]\ndirection = \"radial\"\nstiffness = 1\ngrowth_rate = 2\n[relaxation]\nshare = "
                             "0.5\n[map]\nprotomap_amplitude = 0.2\n";
    const std::string resolved = config::to_toml(config::parse_case(text, "case.toml", {}, "/cases"));
    EXPECT_EQ(config::to_toml(config::parse_case(resolved, "case.toml", {}, "/cases")), resolved);
    EXPECT_THAT(resolved, HasSubstr("growth_stretch"));
    EXPECT_THAT(resolved, testing::Not(HasSubstr("shrinks")));
}

} // namespace
} // namespace corticle
