// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/study/sweep/sweep_runs.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace corticle
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::string_view text = "[geometry]\nshape = \"file\"\nfile = \"brain.stl\"\n"
                                  "[map]\nthickness_file = \"thickness.txt\"\n";

/// Projects in folders of their own: a surface and a map, by content.
class CaseInputs : public ::testing::Test
{
  protected:
    config::Options identified(const std::string& project, std::string_view case_text = text) const
    {
        config::Options options = config::parse_case(case_text, "case.toml", {}, folder_ / project);
        config::identify_inputs(options);
        return options;
    }
    void write(const std::string& project, std::string_view surface, std::string_view map = "2.5") const
    {
        std::filesystem::create_directories(folder_ / project);
        put_bytes(folder_ / project / "brain.stl", surface);
        put_bytes(folder_ / project / "thickness.txt", map);
    }
    TemporaryFolder folder_;
};

} // namespace

TEST_F(CaseInputs, AreTheFilesThatTheCaseNames)
{
    write("a", "surface");
    const config::Options options = identified("a");
    ASSERT_EQ(options.inputs.size(), 2u);
    EXPECT_EQ(options.inputs.at("map.thickness_file").size(), 64u);
    EXPECT_TRUE(identified("a", "").inputs.empty());
}

TEST_F(CaseInputs, ReadBackWithTheResolvedCase)
{
    write("a", "surface");
    const config::Options options = identified("a");
    const std::string resolved = config::to_toml(options);
    const config::Options read = config::parse_case(resolved, "case.toml", {}, "");
    EXPECT_EQ(read.inputs, options.inputs);
    EXPECT_EQ(config::to_toml(read), resolved);
}

TEST_F(CaseInputs, ACaseMovedWithItsFilesIsTheSame)
{
    write("a", "surface");
    write("b", "surface");
    EXPECT_THAT(config::differing_keys(config::to_toml(identified("a")), config::to_toml(identified("b"))), IsEmpty());
    EXPECT_THAT(config::differing_body_keys(config::to_toml(identified("a")), config::to_toml(identified("b"))),
                IsEmpty());
    EXPECT_EQ(sweep::case_identity(identified("a")), sweep::case_identity(identified("b")));
}

TEST_F(CaseInputs, AnotherContentIsAnotherCase)
{
    write("a", "surface");
    const std::string before = config::to_toml(identified("a"));
    const std::string identity = sweep::case_identity(identified("a"));
    write("a", "surface", "2.6");
    const std::string after = config::to_toml(identified("a"));
    EXPECT_THAT(config::differing_keys(before, after),
                ElementsAre(HasSubstr("map.thickness_file: the content of " + (folder_ / "a/thickness.txt").string())));
    EXPECT_THAT(config::differing_body_keys(before, after), ElementsAre(HasSubstr("has changed (SHA-256 ")));
    EXPECT_NE(sweep::case_identity(identified("a")), identity);
}

TEST_F(CaseInputs, WithoutChecksumsTheNameTells)
{
    const auto named = [](const std::string& file)
    {
        return config::to_toml(
            config::parse_case("[geometry]\nshape = \"file\"\nfile = \"" + file + "\"\n", "case.toml", {}, "/"));
    };
    EXPECT_THAT(config::differing_keys(named("a.stl"), named("a.stl")), IsEmpty());
    EXPECT_THAT(config::differing_keys(named("a.stl"), named("b.stl")), ElementsAre("geometry.file: /a.stl -> /b.stl"));
}

TEST_F(CaseInputs, AFileThatIsNotTheOneOfTheCaseIsRefused)
{
    write("a", "surface");
    const std::string resolved = config::to_toml(identified("a"));
    EXPECT_NO_THROW(identified("a", resolved));
    write("a", "another");
    const std::string message = message_of<InputError>([&] { identified("a", resolved); });
    EXPECT_THAT(message, HasSubstr("geometry.file: " + (folder_ / "a/brain.stl").string() + " is not the file that"));
    // Where another file is asked for the checksum of the first says nothing.
    const std::vector<std::string> other{"geometry.file=" + (folder_ / "a/thickness.txt").string()};
    config::Options options = config::parse_case(resolved, "case.toml", other, "");
    EXPECT_NO_THROW(config::identify_inputs(options));
}

TEST_F(CaseInputs, RefuseWhatIsNoChecksum)
{
    const auto refusal = [](const std::string& line)
    { return message_of<InputError>([&] { config::parse_case("[inputs]\n" + line, "case.toml", {}, ""); }); };
    EXPECT_THAT(refusal("\"geometry.file\" = \"abc\"\n"), HasSubstr("inputs \"geometry.file\" (case.toml:2): got"));
    EXPECT_THAT(refusal("\"geometry.file\" = 3\n"), HasSubstr("expected a SHA-256"));
    EXPECT_THAT(refusal("\"geometry.seed\" = \"abc\"\n"), HasSubstr("expected a key that names a file"));
    EXPECT_THAT(refusal("file = \"abc\"\n"), HasSubstr("expected a key that names a file"));
}

} // namespace corticle
