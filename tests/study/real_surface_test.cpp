// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/real_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/nifti_write.hpp"
#include "corticle/metrics/surface_measures.hpp"
#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace corticle
{
namespace
{

/// A ball of label 2 in a shell of label 1, voxels of 0.8 mm.
imaging::LabelVolume ball(double radius)
{
    constexpr double voxel = 0.8;
    constexpr std::int64_t size = 40;
    imaging::LabelVolume image;
    image.size = {size, size, size};
    image.frame.linear = voxel * Mat3::identity();
    for (std::int64_t k = 0; k < size * size * size; ++k)
    {
        const Vec3 index{static_cast<double>(k % size), static_cast<double>(k / size % size),
                         static_cast<double>(k / (size * size))};
        const double distance = voxel * norm(index - Vec3{19.5, 19.5, 19.5});
        image.labels.push_back(distance <= radius ? 2 : distance <= radius + 3.0 ? 1 : 0);
    }
    return image;
}

TEST(RealSurface, LabelsAreMeasuredAsTheBodyTheyShow)
{
    constexpr double radius = 11.0;
    const TemporaryFolder folder;
    const imaging::LabelVolume image = ball(radius);
    const double labelled = 0.8 * 0.8 * 0.8 * static_cast<double>(std::ranges::count(image.labels, 2));
    formats::write_nifti(folder / "ball.nii.gz", image);
    study::RealSurfaceOptions options;
    options.mask.labels = {2};
    const study::RealSurfaceReading reading = study::read_real_surface(folder / "ball.nii.gz", options);
    EXPECT_DOUBLE_EQ(reading.voxel_mm, static_cast<double>(0.8F)); // single precision in the file
    const TriangleMesh& surface = reading.surface;
    const metrics::SurfaceMeasures m = metrics::measure_surface(surface.vertices, surface.triangles);
    EXPECT_NEAR(m.volume_mm3 / labelled, 1.0, 0.002);
    EXPECT_NEAR(m.area_mm2 / (4.0 * std::numbers::pi * radius * radius), 1.0, 0.03); // steps of voxels remain
    for (const double extent : {m.length_mm, m.width_mm, m.height_mm})
    {
        EXPECT_NEAR(extent, 2.0 * radius, 0.8); // a voxel
    }
}

double value_of(const std::vector<metrics::SurfaceRow>& rows, std::string_view key)
{
    return std::ranges::find(rows, key, &metrics::SurfaceRow::key)->value;
}

TEST(RealSurface, StairsOfVoxelsAreNoFolds)
{
    const TemporaryFolder folder;
    imaging::LabelVolume image = ball(11.0);
    formats::write_nifti(folder / "ball.nii.gz", image);
    const study::RealSurfaceReading reading = study::read_real_surface(folder / "ball.nii.gz", {});
    EXPECT_EQ(value_of(study::surface_rows(reading), "fold_wavelength_mm"), 0.0);
}

TEST(RealSurface, WarnsAsABodyOfTheSameLabelsDoes)
{
    const TemporaryFolder folder;
    imaging::LabelVolume image = ball(9.0);
    image.labels[0] = 1; // a speck at the corner
    formats::write_nifti(folder / "ball.nii.gz", image);
    const study::RealSurfaceReading reading = study::read_real_surface(folder / "ball.nii.gz", {});
    EXPECT_EQ(reading.warnings.size(), 2U); // border, components
    std::ranges::replace(image.labels, 0, -1);
    formats::write_nifti(folder / "negative.nii.gz", image);
    const std::string message =
        message_of<InputError>([&] { study::read_real_surface(folder / "negative.nii.gz", {}); });
    EXPECT_NE(message.find("negative.nii.gz: label image: label -1 is below 0"), std::string::npos) << message;
}

TEST(RealSurface, RefusesInOneLine)
{
    const TemporaryFolder folder;
    formats::write_nifti(folder / "ball.nii.gz", ball(5.0));
    study::RealSurfaceOptions options;
    options.mask.labels = {7};
    EXPECT_NE(message_of<InputError>([&] { study::read_real_surface(folder / "ball.nii.gz", options); }).find('7'),
              std::string::npos);
    put_bytes(folder / "ball.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    const std::string message = message_of<InputError>([&] { study::read_real_surface(folder / "ball.off", options); });
    EXPECT_NE(message.find("--labels"), std::string::npos) << message;
    options.mask.labels.clear();
    EXPECT_EQ(study::read_real_surface(folder / "ball.off", options).surface.triangles.size(), 4U);
}

} // namespace
} // namespace corticle
