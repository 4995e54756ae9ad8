// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/volume_reader.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/companion_files.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/volumes/nifti_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace corticle
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using enum formats::NumberType;

/// Header and data of a pair of files.
struct PairSample
{
    std::string header;
    std::string image;
};

PairSample pair_sample(bool wide)
{
    NiftiSample sample = plain_sample(wide, false);
    sample.put(sample.layout().magic + 1, 'i');
    wide ? sample.put(sample.layout().vox_offset, std::int64_t{0}) : sample.put(sample.layout().vox_offset, 0.0F);
    const std::string bytes = sample.bytes();
    return {bytes.substr(0, sample.layout().size), bytes.substr(bytes.size() - sample_labels().size())};
}

std::string reading_error(const std::filesystem::path& file)
{
    const std::string message = message_of<InputError>([&] { formats::read_labels(file); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
}

} // namespace

TEST(VolumeReader, KnowsImagesByTheirNames)
{
    for (const char* name : {"a.nii", "A.NII.GZ", "a.hdr", "a.img.gz", "a.IMG", "orig.mgz", "a.MGH", "a.mgh.gz"})
    {
        EXPECT_TRUE(formats::is_volume(name)) << name;
    }
    for (const char* name : {"a.gii", "a.gz", "nii", "lh.white", "a.stl.gz"})
    {
        EXPECT_FALSE(formats::is_volume(name)) << name;
    }
}

TEST(VolumeReader, ReadsPairsByEitherName)
{
    for (const bool wide : {false, true})
    {
        const TemporaryFolder folder;
        const PairSample pair = pair_sample(wide);
        put_bytes(folder / "a.hdr", pair.header);
        put_bytes(folder / "a.img", pair.image);
        put_bytes(folder / "b.HDR.gz", formats::gzip(pair.header));
        put_bytes(folder / "b.img.gz", formats::gzip(pair.image));
        for (const char* name : {"a.hdr", "a.img", "b.HDR.gz", "b.img.gz"})
        {
            EXPECT_EQ(formats::read_labels(folder / name).labels, sample_labels()) << name;
        }
        EXPECT_THAT(formats::companion_files(folder / "a.hdr"), ElementsAre(folder / "a.img"));
        const std::string before = formats::sha256_with_companions(folder / "a.hdr");
        put_bytes(folder / "a.img", std::string(pair.image.size(), '\1'));
        EXPECT_NE(formats::sha256_with_companions(folder / "a.hdr"), before);
        put_bytes(folder / "a.img", pair.image.substr(1));
        EXPECT_THAT(reading_error(folder / "a.hdr"), HasSubstr("data shorter than announced; got at most 23 bytes"));
        std::filesystem::remove(folder / "a.img");
        EXPECT_THAT(reading_error(folder / "a.hdr"), HasSubstr("the header of a pair; got no image (.img) beside it"));
        std::filesystem::rename(folder / "a.hdr", folder / "c.img");
        EXPECT_THAT(reading_error(folder / "c.img"), HasSubstr("the image of a pair; got no header (.hdr) beside it"));
    }
}

TEST(VolumeReader, RefusesAnalyzeByName)
{
    const TemporaryFolder folder;
    PairSample pair = pair_sample(false);
    pair.header.replace(344, 4, std::string(4, '\0'));
    pair.header[38] = 'r';
    put_bytes(folder / "a.hdr", pair.header);
    put_bytes(folder / "a.img", pair.image);
    EXPECT_THAT(reading_error(folder / "a.img"), HasSubstr("ANALYZE 7.5"));
}

TEST(VolumeReader, ThresholdMakesLabelsOfProbabilities)
{
    std::vector<double> values(24, 0.1);
    values[3] = 0.5;
    values[4] = 0.49;
    values[5] = 1.0;
    values[6] = std::numeric_limits<double>::quiet_NaN();
    NiftiSample sample = plain_sample();
    sample.data<float>(float32, values);
    const std::string bytes = sample.bytes();
    const imaging::LabelVolume image =
        formats::parse_labels({bytes, {}}, "p.nii", {{}, formats::Coordinates::scanner, 0.5});
    std::vector<std::int32_t> expected(24, 0);
    expected[3] = expected[5] = 1;
    EXPECT_EQ(image.labels, expected);
    EXPECT_THAT(image.notes, ::testing::Contains(HasSubstr("1 of 24 voxels are no numbers (NaN)")));
    EXPECT_THAT(message_of<InputError>(
                    [&] {
                        formats::parse_labels({bytes, {}}, "p.nii");
                    }),
                HasSubstr("geometry.threshold takes a map of probabilities"));
}

/// A megabyte of gzip that holds a gigabyte of zeros takes the time to read it, and no memory.
TEST(VolumeReader, ZerosTakeNoMemory)
{
    NiftiSample sample(true, false);
    sample.dimensions({1024, 1024, 512}).data<std::uint8_t>(uint8, std::vector<int>{});
    const std::string packed = formats::gzip(sample.bytes() + std::string(std::size_t{1} << 29, '\0'));
    EXPECT_LT(packed.size(), std::size_t{1} << 20);
    EXPECT_THAT(message_of<InputError>(
                    [&] {
                        formats::parse_labels({packed, {}}, "zeros.nii.gz");
                    }),
                HasSubstr("zeros.nii.gz: an image of nothing; got 536870912 voxels of 0"));
}

TEST(VolumeReader, ReadsArchivesOfSeveralMembersAndRefusesBrokenOnes)
{
    const std::string bytes = plain_sample().bytes();
    const std::string packed = formats::gzip(bytes);
    const std::string two = formats::gzip(bytes.substr(0, 100)) + formats::gzip(bytes.substr(100));
    EXPECT_EQ(formats::parse_labels({two, {}}, "a.nii.gz").labels, sample_labels());
    EXPECT_EQ(formats::parse_labels({packed + "trailing rubbish", {}}, "a.nii.gz").labels, sample_labels());
    for (std::size_t size = 2; size < packed.size(); ++size)
    {
        EXPECT_THROW(formats::parse_labels({packed.substr(0, size), {}}, "a.nii.gz"), InputError) << size;
    }
}

} // namespace corticle
