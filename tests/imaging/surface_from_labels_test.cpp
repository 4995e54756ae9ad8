// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/surface_from_labels.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/validate.hpp"
#include "formats/temporary_folder.hpp"
#include "imaging/label_shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

constexpr Vec3 semi_axes{12.0, 10.0, 8.5};
constexpr Vec3 centre{21.0, -35.0, 12.0};
constexpr double exact_volume = 4.0 / 3.0 * std::numbers::pi * 12.0 * 10.0 * 8.5;
const Mat3 flip_x = Mat3::diagonal(-1, 1, 1);

std::int32_t in_ellipsoid(const Vec3& p)
{
    return ellipsoid(p, semi_axes) < 1.0 ? 3 : 0;
}

imaging::LabelVolume plain_image(const std::function<std::int32_t(const Vec3&)>& label)
{
    return label_image(Mat3::identity(), {0.8, 0.8, 0.8}, centre, 17.0, label);
}

Vec3 enclosed_centroid(const TriangleMesh& mesh)
{
    Vec3 moment;
    double volume = 0.0;
    for (const Triangle& t : mesh.triangles)
    {
        const Vec3 a = mesh.vertices[t[0]] - centre;
        const Vec3 b = mesh.vertices[t[1]] - centre;
        const Vec3 c = mesh.vertices[t[2]] - centre;
        const double part = dot(a, cross(b, c));
        moment += part * 0.25 * (a + b + c);
        volume += part;
    }
    return centre + moment / volume;
}

/// Handles of a closed surface of one component.
std::int64_t genus(const TriangleMesh& mesh)
{
    const auto faces = static_cast<std::int64_t>(mesh.triangles.size());
    return (2 - (static_cast<std::int64_t>(mesh.vertices.size()) - faces / 2)) / 2;
}

const imaging::MaskStep& step_of(const imaging::MaskReport& report, const std::string& name)
{
    const auto step = std::find_if(report.steps.begin(), report.steps.end(),
                                   [&](const imaging::MaskStep& candidate) { return candidate.name == name; });
    EXPECT_NE(step, report.steps.end()) << name;
    return *step;
}

struct FrameCase
{
    std::string name;
    Mat3 axes;
    Vec3 edges;
};

class EllipsoidImage : public ::testing::TestWithParam<FrameCase>
{
};

/// Fine detail kept: handles, cavities and parts of a millimetre or two must not be closed away beforehand.
imaging::MaskOptions sharp_options()
{
    imaging::MaskOptions options;
    options.closing_mm = 0.0;
    options.smoothing_mm = 0.6;
    return options;
}

/// An ellipsoid with a handle at its side: a ring of 3 mm through its surface.
std::int32_t with_handle(const Vec3& p)
{
    const Vec3 q{p.x - 12.5, p.y, p.z};
    return in_ellipsoid(p) != 0 || ring_distance(q, 4.0) < 1.5 ? 3 : 0;
}

} // namespace

TEST_P(EllipsoidImage, KeepsVolumeAndPlace)
{
    const FrameCase& frame = GetParam();
    const imaging::LabelVolume image = label_image(frame.axes, frame.edges, centre, 15.0, in_ellipsoid);
    const imaging::ImagedSurface result = imaging::surface_from_labels(image, {});
    geometry::require_valid_surface(result.surface, frame.name); // outward, so for left-handed frames too
    EXPECT_EQ(genus(result.surface), 0);
    const double volume = enclosed_volume(result.surface.vertices, result.surface.triangles);
    EXPECT_NEAR(volume / exact_volume, 1.0, 0.01);
    EXPECT_NEAR(volume / result.report.mask_volume_mm3, 1.0, 0.002); // smoothing does not shrink
    EXPECT_LT(norm(enclosed_centroid(result.surface) - centre), 0.1);
    for (int axis = 0; axis < 3; ++axis)
    {
        EXPECT_NEAR(result.report.extent_mm[axis], 2.0 * semi_axes[axis], 0.8) << axis; // a voxel
    }
    EXPECT_TRUE(result.report.warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Frames, EllipsoidImage,
    ::testing::Values(FrameCase{"Plain", Mat3::identity(), {0.8, 0.8, 0.8}},
                      FrameCase{"Flipped", flip_x, {0.8, 0.8, 0.8}},
                      FrameCase{"Anisotropic", Mat3::identity(), {0.5, 0.8, 1.2}},
                      FrameCase{"Oblique", skew_rotation(0.6), {0.8, 0.8, 0.8}},
                      FrameCase{"ObliqueAnisotropicFlipped", skew_rotation(2.1) * flip_x, {0.5, 0.8, 1.2}}),
    [](const auto& tested) { return tested.param.name; });

TEST(SurfaceFromLabels, IsAsSmoothAsTheEllipsoid)
{
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(in_ellipsoid), {});
    double largest = 0.0;
    double squares = 0.0;
    for (const Vec3& p : result.surface.vertices)
    {
        const Vec3 q = p - centre;
        const double value = ellipsoid(q, semi_axes);
        const double slope = norm({q.x / (144.0 * value), q.y / (100.0 * value), q.z / (72.25 * value)});
        largest = std::max(largest, std::abs(value - 1.0) / slope);
        squares += std::pow((value - 1.0) / slope, 2);
    }
    // Voxel steps are 0.8 mm high; the standard deviation of their rounding is 0.8 / sqrt(12) = 0.23.
    EXPECT_LT(largest, 0.3);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(result.surface.vertices.size())), 0.08);
}

