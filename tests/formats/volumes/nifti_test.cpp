// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_write.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "corticle/imaging/surface_from_labels.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/volumes/nifti_samples.hpp"
#include "imaging/label_shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace corticle
{

namespace
{

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using enum formats::NumberType;

imaging::LabelVolume parse(const NiftiSample& sample, std::optional<std::int64_t> volume = {})
{
    return formats::parse_labels({sample.bytes(), {}}, "a.nii", {volume, formats::Coordinates::scanner, {}});
}

std::string refusal(const std::string& bytes, std::optional<std::int64_t> volume = {})
{
    const std::string message = message_of<InputError>(
        [&] {
            formats::parse_labels({bytes, {}}, "a.nii", {volume, formats::Coordinates::scanner, {}});
        });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_THAT(message, HasSubstr("a.nii: "));
    return message;
}
std::string refusal(const NiftiSample& sample, std::optional<std::int64_t> volume = {})
{
    return refusal(sample.bytes(), volume);
}

void expect_near(const imaging::VoxelFrame& a, const imaging::VoxelFrame& b, double tolerance)
{
    for (int column = 0; column < 3; ++column)
    {
        EXPECT_LT(norm(a.linear.column[column] - b.linear.column[column]), tolerance) << column;
    }
    EXPECT_LT(norm(a.origin - b.origin), tolerance);
}

imaging::VoxelFrame oblique_frame(bool flipped)
{
    return {skew_rotation(0.7) * Mat3::diagonal(flipped ? -0.5 : 0.5, 0.8, 1.2), {12.5, -40.0, 7.0}};
}

} // namespace

TEST(Nifti, ReadsEveryTypeVersionAndByteOrder)
{
    const std::vector<std::int32_t> labels = sample_labels();
    for (const bool wide : {false, true})
    {
        for (const bool swapped : {false, true})
        {
            NiftiSample sample = plain_sample(wide, swapped);
            sample.sform(oblique_frame(true));
            const auto expect_labels = [&](const NiftiSample& typed)
            {
                const imaging::LabelVolume image = parse(typed);
                EXPECT_EQ(image.size, (std::array<std::int64_t, 3>{4, 3, 2}));
                EXPECT_EQ(image.labels, labels);
                expect_near(image.frame, oblique_frame(true), 1e-5);
                EXPECT_EQ(formats::parse_labels({formats::gzip(typed.bytes()), {}}, "a.nii.gz").labels, labels);
            };
            expect_labels(sample.data<std::uint8_t>(uint8, labels));
            expect_labels(sample.data<std::int8_t>(int8, labels));
            expect_labels(sample.data<std::int16_t>(int16, labels));
            expect_labels(sample.data<std::uint16_t>(uint16, labels));
            expect_labels(sample.data<std::int32_t>(int32, labels));
            expect_labels(sample.data<std::uint32_t>(uint32, labels));
            expect_labels(sample.data<std::int64_t>(int64, labels));
            expect_labels(sample.data<std::uint64_t>(uint64, labels));
            expect_labels(sample.data<float>(float32, labels));
            expect_labels(sample.data<double>(float64, labels));
        }
    }
}

TEST(Nifti, AppliesSlopeAndIntercept)
{
    std::vector<std::int32_t> stored;
    for (const std::int32_t label : sample_labels())
    {
        stored.push_back(10 * (label - 2));
    }
    NiftiSample sample = plain_sample();
    sample.data<std::int16_t>(int16, stored).real(sample.layout().scl_slope, 0.1).real(sample.layout().scl_inter, 2.0);
    EXPECT_EQ(parse(sample).labels, sample_labels());
}

TEST(Nifti, TakesSformThenQformThenVoxelSizes)
{
    NiftiSample sample = plain_sample();
    const formats::NiftiLayout& at = sample.layout();
    sample.real(at.pixdim, 0.5, 1).real(at.pixdim, 0.8, 2).real(at.pixdim, 1.2, 3);
    // Sizes alone: about the middle of the image, x to the left, as nibabel.
    expect_near(parse(sample).frame, {Mat3::diagonal(-0.5, 0.8, 1.2), {0.75, -0.8, -0.6}}, 1e-6);
    // A quarter turn about z, first voxel at (1, 2, 3), third axis turned over.
    const double half = std::sqrt(0.5);
    sample.code(at.qform_code, 1).real(at.quaternion, half, 2).real(at.pixdim, -1.0);
    sample.real(at.offset, 1.0, 0).real(at.offset, 2.0, 1).real(at.offset, 3.0, 2);
    const imaging::VoxelFrame turned{{{{0, 0.5, 0}, {-0.8, 0, 0}, {0, 0, -1.2}}}, {1, 2, 3}};
    expect_near(parse(sample).frame, turned, 1e-6);
    sample.sform(oblique_frame(false));
    expect_near(parse(sample).frame, oblique_frame(false), 1e-5);
    sample.code(at.sform_code, 0);
    expect_near(parse(sample).frame, turned, 1e-6);
}

TEST(Nifti, ConvertsUnits)
{
    const imaging::VoxelFrame frame{Mat3::diagonal(1, 2, 3), {4, 5, 6}};
    for (const bool wide : {false, true})
    {
        for (const auto& [unit, factor] : {std::pair{1, 1000.0}, {2, 1.0}, {3, 0.001}, {0, 1.0}})
        {
            NiftiSample sample = plain_sample(wide);
            sample.units(unit + 8); // seconds along time
            sample.sform({(1.0 / factor) * frame.linear, frame.origin / factor});
            expect_near(parse(sample).frame, frame, 1e-4);
        }
    }
}

TEST(Nifti, TakesOneVolumeOfMany)
{
    std::vector<std::int32_t> series = sample_labels();
    const std::vector<std::int32_t> other(24, 9);
    series.insert(series.end(), other.begin(), other.end());
    NiftiSample sample = plain_sample();
    sample.dimensions({4, 3, 2, 2}).data<std::int16_t>(int16, series);
    EXPECT_EQ(parse(sample, 0).labels, sample_labels());
    EXPECT_EQ(parse(sample, 1).labels, other);
    EXPECT_THAT(refusal(sample), HasSubstr("which volume?; got 2 volumes"));
    EXPECT_THAT(refusal(sample, 2), HasSubstr("no such volume; got 2; expected 0 to 1"));
    EXPECT_EQ(parse(sample.dimensions({4, 3, 2, 1}), {}).labels, sample_labels());
}

TEST(Nifti, RefusesWhatIsNoLabel)
{
    std::vector<double> values(24, 1.0);
    values[6] = 1.25;
    values[7] = std::nan("");
    NiftiSample sample = plain_sample();
    EXPECT_THAT(refusal(sample.data<float>(float32, values)),
                HasSubstr("2 of 24 voxels are not whole numbers: not an image of labels; got 1.25 at voxel (2, 1, 0)"));
    values[6] = 1.0;
    EXPECT_THAT(refusal(sample.data<float>(float32, values)), HasSubstr("1 of 24 voxels are not whole"));
    values[7] = 3e9;
    EXPECT_THAT(refusal(sample.data<double>(float64, values)), HasSubstr("1 of 24 voxels are beyond 32-bit labels"));
    values[7] = std::numeric_limits<double>::infinity();
    EXPECT_THAT(refusal(sample.data<double>(float64, values)), HasSubstr("1 of 24 voxels are not whole"));
    sample.put(sample.layout().datatype, std::int16_t{128});
    EXPECT_THAT(refusal(sample), HasSubstr("datatype 128"));
}

TEST(Nifti, RefusesBadHeaders)
{
    const formats::NiftiLayout& at = formats::nifti1_layout;
    EXPECT_THAT(refusal(std::string()), HasSubstr("not a NIfTI or MGH file; got 0 bytes"));
    EXPECT_THAT(refusal(std::string("OFF\n0 0 0\n")), HasSubstr("not a NIfTI or MGH file; got the bytes 4f 46 46 0a"));
    EXPECT_THAT(refusal(plain_sample().bytes().substr(0, 200)), HasSubstr("truncated in its header; got 200 bytes"));
    NiftiSample pair = plain_sample();
    pair.put(at.magic + 1, 'i');
    EXPECT_THAT(refusal(pair), HasSubstr("the header of a pair; got no image (.img) beside it"));
    pair.put(at.magic + 1, '?');
    EXPECT_THAT(refusal(pair), HasSubstr("wrong magic"));
    EXPECT_THAT(refusal(plain_sample().dimensions({4, 3})), HasSubstr("not a volume; got 2 dimensions"));
    EXPECT_THAT(refusal(plain_sample().dimensions({4, -3, 2})), HasSubstr("absurd size along axis 2; got -3"));
    EXPECT_THAT(refusal(plain_sample().dimensions({32767, 32767, 32767})), HasSubstr("absurd size along axis 3"));
    EXPECT_THAT(refusal(plain_sample(true).dimensions({1LL << 60, 1LL << 60, 4})),
                HasSubstr("absurd size along axis 1"));
    EXPECT_THAT(refusal(plain_sample().real(at.pixdim, 0.001, 2)),
                HasSubstr("absurd voxel size along axis 2; got 0.001 mm"));
    EXPECT_THAT(refusal(plain_sample().real(at.pixdim, 21.0, 3)),
                HasSubstr("absurd voxel size along axis 3; got 21 mm"));
    EXPECT_THAT(refusal(plain_sample().real(at.pixdim, std::nan(""), 1)), HasSubstr("absurd voxel size"));
    EXPECT_THAT(refusal(plain_sample().sform({{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {}})), HasSubstr("singular affine"));
    EXPECT_THAT(refusal(plain_sample().real(at.vox_offset, 100.0)), HasSubstr("absurd vox_offset; got 100"));
    EXPECT_THAT(refusal(plain_sample().code(at.qform_code, 1).real(at.quaternion, 3.0)), HasSubstr("qform"));
}

TEST(Nifti, RefusesShortData)
{
    const std::string bytes = plain_sample().bytes();
    EXPECT_THAT(refusal(bytes.substr(0, bytes.size() - 1)), HasSubstr("data shorter than announced"));
    EXPECT_THAT(refusal(formats::gzip(bytes.substr(0, bytes.size() - 1))),
                HasSubstr("data shorter than announced; got 23 bytes"));
    const std::string packed = formats::gzip(bytes);
    for (std::size_t size = 2; size < packed.size(); ++size)
    {
        EXPECT_NE(refusal(packed.substr(0, size)), "");
    }
    EXPECT_THAT(refusal(packed.substr(0, packed.size() / 2)), HasSubstr("truncated gzip"));
    std::string damaged = packed;
    damaged[packed.size() / 2] = static_cast<char>(~damaged[packed.size() / 2]);
    EXPECT_THAT(refusal(damaged), ::testing::AnyOf(HasSubstr("damaged gzip"), HasSubstr("truncated gzip")));
    // Two billion voxels announced by a few hundred bytes.
    EXPECT_THAT(refusal(formats::gzip(plain_sample().dimensions({2047, 1023, 1023}).bytes())),
                HasSubstr("shorter than announced"));
}

TEST(Nifti, WritesWhatItReads)
{
    const TemporaryFolder folder;
    for (const bool flipped : {false, true})
    {
        for (const std::int32_t largest : {6, 300, 70000, -5})
        {
            imaging::LabelVolume image{{4, 3, 2}, oblique_frame(flipped), sample_labels(), {}};
            image.labels[5] = largest;
            for (const auto* name : {"a.nii", "a.nii.gz"})
            {
                formats::write_nifti(folder / name, image);
                const imaging::LabelVolume back = formats::read_labels(folder / name);
                EXPECT_EQ(back.size, image.size);
                EXPECT_EQ(back.labels, image.labels);
                expect_near(back.frame, image.frame, 1e-5); // the file has single precision
            }
            // The rotation alone describes the same frame.
            std::string bytes = bytes_of(folder / "a.nii");
            bytes.replace(formats::nifti1_layout.sform_code, 2, 2, '\0');
            expect_near(formats::parse_labels({bytes, {}}, "a.nii").frame, image.frame, 1e-5);
        }
    }
    EXPECT_EQ(bytes_of(folder / "a.nii.gz").substr(0, 2), "\x1f\x8b");
    EXPECT_EQ(folder.file_count(), 2U);
    const imaging::LabelVolume image{{4, 3, 2}, {}, sample_labels(), {}};
    EXPECT_THAT(message_of<InputError>([&] { formats::write_nifti(folder / "a.img", image); }), HasSubstr(".nii.gz"));
}

TEST(Nifti, EllipsoidKeepsItsVolumeThroughAFile)
{
    const Vec3 semi_axes{11.0, 9.0, 8.0};
    const Vec3 centre{5.0, -14.0, 30.0};
    const imaging::LabelVolume image =
        label_image(skew_rotation(1.1) * Mat3::diagonal(1, -1, 1), {0.5, 0.8, 1.2}, centre, 14.0,
                    [&](const Vec3& p) { return ellipsoid(p, semi_axes) < 1.0 ? 4 : 0; });
    NiftiSample sample(true, true);
    sample.dimensions({image.size[0], image.size[1], image.size[2]})
        .sform(image.frame)
        .data<double>(float64, image.labels);
    const imaging::ImagedSurface result =
        imaging::surface_from_labels(formats::parse_labels({formats::gzip(sample.bytes()), {}}, "a.nii.gz"), {{4}, {}});
    const double exact = 4.0 / 3.0 * std::numbers::pi * semi_axes.x * semi_axes.y * semi_axes.z;
    EXPECT_NEAR(result.report.surface_volume_mm3 / exact, 1.0, 0.01);
    Vec3 low = result.surface.vertices[0];
    Vec3 high = low;
    for (const Vec3& p : result.surface.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    EXPECT_LT(norm(0.5 * (low + high) - centre), 0.3); // a fraction of a voxel
}

TEST(Nifti, TakesFieldsOutsideTheStandardAsTheReferenceDoes)
{
    NiftiSample sample = plain_sample();
    const formats::NiftiLayout& at = sample.layout();
    sample.code(at.qform_code, 1).real(at.pixdim, -0.5, 1).real(at.quaternion, 1.0004, 2);
    const imaging::LabelVolume image = parse(sample);
    // A half turn about z, of unit length; sizes are positive.
    expect_near(image.frame, {Mat3::diagonal(-0.5, -1.0, 1.0), {}}, 1e-6);
    EXPECT_THAT(image.notes, ElementsAre(HasSubstr("of the qform has length 1.00039995"),
                                         HasSubstr("pixdim[1] of the header is -0.5")));
    sample.real(at.quaternion, 0.0, 2).real(at.pixdim, -2.0);
    EXPECT_THAT(refusal(sample), HasSubstr("pixdim[0] does not say which way"));
    sample.real(at.pixdim, 3.0);
    EXPECT_THAT(parse(sample).notes, Contains(HasSubstr("pixdim[0] of the header is 3: taken as 1")));
    EXPECT_TRUE(parse(plain_sample().sform(oblique_frame(false))).notes.empty());
    EXPECT_THAT(parse(plain_sample()).notes, ElementsAre(HasSubstr("neither sform nor qform")));
}

TEST(Nifti, AnSformOfZerosGivesWayToTheQform)
{
    NiftiSample sample = plain_sample();
    const formats::NiftiLayout& at = sample.layout();
    sample.code(at.sform_code, 2);
    EXPECT_THAT(refusal(sample), HasSubstr("sform (code 2) is a matrix of zeros; got no qform"));
    sample.code(at.qform_code, 1);
    expect_near(parse(sample).frame, {}, 1e-6);
    EXPECT_THAT(parse(sample).notes, ElementsAre(HasSubstr("the sform (code 2) is a matrix of zeros: the qform")));
    sample.sform({Mat3::diagonal(1, 0, 1), {}});
    EXPECT_THAT(refusal(sample), HasSubstr("sform (code 1): absurd voxel size along axis 2; got 0 mm"));
    sample.sform({Mat3::diagonal(-1, 1, 1), {}});
    EXPECT_THAT(parse(sample).notes, ElementsAre(HasSubstr("disagree about left and right")));
}

TEST(Nifti, SaysWhichUnitItTookAndCanLeaveItAlone)
{
    NiftiSample sample = plain_sample();
    sample.sform({Mat3::diagonal(0.002, 0.002, 0.002), {}}).units(1);
    EXPECT_THAT(parse(sample).notes, ElementsAre(HasSubstr("xyzt_units of the header says metres")));
    sample.sform({Mat3::identity(), {}});
    EXPECT_THAT(refusal(sample), HasSubstr("got 1000 mm (xyzt_units says metres)"));
    const imaging::LabelVolume image =
        formats::parse_labels({sample.bytes(), {}}, "a.nii", {{}, formats::Coordinates::file, {}});
    expect_near(image.frame, {}, 1e-12);
    EXPECT_THAT(image.notes, ElementsAre(HasSubstr("taken as millimetres, since coordinates = file")));
}

TEST(Nifti, ToleratesTheRoundOffOfLargeLabels)
{
    std::vector<double> values(24, 14175.0);
    values[3] = 14175.002;
    NiftiSample sample = plain_sample();
    EXPECT_EQ(parse(sample.data<float>(float32, values)).labels[3], 14175);
    values[3] = 14175.02;
    EXPECT_THAT(refusal(sample.data<double>(float64, values)), HasSubstr("got 14175.02 at voxel (3, 0, 0)"));
    values.assign(24, 1.002);
    EXPECT_THAT(refusal(sample.data<float>(float32, values)), HasSubstr("not whole numbers"));
}

TEST(Nifti, IsKnownByItsNameInEitherCase)
{
    for (const char* name : {"a.nii", "a.NII", "a.nii.gz", "B.NII.GZ", "a.Img", "a.HDR"})
    {
        EXPECT_TRUE(formats::is_volume(name)) << name;
    }
    for (const char* name : {"a.gz", "nii", "a.nii.txt", "a.gii.gz"})
    {
        EXPECT_FALSE(formats::is_volume(name)) << name;
    }
}

} // namespace corticle
