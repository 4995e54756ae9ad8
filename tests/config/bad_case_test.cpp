// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"

#include <gtest/gtest.h>

#include <array>

namespace corticle
{

namespace
{

using Overrides = std::vector<std::string>;

/// The message with which a case is refused; empty when it is not.
std::string refusal(std::string_view text, const Overrides& overrides = {})
{
    try
    {
        config::parse_case(text, "case.toml", overrides, "/cases");
        return "";
    }
    catch (const InputError& error)
    {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), 600u) << message;
        return message;
    }
}

void expect_parts(const std::string& message, std::initializer_list<std::string_view> parts)
{
    for (const std::string_view part : parts)
    {
        EXPECT_NE(message.find(part), std::string::npos) << "\"" << message << "\" lacks \"" << part << "\"";
    }
}

std::string repeated(std::string_view part, int count)
{
    std::string result;
    for (int i = 0; i < count; ++i)
    {
        result += part;
    }
    return result;
}

} // namespace

TEST(BadCase, UnknownKeysNameTheNearest)
{
    EXPECT_EQ(refusal("# comment\n\n[geometry]\nraduis_mm = 3\n"),
              "unknown key geometry.raduis_mm (case.toml:4); did you mean geometry.radius_mm?");
    expect_parts(refusal("[solver]\nspacing_mm = 1\n"), {"solver.spacing_mm", "case.toml:2", "geometry.spacing_mm?"});
    expect_parts(refusal("radius_mm = 1\n"), {"radius_mm", "case.toml:1", "geometry.radius_mm?"});
    expect_parts(refusal("[geometry]\nqqqqqqqqqqqqqqqq = 1\n"), {"qqqq", "corticle schema"});
    expect_parts(refusal("[geometry]\n\"new\\nline\" = 1\n"), {"case.toml:2"});
    expect_parts(refusal("", {"tissue.mu_wite=2"}), {"--set tissue.mu_wite=2", "tissue.mu_white?"});
}

TEST(BadCase, UnknownSectionsNameTheNearest)
{
    EXPECT_EQ(refusal("\n[geometri]\n"), "unknown section [geometri] (case.toml:2); did you mean [geometry]?");
    expect_parts(refusal("[zzzzzzzzz]\n"), {"unknown section", "expected geometry"});
}

TEST(BadCase, TheFirstErrorOfTheFileIsReported)
{
    expect_parts(refusal("[time]\nend = 3\n[geometry]\nradius = 1\n"), {"time.end", "case.toml:2"});
}

TEST(BadCase, WrongTypes)
{
    EXPECT_EQ(refusal("[geometry]\nradius_mm = \"12\"\n"),
              "geometry.radius_mm has the wrong type (case.toml:2): got the string \"12\", expected a number in "
              "(0, 1000] mm");
    expect_parts(refusal("[geometry]\nparticles = 1000.0\n"), {"got 1000.0", "an integer"});
    expect_parts(refusal("[geometry]\nfile = 3\n"), {"got the integer 3", "a string"});
    expect_parts(refusal("[geometry]\nshape = true\n"), {"got true", "\"sphere\" or \"ellipsoid\""});
    expect_parts(refusal("[geometry]\nradius_mm = 2020-01-01\n"), {"got a date"});
    expect_parts(refusal("[geometry]\nradius_mm = {a = 1}\n"), {"got a table"});
    expect_parts(refusal("[contact]\nenabled = 1\n"), {"true or false"});
    expect_parts(refusal("[output]\ntimes = 0.5\n"), {"got 0.5", "a list"});
    expect_parts(refusal("[output]\ntimes = [0.1, \"b\"]\n"), {"list of other things"});
    expect_parts(refusal("geometry = 3\n"), {"geometry", "a section"});
    expect_parts(refusal("[[expect]]\n"), {"expect", "a section"});
    expect_parts(refusal("[[geometry]]\nseed = 1\n"), {"geometry", "list of tables", "a section"});
}

TEST(BadCase, OutOfRange)
{
    for (const std::string value : {"0", "-1", "1e9", "nan", "inf", "-inf", "+nan"})
    {
        expect_parts(refusal("[geometry]\nradius_mm = " + value + "\n"),
                     {"out of range", "case.toml:2", "(0, 1000] mm"});
    }
    expect_parts(refusal("[geometry]\nshape = \"cube\"\n"), {"\"cube\"", "\"file\""});
    expect_parts(refusal("[solver]\nmethod = \"mpm\"\n"), {"\"mpm\"", "\"tlsph\"", "\"fem\""});
    expect_parts(refusal("[geometry]\nsemi_axes_mm = [1, 2]\n"), {"list of 3 numbers"});
    expect_parts(refusal("[geometry]\nsemi_axes_mm = [1, 2, nan]\n"), {"out of range"});
    expect_parts(refusal("[output]\ntimes = [0.5, 0.5]\n"), {"increasing"});
    expect_parts(refusal("[output]\ntimes = [0.5, 1.5]\n"), {"[0, 1]"});
    expect_parts(refusal("[geometry]\nseed = -1\n"), {">= 0"});
    expect_parts(refusal("", {"time.end=1.5"}), {"--set time.end=1.5", "(0, 1]"});
}

