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

config::Options read(std::string_view text, std::vector<std::string> overrides = {})
{
    return config::parse_case(text, "case.toml", overrides, "");
}

std::string message_of(std::string_view text)
{
    try
    {
        read(text);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "accepted";
}

constexpr std::string_view two_supports = R"([geometry]
shape = "box"
[[support]]
kind = "roller"
plane = "x_min"
[[support]]
kind = "displacement"
plane = "x_max"
displacement_mm = [-1, 0, 0]
end = 0.5
)";

TEST(SupportKeys, EveryTableIsASupport)
{
    const config::Options options = read(two_supports);
    ASSERT_EQ(options.supports.size(), 2u);
    EXPECT_EQ(options.supports[0].kind, boundary::SupportKind::roller);
    EXPECT_EQ(options.supports[1].plane, boundary::Face::x_max);
    EXPECT_EQ(options.supports[1].displacement_mm[0], -1.0);
    EXPECT_EQ(read(two_supports, {"support.2.end=0.75"}).supports[1].end, 0.75);
}

TEST(SupportKeys, AResolvedCaseReadsBackTheSame)
{
    const std::string resolved = config::to_toml(read(two_supports));
    EXPECT_THAT(resolved, HasSubstr("\n[[support]]\nkind = \"roller\"\n"));
    EXPECT_EQ(config::to_toml(read(resolved)), resolved);
}

TEST(SupportKeys, FollowTheWeeksOfAClock)
{
    const config::Options options = read(R"([time]
clock = "wang"
start_week = 23
end_week = 38
[[support]]
kind = "displacement"
plane = "z_max"
start_week = 25
end_week = 30
)");
    EXPECT_EQ(options.supports[0].end, material::growth_time(material::GestationalClock::wang, 30.0));
    EXPECT_EQ(config::to_toml(read(config::to_toml(options))), config::to_toml(options));
}

TEST(SupportKeys, RefuseWhatContradictsItself)
{
    EXPECT_THAT(message_of("[[support]]\nplane = \"x_min\"\n"), HasSubstr("support.1.kind is missing"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"fixed\"\n"), HasSubstr("support.1.plane is missing"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"fixed\"\nplane = \"x_min\"\naxes = \"x\"\n"),
                HasSubstr("along all axes"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"fixed\"\nplane = \"x_min\"\nend = 0.5\n"),
                HasSubstr("support.1.end (case.toml:4) is given"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"roller\"\nlow_mm = [0, 0, 0]\n"),
                HasSubstr("support.1.axes is missing"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"roller\"\nlow_mm = [0, 0, 0]\nhigh_mm = [-1, 0, 0]\naxes = \"x\"\n"),
                HasSubstr("support.1.low_mm (case.toml:3) is out of range"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"displacement\"\nplane = \"x_min\"\nstart = 0.5\nend = 0.5\n"),
                HasSubstr("support.1.end (case.toml:5) is out of range"));
    EXPECT_THAT(message_of("[[support]]\nkind = \"displacement\"\nplane = \"x_min\"\nend_week = 30\n"),
                HasSubstr("time.clock is \"none\""));
    EXPECT_THAT(message_of("[[support]]\nkynd = \"fixed\"\n"), HasSubstr("did you mean support.1.kind?"));
    std::string many;
    for (std::size_t k = 0; k <= boundary::most_supports; ++k)
    {
        many += "[[support]]\nkind = \"fixed\"\nplane = \"x_min\"\n";
    }
    EXPECT_THAT(message_of(many), HasSubstr("expected at most 8"));
}

TEST(BoxKeys, RefuseWhatIsRound)
{
    EXPECT_THAT(message_of("[geometry]\nshape = \"box\"\ngrading = 2.0\n"), HasSubstr("geometry.grading"));
    EXPECT_THAT(message_of("[geometry]\nshape = \"box\"\n[tissue]\nlayer = \"binary\"\nlambda = 0.7\n"),
                HasSubstr("tissue.lambda"));
}

TEST(BoundaryKeys, AResolvedCaseReadsBackTheSame)
{
    for (const std::string_view text :
         {"[boundary]\nshape = \"ellipsoid\"\nkind = \"elastic\"\ntimes = [0, 1]\nscales = [1, 0.9]\n",
          "[boundary]\nfluid = \"constant\"\npressure = 0.2\n", "[geometry]\nparticles = 2000\n"})
    {
        const std::string resolved = config::to_toml(read(text));
        EXPECT_EQ(config::to_toml(read(resolved)), resolved);
    }
}

TEST(BoundaryKeys, RefuseWhatDoesNothingOrContradictsItself)
{
    EXPECT_THAT(message_of("[boundary]\noffset_mm = 3\n"), HasSubstr("boundary.offset_mm (case.toml:2)"));
    EXPECT_EQ(message_of("[boundary]\nshape = \"none\"\noffset_mm = 3\n"), "accepted"); // switched off
    EXPECT_THAT(message_of("[boundary]\nshape = \"file\"\n"), HasSubstr("boundary.file is missing"));
    EXPECT_THAT(message_of("[boundary]\nfluid = \"conserved\"\n"), HasSubstr("a skull that encloses the fluid"));
    EXPECT_THAT(message_of("[boundary]\nshape = \"offset\"\n[contact]\nenabled = false\n"),
                HasSubstr("contact.enabled"));
    EXPECT_THAT(message_of("[boundary]\nshape = \"offset\"\nscales = [1, 2]\n"),
                HasSubstr("has 2 numbers, expected 0"));
    EXPECT_THAT(message_of("[boundary]\nshape = \"offset\"\ntimes = [0, 1]\nscales = [1.5, 2]\n"),
                HasSubstr("got 1.5 at the start"));
    EXPECT_THAT(message_of("[boundary]\nshape = \"offset\"\nstiffness = 2\n"),
                HasSubstr("boundary.kind = \"elastic\""));
    EXPECT_THAT(message_of("[boundary]\nventricle_pressure = 0.1\n"), HasSubstr("tissue.labels.ventricle"));
}

} // namespace
} // namespace corticle