TEST(SurfaceFromLabels, CutsAHandle)
{
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(with_handle), sharp_options());
    geometry::require_valid_surface(result.surface, "cut");
    EXPECT_EQ(result.report.genus_before, 1);
    EXPECT_EQ(result.report.genus, 0);
    EXPECT_EQ(genus(result.surface), 0);
    ASSERT_EQ(result.report.handles.size(), 1U);
    const imaging::HandleChange& change = result.report.handles[0];
    EXPECT_FALSE(change.filled);
    EXPECT_GT(change.place.x, centre.x + 12.0); // on the part of the ring that stands out
    EXPECT_LT(norm(change.place - centre), 19.0);
    EXPECT_GT(step_of(result.report, "handles").removed, 5);
    EXPECT_LT(step_of(result.report, "handles").removed, 60); // about one section of the ring
}

TEST(SurfaceFromLabels, KeepsAHandleWhenAsked)
{
    imaging::MaskOptions options = sharp_options();
    options.remove_handles = false;
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(with_handle), options);
    geometry::require_valid_surface(result.surface, "handle");
    EXPECT_EQ(result.report.genus_before, 1);
    EXPECT_EQ(result.report.genus, 1);
    EXPECT_EQ(genus(result.surface), 1);
    EXPECT_TRUE(result.report.handles.empty());
}

TEST(SurfaceFromLabels, FillsANarrowTunnel)
{
    const auto drilled = [](const Vec3& p) { return std::hypot(p.x, p.y) < 1.2 ? 0 : in_ellipsoid(p); };
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(drilled), sharp_options());
    geometry::require_valid_surface(result.surface, "tunnel");
    EXPECT_EQ(result.report.genus_before, 1);
    EXPECT_EQ(genus(result.surface), 0);
    ASSERT_EQ(result.report.handles.size(), 1U);
    EXPECT_TRUE(result.report.handles[0].filled);
    EXPECT_LT(std::hypot(result.report.handles[0].place.x - centre.x, result.report.handles[0].place.y - centre.y),
              1.2);
    EXPECT_LT(step_of(result.report, "handles").added, 20);
}

TEST(SurfaceFromLabels, ClosingClosesTheTunnelToo)
{
    const auto drilled = [](const Vec3& p) { return std::hypot(p.x, p.y) < 1.2 ? 0 : in_ellipsoid(p); };
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(drilled), {});
    EXPECT_EQ(result.report.genus_before, 0);
    EXPECT_GT(step_of(result.report, "closing").added, 50);
    EXPECT_NEAR(result.report.surface_volume_mm3 / exact_volume, 1.0, 0.01);
}

TEST(SurfaceFromLabels, FillsACavityAndDropsAnIsland)
{
    const auto label = [](const Vec3& p)
    {
        const bool island = norm(p - Vec3{13.0, 13.0, 13.0}) < 2.0;
        return norm(p) < 3.0 ? 5 : (island ? 3 : in_ellipsoid(p));
    };
    imaging::MaskOptions options = sharp_options();
    options.labels = {3};
    const imaging::ImagedSurface result = imaging::surface_from_labels(plain_image(label), options);
    geometry::require_valid_surface(result.surface, "filled");
    EXPECT_NEAR(step_of(result.report, "cavities").added_mm3, 4.0 / 3.0 * std::numbers::pi * 27.0, 6.0);
    EXPECT_NEAR(step_of(result.report, "largest component").removed_mm3, 4.0 / 3.0 * std::numbers::pi * 8.0, 4.0);
    ASSERT_EQ(result.report.warnings.size(), 1U);
    EXPECT_THAT(result.report.warnings[0], HasSubstr("2 components"));
    EXPECT_NEAR(result.report.surface_volume_mm3 / exact_volume, 1.0, 0.01);
}

