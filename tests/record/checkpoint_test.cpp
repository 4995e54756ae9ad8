// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpoint.hpp"

#include "corticle/base/error.hpp"
#include "formats/random_flips.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hdf5.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

record::Checkpoint sample()
{
    record::Checkpoint checkpoint;
    checkpoint.program_version = "0.1.0";
    checkpoint.case_text = "title = \"a case\"\nnumber = 1\n";
    checkpoint.vectors["position"] = {{1, 2, 3}, {1.0 / 3, -0.0, 1e-310}, {7, 8, 9}};
    checkpoint.vectors["none"] = {};
    checkpoint.scalars["mass"] = {0.1, std::numeric_limits<double>::max(), -std::numeric_limits<double>::infinity()};
    checkpoint.integers["step"] = {std::numeric_limits<std::int64_t>::min(), 12345678901234};
    return checkpoint;
}

} // namespace

TEST(Checkpoint, ComesBackToTheBit)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "checkpoint.h5", sample());
    const record::Checkpoint read = record::read_checkpoint(folder / "checkpoint.h5");
    EXPECT_EQ(read.program_version, sample().program_version);
    EXPECT_EQ(read.case_text, sample().case_text);
    EXPECT_EQ(read.vectors, sample().vectors);
    EXPECT_TRUE(std::signbit(read.vectors.at("position")[1].y));
    EXPECT_EQ(read.scalars, sample().scalars);
    EXPECT_EQ(read.integers, sample().integers);
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Checkpoint, SameStateSameBytes)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "a.h5", sample());
    record::write_checkpoint(folder / "b.h5", sample());
    EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
    record::write_checkpoint(folder / "b.h5", record::Checkpoint{});
    EXPECT_TRUE(record::read_checkpoint(folder / "b.h5").vectors.empty());
}

TEST(Checkpoint, IsAnHdf5File)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "a.h5", sample());
    EXPECT_GT(H5Fis_hdf5((folder / "a.h5").c_str()), 0);
    const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    EXPECT_GT(H5Aexists(file, "magic"), 0);
    EXPECT_GT(H5Lexists(file, "vectors/position", H5P_DEFAULT), 0);
    H5Fclose(file);
}

TEST(Checkpoint, RefusesEveryTruncation)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "a.h5", sample());
    const std::string bytes = bytes_of(folder / "a.h5");
    for (std::size_t size = 0; size < bytes.size(); size += 97)
    {
        put_bytes(folder / "cut.h5", bytes.substr(0, size));
        const std::string message = message_of<InputError>([&] { record::read_checkpoint(folder / "cut.h5"); });
        EXPECT_THAT(message, HasSubstr("cut.h5: ")) << size;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

TEST(Checkpoint, RefusesEveryChangedByte)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "a.h5", sample());
    const std::string bytes = bytes_of(folder / "a.h5");
    for (std::size_t at = 0; at < bytes.size(); at += at < 600 ? 1 : 61)
    {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        put_bytes(folder / "bad.h5", damaged);
        EXPECT_THROW(record::read_checkpoint(folder / "bad.h5"), InputError) << at;
    }
}

TEST(Checkpoint, NoFlippedBitIsReadInSilence)
{
    const TemporaryFolder folder;
    record::write_checkpoint(folder / "a.h5", sample());
    expect_no_silent_flip(folder / "a.h5",
                          [](const std::filesystem::path& file)
                          {
                              const record::Checkpoint read = record::read_checkpoint(file);
                              return std::tuple(read.program_version, read.case_text, read.vectors, read.scalars,
                                                read.integers);
                          });
}

TEST(Checkpoint, RefusesForeignFiles)
{
    const TemporaryFolder folder;
    EXPECT_THAT(message_of<InputError>([&] { record::read_checkpoint(folder / "none.h5"); }),
                HasSubstr("none.h5: cannot be opened"));
    H5Fclose(H5Fcreate((folder / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    EXPECT_THAT(message_of<InputError>([&] { record::read_checkpoint(folder / "foreign.h5"); }),
                HasSubstr("not a checkpoint of this program"));
}

TEST(Checkpoint, KeepsTheEarlierOneWhenWritingFails)
{
    const TemporaryFolder folder;
    record::Checkpoint bad = sample();
    bad.scalars[""] = {1.0}; // HDF5 has no nameless data
    record::write_checkpoint(folder / "a.h5", sample());
    EXPECT_THROW(record::write_checkpoint(folder / "a.h5", bad), RunError);
    EXPECT_EQ(record::read_checkpoint(folder / "a.h5").case_text, sample().case_text);
    EXPECT_EQ(folder.file_count(), 1u);
    EXPECT_THAT(message_of<RunError>([&] { record::write_checkpoint(folder / "none/a.h5", sample()); }),
                HasSubstr("No such file"));
}

} // namespace corticle
