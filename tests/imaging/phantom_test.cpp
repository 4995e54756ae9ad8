// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/phantom.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/surface_from_labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle
{

namespace
{

imaging::MaskOptions body_options()
{
    imaging::MaskOptions options;
    options.labels = {imaging::phantom_label::cortex, imaging::phantom_label::white, imaging::phantom_label::ventricle,
                      imaging::phantom_label::deep};
    return options;
}

} // namespace

TEST(Phantom, IsAValidBrainOf23Weeks)
{
    const imaging::ImagedSurface result = imaging::surface_from_labels(imaging::make_brain_phantom({}), body_options());
    geometry::require_valid_surface(result.surface, "phantom");
    EXPECT_EQ(result.report.genus_before, 0);
    EXPECT_TRUE(result.report.warnings.empty());
    EXPECT_NEAR(result.report.surface_volume_mm3, 64000.0, 1500.0);
    EXPECT_NEAR(result.report.extent_mm.y, 64.0, 0.8); // a voxel
    const geometry::SurfaceTree tree(result.surface.vertices, result.surface.triangles);
    EXPECT_EQ(tree.winding_number({0.01, 0.02, 0.03}), 1); // the bridge in the depth
    EXPECT_EQ(tree.winding_number({0.01, 20.0, 5.0}), 0);  // the fissure
    EXPECT_EQ(tree.winding_number({0.01, -22.0, 5.0}), 0);
    EXPECT_EQ(tree.winding_number({12.0, 20.0, 5.0}), 1);   // a hemisphere
    EXPECT_EQ(tree.winding_number({-19.0, 3.0, -12.0}), 1); // a temporal lobe
    EXPECT_EQ(tree.winding_number({-24.0, 9.0, -4.5}), 0);  // the Sylvian fissure
}

TEST(Phantom, IsSymmetricAndHasAllTissues)
{
    const imaging::LabelVolume image = imaging::make_brain_phantom({32.0, 1.0});
    for (const std::int32_t label : {0, 1, 2, 3, 5, 7})
    {
        EXPECT_GT(std::count(image.labels.begin(), image.labels.end(), label), 50) << label;
    }
    for (std::size_t row = 0; row < image.labels.size(); row += static_cast<std::size_t>(image.size[0]))
    {
        const auto begin = image.labels.begin() + static_cast<std::ptrdiff_t>(row);
        EXPECT_TRUE(std::equal(begin, begin + image.size[0], std::make_reverse_iterator(begin + image.size[0])));
    }
}

TEST(Phantom, HasLobesThatMirrorEachOther)
{
    const imaging::LabelVolume lobes = imaging::make_phantom_lobes({32.0, 1.0});
    ASSERT_EQ(lobes.size, imaging::make_brain_phantom({32.0, 1.0}).size);
    for (std::size_t k = 0; k < lobes.labels.size(); ++k)
    {
        const auto [x, y, z] =
            std::array{k % lobes.size[0], k / lobes.size[0] % lobes.size[1], k / (lobes.size[0] * lobes.size[1])};
        const std::size_t mirrored = k - x + (lobes.size[0] - 1 - x);
        const Vec3 p = lobes.frame.position({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        ASSERT_TRUE(p.x == 0.0 || (lobes.labels[k] < 10) == (p.x < 0.0)); // RAS: x to the right
        ASSERT_TRUE(p.x >= 0.0 || lobes.labels[mirrored] == lobes.labels[k] + 10);
    }
    for (const std::int32_t lobe : {1, 2, 3, 4})
    {
        EXPECT_GT(std::ranges::count(lobes.labels, lobe), 500) << lobe;
    }
    const auto at = [&](const Vec3& p) // of the phantom of 32 mm
    {
        const Vec3 index = p - lobes.frame.origin;
        const auto number = [](double voxel) { return static_cast<std::int64_t>(std::lround(voxel)); };
        const std::int64_t row = number(index.y) + lobes.size[1] * number(index.z);
        return lobes.labels.at(static_cast<std::size_t>(number(index.x) + lobes.size[0] * row));
    };
    EXPECT_EQ(at({-5.0, 14.0, 2.0}), 1);
    EXPECT_EQ(at({5.0, -14.0, 2.0}), 14);
    EXPECT_EQ(at({-10.0, 0.0, -6.0}), 3);
    EXPECT_EQ(at({6.0, 0.0, 12.0}), 12);
}

TEST(Phantom, RefusesAbsurdSizes)
{
    EXPECT_THROW(imaging::make_brain_phantom({0.0, 0.8}), InputError);
    EXPECT_THROW(imaging::make_brain_phantom({64.0, -1.0}), InputError);
    EXPECT_THROW(imaging::make_brain_phantom({64.0, 0.001}), InputError);
}

} // namespace corticle