TEST(SurfaceFromLabels, WarnsOfAMaskAtTheBorder)
{
    const imaging::LabelVolume image = label_image(Mat3::identity(), {0.8, 0.8, 0.8}, centre, 9.0, in_ellipsoid);
    const imaging::ImagedSurface result = imaging::surface_from_labels(image, {});
    geometry::require_valid_surface(result.surface, "cut off");
    ASSERT_EQ(result.report.warnings.size(), 1U);
    EXPECT_THAT(result.report.warnings[0], HasSubstr("touches the border"));
    EXPECT_LT(result.report.surface_volume_mm3, 0.97 * exact_volume);
}

TEST(SurfaceFromLabels, CutsOffAHemisphereOfATiltedBody)
{
    // Two lobes that touch, turned by 10 degrees about z: the plane between them is not x = const.
    const Vec3 right = normalized({std::cos(0.17), std::sin(0.17), 0.0});
    const auto lobes = [&](const Vec3& p)
    {
        const Vec3 lobe = std::copysign(6.5, dot(right, p)) * right;
        const Vec3 d = p - lobe;
        const Vec3 q{dot(right, d), dot(cross({0, 0, 1}, right), d), d.z};
        return ellipsoid(q, {8.0, 12.0, 9.0}) < 1.0 ? 2 : 0;
    };
    const imaging::LabelVolume image = plain_image(lobes);
    imaging::MaskOptions options;
    const double whole = imaging::surface_from_labels(image, options).report.surface_volume_mm3;
    for (const imaging::Hemisphere side : {imaging::Hemisphere::left, imaging::Hemisphere::right})
    {
        options.hemisphere = side;
        const imaging::ImagedSurface result = imaging::surface_from_labels(image, options);
        geometry::require_valid_surface(result.surface, imaging::name_of(side));
        EXPECT_NEAR(result.report.surface_volume_mm3 / whole, 0.5, 0.005) << imaging::name_of(side);
        const double height = dot(right, enclosed_centroid(result.surface) - centre);
        EXPECT_NEAR(height, side == imaging::Hemisphere::right ? 6.2 : -6.2, 0.5);
        for (const Vec3& p : result.surface.vertices)
        {
            EXPECT_GT(std::copysign(1.0, height) * dot(right, p - centre), -0.5); // half a voxel
        }
    }
}

TEST(SurfaceFromLabels, RefusesWhatGivesNoBody)
{
    const imaging::LabelVolume image = plain_image(in_ellipsoid);
    const auto refusal = [&](const imaging::MaskOptions& options)
    { return message_of<InputError>([&] { imaging::surface_from_labels(image, options); }); };
    imaging::MaskOptions options;
    options.labels = {3, 9};
    EXPECT_THAT(refusal(options), HasSubstr("no voxel has label 9; there are 0 ("));
    EXPECT_THAT(
        refusal(options),
        HasSubstr("3 (" + std::to_string(std::count(image.labels.begin(), image.labels.end(), 3)) + " voxels)"));
    options = {};
    options.closing_mm = -1.0;
    EXPECT_THAT(refusal(options), HasSubstr("closing_mm = -1"));
    options = {};
    options.smoothing_mm = std::nan("");
    EXPECT_THAT(refusal(options), HasSubstr("smoothing_mm = nan"));
    const imaging::LabelVolume empty = plain_image([](const Vec3&) { return 0; });
    EXPECT_THAT(message_of<InputError>([&] { imaging::surface_from_labels(empty, {}); }),
                HasSubstr("every voxel is background"));
    imaging::LabelVolume speck = plain_image([](const Vec3&) { return 0; });
    speck.labels[speck.labels.size() / 2] = 1;
    imaging::MaskOptions wide;
    wide.smoothing_mm = 5.0;
    EXPECT_THAT(message_of<InputError>([&] { imaging::surface_from_labels(speck, wide); }),
                HasSubstr("nothing is left"));
}

TEST(SurfaceFromLabels, DoesNotDependOnThreads)
{
    const imaging::LabelVolume image = plain_image(with_handle);
    const int threads = thread_count();
    set_thread_count(1);
    const imaging::ImagedSurface one = imaging::surface_from_labels(image, sharp_options());
    set_thread_count(3);
    const imaging::ImagedSurface three = imaging::surface_from_labels(image, sharp_options());
    set_thread_count(threads);
    EXPECT_EQ(one.surface.vertices, three.surface.vertices);
    EXPECT_EQ(one.surface.triangles, three.surface.triangles);
}

