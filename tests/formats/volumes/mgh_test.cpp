// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/mgh_header.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/volumes/mgh_samples.hpp"
#include "formats/volumes/nifti_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

imaging::LabelVolume parse(const MghSample& sample, const formats::VolumeChoice& choice = {})
{
    return formats::parse_labels({sample.bytes(), {}}, "a.mgh", choice);
}

std::string refusal(const MghSample& sample, const formats::VolumeChoice& choice = {})
{
    const std::string message = message_of<InputError>([&] { parse(sample, choice); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
}

} // namespace

TEST(Mgh, ReadsEveryTypePackedOrNot)
{
    const std::vector<std::int32_t> labels = sample_labels();
    MghSample sample;
    for (const MghSample& typed : {sample.numbers<std::uint8_t>(0, labels), sample.numbers<std::int32_t>(1, labels),
                                   sample.numbers<float>(3, labels), sample.numbers<std::int16_t>(4, labels),
                                   sample.numbers<std::uint16_t>(10, labels)})
    {
        const imaging::LabelVolume image = parse(typed);
        EXPECT_THAT(image.size, ElementsAre(4, 3, 2));
        EXPECT_EQ(image.labels, labels);
        EXPECT_TRUE(image.notes.empty());
        EXPECT_EQ(formats::parse_labels({formats::gzip(typed.bytes()), {}}, "a.mgz").labels, labels);
    }
}

/// vox2ras of nibabel 5.0: `MGHImage(...).affine` of these fields.
TEST(Mgh, FrameIsVox2ras)
{
    MghSample sample;
    sample.voxel = {0.5F, 0.8F, 1.25F};
    sample.centre = {5, -18, 20};
    const imaging::VoxelFrame frame = parse(sample).frame;
    EXPECT_LT(norm(frame.position({2, 1.5, 1}) - sample.centre), 1e-5);
    EXPECT_LT(norm(frame.position({0, 0, 0}) - Vec3{6, -19.25, 21.2}), 1e-5);
    EXPECT_LT(norm(frame.linear.column[0] - Vec3{-0.5, 0, 0}), 1e-6);
    EXPECT_LT(norm(frame.linear.column[1] - Vec3{0, 0, -0.8}), 1e-6);
    EXPECT_LT(norm(frame.linear.column[2] - Vec3{0, 1.25, 0}), 1e-6);
}

TEST(Mgh, TellsOfAHeaderWithoutAPlace)
{
    MghSample sample;
    sample.good_ras = 0;
    sample.voxel = {0, 0, 0}; // not to be used
    const imaging::LabelVolume image = parse(sample);
    EXPECT_THAT(image.notes, ElementsAre(HasSubstr("goodRASFlag is 0")));
    EXPECT_LT(norm(image.frame.position({2, 1.5, 1})), 1e-6);
}

TEST(Mgh, TakesOneOfSeveralFrames)
{
    std::vector<std::int32_t> labels = sample_labels();
    labels.insert(labels.end(), 24, 9);
    MghSample sample;
    sample.size[3] = 2;
    sample.numbers<std::int16_t>(4, labels);
    EXPECT_EQ(parse(sample, {1, {}, {}}).labels, std::vector<std::int32_t>(24, 9));
    EXPECT_THAT(refusal(sample), HasSubstr("a 4D image: which volume?; got 2 volumes"));
}

TEST(Mgh, RefusesDamage)
{
    MghSample sample;
    const std::string good = sample.bytes();
    for (std::size_t size = 0; size < good.size(); size += 7)
    {
        EXPECT_THROW(formats::parse_labels({good.substr(0, size), {}}, "cut.mgh"), InputError) << size;
    }
    sample.type = 7;
    EXPECT_THAT(refusal(sample), HasSubstr("type 7; expected uchar"));
    sample.type = 0;
    sample.size = {2000, 2000, 1000, 1};
    EXPECT_THAT(refusal(sample), HasSubstr("absurd size along axis 3"));
    sample.size = {2000, 2000, 500, 1};
    EXPECT_THAT(refusal(sample), HasSubstr("data shorter than announced"));
    sample.size = {4, -3, 2, 1};
    EXPECT_THAT(refusal(sample), HasSubstr("absurd size along axis 2; got -3"));
    sample.size = {4, 3, 2, 1};
    sample.voxel[1] = 1000.0F;
    EXPECT_THAT(refusal(sample), HasSubstr("vox2ras: absurd voxel size along axis 2"));
    sample.voxel[1] = 1.0F;
    sample.axes[1] = sample.axes[0];
    EXPECT_THAT(refusal(sample), HasSubstr("vox2ras: singular affine"));
}

} // namespace corticle
