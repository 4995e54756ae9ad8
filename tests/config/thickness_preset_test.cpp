// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/material/thickness_presets.hpp"

#include <gtest/gtest.h>

#include <array>

namespace corticle
{
namespace
{

using Overrides = std::vector<std::string>;

constexpr std::string_view preset_case = "[tissue]\nthickness_preset = \"linear_2.5mm\"\n";

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
        return error.what();
    }
}

TEST(ThicknessPreset, SetsBothNumbers)
{
    const material::TissueOptions linear = parse(preset_case).tissue;
    EXPECT_EQ(linear.thickness_mm, 2.5);
    EXPECT_EQ(linear.thickness_rate_mm, 0.3);
    EXPECT_EQ(parse("").tissue.thickness_mm, material::TissueOptions{}.thickness_mm);
    EXPECT_EQ(parse("[tissue]\nthickness_preset = \"none\"\nthickness_mm = 2\n").tissue.thickness_mm, 2.0);
}

TEST(ThicknessPreset, EveryRowHasItsOwnNameAndASource)
{
    const auto rows = material::thickness_presets();
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        EXPECT_EQ(static_cast<std::size_t>(rows[k].preset), k + 1); // names are read in the order of the enumerators
        EXPECT_FALSE(rows[k].source.empty());
        EXPECT_NE(config::schema_text().find(rows[k].source), std::string::npos);
    }
}

TEST(ThicknessPreset, TheResolvedCaseReadsBack)
{
    const std::string text = config::to_toml(parse(preset_case));
    EXPECT_EQ(text.find("thickness_mm"), std::string::npos);
    EXPECT_EQ(config::to_toml(parse(text)), text);
    EXPECT_EQ(parse(text).tissue.thickness_rate_mm, 0.3);
}

TEST(ThicknessPreset, ExcludesTheNumbers)
{
    EXPECT_EQ(
        refusal("[tissue]\nthickness_preset = \"linear_2.5mm\"\nthickness_mm = 3\n"),
        "tissue.thickness_mm (case.toml:3) is given beside tissue.thickness_preset (case.toml:2): expected one of "
        "them, or thickness_preset = \"none\"");
    EXPECT_NE(refusal(preset_case, {"tissue.thickness_rate_mm=0.1"}).find("tissue.thickness_rate_mm (--set"),
              std::string::npos);
    EXPECT_NE(refusal(preset_case, {"tissue.layer=binary", "tissue.lambda=0.75"}).find("tissue.lambda (--set"),
              std::string::npos);
    EXPECT_NE(refusal("", {"tissue.thickness_preset=thin"}).find("\"linear_2.5mm\""), std::string::npos);
}

TEST(ThicknessPreset, OnTheCommandLineReplacesTheNumbersOfTheFile)
{
    const std::string_view numbers = "[tissue]\nthickness_mm = 3\nthickness_rate_mm = 1\n";
    const material::TissueOptions tissue = parse(numbers, {"tissue.thickness_preset=linear_2.5mm"}).tissue;
    EXPECT_EQ(tissue.thickness_mm, 2.5);
    EXPECT_EQ(tissue.thickness_rate_mm, 0.3);
    EXPECT_EQ(parse(numbers, {"tissue.thickness_preset=none"}).tissue.thickness_mm, 3.0);
    EXPECT_EQ(parse(preset_case, {"tissue.thickness_preset=none", "tissue.thickness_mm=3"}).tissue.thickness_mm, 3.0);
}

} // namespace
} // namespace corticle
