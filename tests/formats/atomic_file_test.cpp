// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/atomic_file.hpp"

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include <sys/resource.h>

namespace corticle
{

namespace
{

/// Lets no file grow past `bytes`, as a full disk would, until the end of the test.
class FileSizeLimit
{
  public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

} // namespace

TEST(AtomicFile, WritesAndReplacesWhole)
{
    const TemporaryFolder folder;
    formats::write_text_atomically(folder / "a.txt", "first");
    formats::write_text_atomically(folder / "a.txt", std::string("sec\0nd", 6));
    EXPECT_EQ(bytes_of(folder / "a.txt"), std::string("sec\0nd", 6));
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, KeepsTheOldFileWhenWritingFails)
{
    const TemporaryFolder folder;
    formats::write_text_atomically(folder / "a.txt", "old");
    const auto fails_halfway = [](const std::filesystem::path& path)
    {
        put_bytes(path, "half");
        throw std::runtime_error("no more");
    };
    const std::string message =
        message_of<RunError>([&] { formats::write_atomically(folder / "a.txt", fails_halfway); });
    EXPECT_EQ(message, "cannot write " + (folder / "a.txt").string() + ": no more");
    EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, ReportsAFullDisk)
{
    const TemporaryFolder folder;
    formats::write_text_atomically(folder / "a.txt", "old");
    const FileSizeLimit limit(1000);
    const std::string message =
        message_of<RunError>([&] { formats::write_text_atomically(folder / "a.txt", std::string(5000, 'x')); });
    EXPECT_THAT(message, ::testing::StartsWith("cannot write " + (folder / "a.txt").string() + ": File too large"));
    EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, NamesTheReason)
{
    const TemporaryFolder folder;
    EXPECT_THAT(message_of<RunError>([&] { formats::write_text_atomically(folder / "none/a.txt", "x"); }),
                ::testing::HasSubstr("No such file or directory"));
    std::filesystem::create_directory(folder / "a.txt");
    EXPECT_THAT(message_of<RunError>([&] { formats::write_text_atomically(folder / "a.txt", "x"); }),
                ::testing::HasSubstr("directory"));
    EXPECT_EQ(folder.file_count(), 1u);
}

} // namespace corticle
