// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/result_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using Files = std::vector<std::string>;

template <class Call>
std::string message_of(Call&& call)
{
    try
    {
        call();
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(ResultFolder, RemovesWhatItWroteAndNothingElse)
{
    const TemporaryFolder place;
    const std::filesystem::path out = place / "out";
    {
        record::ResultFolder folder(out, "run");
        EXPECT_FALSE(std::filesystem::exists(out));
        folder.make();
        folder.claim(Files{"a.csv", "pictures/b.png", "never.txt"});
        formats::write_text_atomically(out / "a.csv", "ours");
        formats::write_text_atomically(out / "pictures/b.png", "ours");
    }
    for (const char* name : {"c.csv", "pictures/d.png", ".x.tmp", ".a.csv.tmp", ".c.csv.12-3.tmp"})
    {
        formats::write_text_atomically(out / name, "mine");
    }
    formats::write_text_atomically(out / ".a.csv.12-3.tmp", "left by a kill");
    record::ResultFolder folder(out, "run");
    EXPECT_TRUE(folder.is_used());
    folder.remove_written();
    EXPECT_FALSE(folder.is_used());
    for (const char* name : {"a.csv", "pictures/b.png", ".a.csv.12-3.tmp"})
    {
        EXPECT_FALSE(std::filesystem::exists(out / name)) << name;
    }
    for (const char* name : {"c.csv", "pictures/d.png", ".x.tmp", ".a.csv.tmp", ".c.csv.12-3.tmp"})
    {
        EXPECT_EQ(bytes_of(out / name), "mine") << name;
    }
}

TEST(ResultFolder, RefusesToReplaceWhatItDidNotWrite)
{
    const TemporaryFolder place;
    formats::write_text_atomically(place / "a.csv", "mine");
    formats::write_text_atomically(place / "pictures", "mine");
    std::filesystem::create_symlink("nowhere", place / "link");
    std::filesystem::create_directory(place / "folder");
    record::ResultFolder folder(place / "", "run");
    for (const char* name : {"a.csv", "link", "folder", "pictures/b.png"})
    {
        const std::string line = message_of([&] { folder.claim(Files{"new", name}); });
        EXPECT_THAT(line, testing::HasSubstr(std::string(name).substr(0, 8)));
        EXPECT_THAT(line, testing::HasSubstr("in the way"));
    }
    EXPECT_FALSE(std::filesystem::exists(place / "corticle-files.txt"));
    folder.claim(Files{"new"});
    formats::write_text_atomically(place / "new", "ours");
    folder.claim(Files{"new"});
    std::filesystem::remove(place / "new");
    std::filesystem::create_directory(place / "new");
    EXPECT_NE(message_of([&] { folder.require_free(Files{"new"}); }), "") << "a folder that took its place";
    folder.remove_written();
    EXPECT_TRUE(std::filesystem::exists(place / "new"));
}

TEST(ResultFolder, BelongsToOneKindAndOneProcess)
{
    const TemporaryFolder place;
    const std::filesystem::path out = place / "out";
    std::optional<record::ResultFolder> first(std::in_place, out, "run");
    std::optional<record::ResultFolder> late(std::in_place, out, "run");
    first->make();
    EXPECT_THAT(message_of([&] { record::ResultFolder(out, "run"); }), testing::HasSubstr("another process"));
    EXPECT_THAT(message_of([&] { late->make(); }), testing::HasSubstr("another process"));
    first->claim(Files{"a"});
    first.reset();
    EXPECT_THAT(message_of([&] { late->make(); }), testing::HasSubstr("meanwhile"));
    late.reset();
    record::ResultFolder(out, "run");
}

TEST(ResultFolder, RefusesFoldersOfAnotherKind)
{
    const TemporaryFolder place;
    record::ResultFolder(place / "", "export").claim(Files{"a"});
    EXPECT_THAT(message_of([&] { record::ResultFolder(place / "", "run"); }), testing::HasSubstr("holds an export"));
}

TEST(ResultFolder, RefusesADamagedOrForeignList)
{
    const TemporaryFolder place;
    record::ResultFolder(place / "", "run").claim(Files{"a"});
    const std::string list = bytes_of(place / "corticle-files.txt");
    for (const std::string& content :
         {std::string("shopping\n"), std::string(), list + "../b\n", list + "/etc/passwd\n", list + "\n"})
    {
        formats::write_text_atomically(place / "corticle-files.txt", content);
        EXPECT_THAT(message_of([&] { record::ResultFolder(place / "", "run"); }),
                    testing::HasSubstr("corticle-files.txt"));
    }
}

TEST(ResultFolder, RefusesNamesThatTheSystemDoesNotTake)
{
    const TemporaryFolder place;
    formats::write_text_atomically(place / "file", "");
    const std::string longest(300, 'x');
    EXPECT_THAT(message_of([&] { record::ResultFolder(place / longest, "run"); }), testing::HasSubstr("too long"));
    EXPECT_THAT(message_of([&] { record::ResultFolder(place / "file", "run"); }), testing::HasSubstr("not a folder"));
    EXPECT_THAT(message_of([&] { record::ResultFolder(place / "file/out", "run"); }),
                testing::HasSubstr("not a folder"));
}

} // namespace corticle