namespace
{

/// Two ellipsoids that do not touch, of labels 2 and 41, beside a place on the way between them.
std::int32_t two_hemispheres(const Vec3& p)
{
    return ellipsoid(p + Vec3{8.0, 0.0, 0.0}, {5.5, 10.0, 8.0}) < 1.0   ? 2
           : ellipsoid(p - Vec3{8.0, 0.0, 0.0}, {5.5, 10.0, 8.0}) < 1.0 ? 41
                                                                        : 0;
}

constexpr double hemisphere_volume = 4.0 / 3.0 * std::numbers::pi * 5.5 * 10.0 * 8.0;

imaging::LabelVolume image_about(const Vec3& place, const std::function<std::int32_t(const Vec3&)>& label)
{
    return label_image(Mat3::identity(), {1.2, 1.2, 1.2}, place, 17.0, label);
}

std::string refusal_of(const imaging::LabelVolume& image, const imaging::MaskOptions& options)
{
    return message_of<InputError>([&] { imaging::surface_from_labels(image, options); });
}

} // namespace

TEST(SurfaceFromLabels, TakesOneOfTwoHemispheresThatDoNotTouch)
{
    const imaging::LabelVolume image = image_about(centre, two_hemispheres);
    for (const imaging::Hemisphere side : {imaging::Hemisphere::left, imaging::Hemisphere::right})
    {
        imaging::MaskOptions options;
        options.hemisphere = side;
        const imaging::ImagedSurface result = imaging::surface_from_labels(image, options);
        EXPECT_NEAR(result.report.surface_volume_mm3 / hemisphere_volume, 1.0, 0.02) << imaging::name_of(side);
        const double x = enclosed_centroid(result.surface).x - centre.x;
        EXPECT_NEAR(x, side == imaging::Hemisphere::right ? 8.0 : -8.0, 0.3);
    }
    const std::string both = refusal_of(image, {});
    EXPECT_THAT(both, HasSubstr("the labels form 2 components"));
    EXPECT_THAT(both, HasSubstr("hemisphere = \"left\" or \"right\" takes one"));
}

TEST(SurfaceFromLabels, AHemisphereIsNotTakenOfOneHemisphere)
{
    const auto right = [](const Vec3& p) { return two_hemispheres(p) == 41 ? 41 : 0; };
    imaging::MaskOptions options;
    for (const imaging::Hemisphere side : {imaging::Hemisphere::left, imaging::Hemisphere::right})
    {
        options.hemisphere = side;
        EXPECT_THAT(refusal_of(image_about({}, right), options), HasSubstr("one hemisphere already"));
    }
    // Both of them, in an image whose origin lies elsewhere.
    const auto warned =
        imaging::surface_from_labels(image_about({60.0, 0.0, 0.0}, two_hemispheres), options).report.warnings;
    ASSERT_EQ(warned.size(), 1U);
    EXPECT_THAT(warned[0], HasSubstr("not between the hemispheres"));
}

TEST(SurfaceFromLabels, RefusesAMaskThatFallsApart)
{
    const imaging::LabelVolume image = plain_image(in_ellipsoid);
    imaging::LabelVolume board = image;
    for (std::size_t k = 0; k < board.labels.size(); ++k)
    {
        const auto at = static_cast<std::int64_t>(k);
        const std::int64_t x = at % board.size[0];
        const std::int64_t y = at / board.size[0] % board.size[1];
        const std::int64_t z = at / (board.size[0] * board.size[1]);
        board.labels[k] = (x + y + z) % 2 == 0 ? board.labels[k] : 0;
    }
    EXPECT_THAT(refusal_of(board, {}), HasSubstr("components that share no face, the largest holds"));
    EXPECT_THAT(refusal_of(board, {}), ::testing::Not(HasSubstr("hemisphere")));
}

TEST(SurfaceFromLabels, RefusesAMaskWithoutBackground)
{
    const auto negative = [](const Vec3& p) { return in_ellipsoid(p) != 0 ? 1 : -1; };
    EXPECT_THAT(refusal_of(plain_image(negative), {}), HasSubstr("label -1 is below 0"));
    const auto filled = [](const Vec3& p) { return in_ellipsoid(p) != 0 ? 1 : 4; };
    EXPECT_THAT(refusal_of(plain_image(filled), {}), HasSubstr("100 % of the voxels on its border have a label"));
    EXPECT_THAT(refusal_of(plain_image(filled), {}), HasSubstr("4 ("));
    imaging::MaskOptions options;
    options.labels = {1};
    EXPECT_EQ(refusal_of(plain_image(negative), options), "");
    EXPECT_EQ(refusal_of(plain_image(filled), options), "");
}

} // namespace corticle