TEST(BadCase, ParticlesAndSpacing)
{
    expect_parts(refusal("[geometry]\nparticles = 1000\nspacing_mm = 1.0\n"),
                 {"case.toml:2", "case.toml:3", "both given"});
    expect_parts(refusal("", {"geometry.particles=1000", "geometry.spacing_mm=1"}), {"both given"});
    expect_parts(refusal("[geometry]\nparticles = 499\n"), {"[500, 100000000]"});
    expect_parts(refusal("[geometry]\nspacing_mm = 5.0\n"), {"case.toml:2", "particles", "500"});
    expect_parts(refusal("[geometry]\nspacing_mm = 0.01\n"), {"case.toml:2", "particles", "100000000"});
}

TEST(BadCase, ShapesAndFiles)
{
    expect_parts(refusal("[geometry]\nshape = \"file\"\n"), {"geometry.file", "missing", "case.toml:2"});
    expect_parts(refusal("[geometry]\nfile = \"a.stl\"\n"), {"geometry.file (case.toml:2)", "sphere"});
    expect_parts(refusal("[geometry]\nshape = \"file\"\nfile = \"a\\u0000b\"\n"), {"expected a path"});
    expect_parts(refusal("[geometry]\nshape = \"ellipsoid\"\nsemi_axes_mm = [100, 1, 1]\n"), {"ratio of 100"});
}

TEST(BadCase, KeysOfABodyFromAFile)
{
    expect_parts(refusal("[geometry]\nlabels = [2, 3]\n"), {"geometry.labels (case.toml:2)", "shape = \"file\""});
    expect_parts(refusal("[geometry]\nlabels = [2.5]\n"), {"geometry.labels", "wrong type", "a list of integers"});
    expect_parts(refusal("[geometry]\nhemisphere = \"left\"\n"), {"geometry.hemisphere", "sphere"});
    expect_parts(refusal("[geometry]\nrepair = \"wrap\"\n"), {"geometry.repair", "sphere"});
    expect_parts(refusal("[geometry]\nrepair = \"mend\"\n"), {"geometry.repair", "wrap"});
    expect_parts(refusal("[geometry]\narrangement = \"thinned\"\n"), {"geometry.arrangement", "sphere"});
}

TEST(BadCase, Maps)
{
    expect_parts(refusal("[map]\nregion_file = \"a.csv\"\n"), {"map.region_file (case.toml:2)", "map.region_table"});
    expect_parts(refusal("[map]\nregion_table = \"a.csv\"\n"), {"map.region_table (case.toml:2)", "map.region_file"});
    expect_parts(refusal("[map]\ngrowth_file = 3\n"), {"map.growth_file", "a string"});
    expect_parts(refusal("[map]\ngrowth_file = \"a\\u0000b\"\n"), {"map.growth_file", "expected a path"});
}

TEST(BadCase, Tissue)
{
    expect_parts(refusal("[tissue]\nlambda = 0.5\n"), {"tissue.lambda (case.toml:2)", "binary"});
    expect_parts(refusal("[tissue]\nthickness_rate_mm = -2\n"), {"thickness_rate_mm (case.toml:2)", "more than 0"});
}

TEST(BadCase, Overrides)
{
    for (const std::string text : {"", "time.end", "=", "=3", "time=3", "time.end=", "time.end=1 2", "time.end=1\nx=2"})
    {
        EXPECT_NE(refusal("", {text}), "") << text;
    }
}

TEST(BadCase, SyntaxErrorsNameTheLine)
{
    expect_parts(refusal("[geometry]\nseed = \n"), {"case.toml:", "not TOML"});
    expect_parts(refusal("[geometry]\nseed = 1\nseed = 2\n"), {"case.toml:3", "not TOML"});
    expect_parts(refusal("[geometry]\n[geometry]\n"), {"case.toml:2"});
    expect_parts(refusal("[geometry]\nseed = 99999999999999999999999\n"), {"case.toml:2"});
    expect_parts(refusal(std::string_view("\0\0\0", 3)), {"case.toml"});
    expect_parts(refusal("[geometry]\nfile = \"\xff\xfe\"\n"), {"case.toml"});
}

TEST(BadCase, DeepAndLongTextIsRefusedNotFollowed)
{
    EXPECT_NE(refusal("a = " + repeated("[", 100000)), "");
    EXPECT_NE(refusal("a = " + repeated("{a = ", 100000)), "");
    EXPECT_NE(refusal("[" + repeated("a.", 200000) + "a]\n"), "");
    EXPECT_NE(refusal(repeated("1.", 200000) + "1 = 1\n"), "");
    EXPECT_NE(refusal(repeated("1.1 . ", 100000) + "1 = 1\n"), "");
    EXPECT_NE(refusal(repeated("\"1\".", 200000) + "1 = 1\n"), "");
    EXPECT_NE(refusal("a = " + repeated("[\n{" + repeated("a.", 100) + "a = ", 250)), "");
    EXPECT_NE(refusal(repeated("# filler\n", 200000)), "");
    EXPECT_NE(refusal("[geometry]\n" + std::string(500000, 'k') + " = 1\n"), "");
    EXPECT_NE(refusal("", {"output.times=" + repeated("[", 100000)}), "");
}

TEST(BadCase, FilesThatAreNone)
{
    EXPECT_THROW(config::read_case("no_such_case.toml", {}), InputError);
    EXPECT_THROW(config::read_case(std::filesystem::temp_directory_path(), {}), InputError);
    EXPECT_THROW(config::read_case("/dev/zero", {}), InputError);
    EXPECT_THROW(config::read_case("", {}), InputError);
}

} // namespace corticle
