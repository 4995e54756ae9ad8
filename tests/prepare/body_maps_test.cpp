// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_maps.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/nifti_write.hpp"
#include "corticle/geometry/shapes.hpp"
#include "formats/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A ball of radius 10 mm and a few points in it.
class BodyMapsTest : public ::testing::Test
{
  protected:
    std::string write(std::string_view name, std::string_view text) const
    {
        put_bytes(folder_ / name, text);
        return (folder_ / name).string();
    }

    /// One number a vertex.
    template <class Value>
    std::string vertex_map(std::string_view name, Value&& value) const
    {
        std::string text;
        for (const Vec3& X : ball_.vertices)
        {
            text += fmt::format("{:.17g}\n", static_cast<double>(value(X)));
        }
        return write(name, text);
    }

    /// Labels of a volume of 24³ mm about the origin.
    template <class Label>
    std::string volume_map(std::string_view name, Label&& label) const
    {
        imaging::LabelVolume image{{24, 24, 24}, {Mat3::identity(), {-11.5, -11.5, -11.5}}, {}, {}};
        for (int z = 0; z < 24; ++z)
        {
            for (int y = 0; y < 24; ++y)
            {
                for (int x = 0; x < 24; ++x)
                {
                    image.labels.push_back(label(image.frame.position({double(x), double(y), double(z)})));
                }
            }
        }
        formats::write_nifti(folder_ / name, image);
        return (folder_ / name).string();
    }

    prepare::BodyMaps read(const prepare::MapOptions& options) const
    {
        return prepare::read_body_maps(options, ball_, points_);
    }
    std::string refusal(const prepare::MapOptions& options) const
    {
        return message_of<InputError>([&] { read(options); });
    }

    TemporaryFolder folder_;
    TriangleMesh ball_ = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 1.0);
    std::vector<Vec3> points_{{9.0, 0.0, 0.0}, {-5.0, 1.0, 2.0}, {0.0, 8.0, 0.5}, {3.0, -4.0, -6.0}};
};

} // namespace

TEST_F(BodyMapsTest, NoMapsGiveTheSameGrowthEverywhere)
{
    const prepare::BodyMaps maps = read({});
    EXPECT_EQ(maps.growth, std::vector<double>(points_.size(), 1.0));
    EXPECT_TRUE(maps.thickness.empty());
}

TEST_F(BodyMapsTest, NumbersAreInterpolatedAtTheClosestPoint)
{
    prepare::MapOptions options;
    options.growth_file = vertex_map("growth.csv", [](const Vec3& X) { return 1.0 + 0.05 * X.x; });
    options.thickness_file = vertex_map("thickness.csv", [](const Vec3& X) { return 2.0 + 0.1 * X.z; });
    const prepare::BodyMaps maps = read(options);
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
        // Exact but for the facets, on which the closest point is up to 0.4 mm beside the ray.
        const Vec3 foot = 10.0 * normalized(points_[i]);
        EXPECT_NEAR(maps.growth[i], 1.0 + 0.05 * foot.x, 0.02) << i;
        EXPECT_NEAR(maps.thickness[i], 2.0 + 0.1 * foot.z, 0.04) << i;
    }
}

TEST_F(BodyMapsTest, RegionsTakeTheirFactorFromTheTable)
{
    prepare::MapOptions options;
    options.region_file = vertex_map("regions.csv", [](const Vec3& X) { return X.x > 0.0 ? 2 : 1; });
    options.region_table = write("table.csv", "label,growth\n1,0.5\n2,3\n");
    EXPECT_EQ(read(options).growth, (std::vector<double>{3.0, 0.5, read(options).growth[2], 3.0}));
    const std::vector<double> labels = read(options).region; // 2 where growth is 3
    EXPECT_EQ(labels, (std::vector<double>{2.0, 1.0, labels[2], 2.0}));
    EXPECT_TRUE(read({}).region.empty());
    options.region_file = volume_map("regions.nii.gz", [](const Vec3& X) { return X.y > 0.0 ? 2 : 1; });
    EXPECT_EQ(read(options).growth, (std::vector<double>{read(options).growth[0], 3.0, 3.0, 0.5}));
}

TEST_F(BodyMapsTest, RegionsMayHaveTheirOwnOnsetAndRate)
{
    prepare::MapOptions options;
    options.region_file = vertex_map("regions.csv", [](const Vec3& X) { return X.x > 0.0 ? 2 : 1; });
    options.region_table = write("table.csv", "label,growth\n1,0.5\n2,3\n");
    EXPECT_TRUE(read(options).onset.empty());
    EXPECT_TRUE(read(options).rate.empty());
    options.region_table = write("late.csv", "label,onset,growth\n1,0.25,1\n2,-0.5,1\n");
    prepare::BodyMaps maps = read(options);
    EXPECT_EQ(maps.onset, (std::vector<double>{-0.5, 0.25, maps.onset[2], -0.5}));
    EXPECT_TRUE(maps.rate.empty());
    options.region_table = write("fast.csv", "label,growth,rate\n1,1,2\n2,1,0.5\n");
    maps = read(options);
    EXPECT_EQ(maps.rate, (std::vector<double>{0.5, 2.0, maps.rate[2], 0.5}));
    options.region_table = write("still.csv", "label,growth,rate\n1,1,2\n2,1,0\n");
    EXPECT_NE(refusal(options).find("rate of label 2 is 0"), std::string::npos) << refusal(options);
    options.region_table = write("never.csv", "label,growth,onset\n1,1,2\n2,1,0\n");
    EXPECT_NE(refusal(options).find("onset of label 1 is 2"), std::string::npos) << refusal(options);
}

TEST_F(BodyMapsTest, WhatIsStillDoesNotGrow)
{
    prepare::MapOptions options;
    options.growth_file = vertex_map("growth.csv", [](const Vec3&) { return 2.0; });
    options.still_file = volume_map("still.nii", [](const Vec3& X) { return X.z < -1.0 ? 1 : 0; });
    const std::vector<double> growth = read(options).growth;
    EXPECT_NEAR(growth[1], 2.0, 1e-12);
    EXPECT_EQ(growth[3], 0.0);
}

TEST_F(BodyMapsTest, RefusesInOneLine)
{
    prepare::MapOptions options;
    options.growth_file = write("short.csv", "1\n2\n3\n");
    EXPECT_NE(refusal(options).find(fmt::format("{}", ball_.vertices.size())), std::string::npos);
    options.growth_file = vertex_map("nan.csv", [](const Vec3& X) { return X.x > 9.0 ? std::nan("") : 1.0; });
    EXPECT_FALSE(refusal(options).empty());
    options.growth_file = vertex_map("negative.csv", [](const Vec3& X) { return X.x; });
    EXPECT_NE(refusal(options).find("expected numbers of at least 0"), std::string::npos);
    options = {};
    options.thickness_file = vertex_map("zero.csv", [](const Vec3&) { return 0.0; });
    EXPECT_NE(refusal(options).find("expected numbers above 0"), std::string::npos);
    options = {};
    options.region_file = vertex_map("regions.csv", [](const Vec3& X) { return X.x > 0.0 ? 2 : 1; });
    options.region_table = write("table.csv", "label,growth\n1,0.5\n");
    EXPECT_NE(refusal(options).find("no line for label 2"), std::string::npos);
    options.region_table = write("other.csv", "label,rate\n1,0.5\n2,1\n");
    EXPECT_NE(refusal(options).find("no column growth"), std::string::npos);
    options.region_file = vertex_map("fractions.csv", [](const Vec3&) { return 1.5; });
    EXPECT_NE(refusal(options).find("expected a whole number"), std::string::npos);
}

TEST_F(BodyMapsTest, MapsByVerticesNeedASurface)
{
    prepare::MapOptions options;
    options.growth_file = vertex_map("growth.csv", [](const Vec3&) { return 1.0; });
    EXPECT_NE(message_of<InputError>([&] { prepare::read_body_maps(options, {}, points_); })
                  .find("not made from a surface file"),
              std::string::npos);
}

TEST_F(BodyMapsTest, JudgesAndReportsWhatFallsBetweenThePoints)
{
    prepare::MapOptions options;
    // A number out of range at one vertex that no point is near.
    options.growth_file = vertex_map("spike.csv", [](const Vec3& X) { return X.z > 9.9 ? -1.0 : 1.0; });
    EXPECT_NE(refusal(options).find("holds -1 at vertex"), std::string::npos) << refusal(options);
    // A peak and a region there.
    options.growth_file = vertex_map("peak.csv", [](const Vec3& X) { return X.z > 9.0 ? 3.0 : 1.0; });
    options.region_file = vertex_map("regions.csv", [](const Vec3& X) { return X.z > 9.0 ? 7 : 1; });
    options.region_table = write("table.csv", "label,name,growth\n1,frontal,1\n7,top,2\n9,none,2\n");
    const prepare::BodyMaps maps = read(options);
    EXPECT_THAT(maps.notes, Contains(HasSubstr("map.growth_file: 1 to 3 at")));
    EXPECT_THAT(maps.notes, Contains(HasSubstr("columns not used: name")));
    EXPECT_THAT(maps.notes, Contains(HasSubstr("labels at no point of the body: 7, 9")));
    EXPECT_THAT(maps.warnings, ElementsAre(HasSubstr("extremes fall between the points"),
                                           HasSubstr("1 of its 2 labels fall between the points")));
}

TEST_F(BodyMapsTest, VolumesMustHoldTheBody)
{
    prepare::MapOptions options;
    options.still_file = volume_map("still.nii", [](const Vec3& X) { return X.z > 11.0 ? 1 : 0; });
    EXPECT_THAT(read(options).warnings, ElementsAre(HasSubstr("no point of the body lies in this mask")));
    points_.push_back({40.0, 0.0, 0.0});
    EXPECT_THAT(read(options).warnings, Contains(HasSubstr("1 of 5 points of the body lie outside this volume")));
    points_ = {{40.0, 0.0, 0.0}};
    EXPECT_NE(refusal(options).find("no point of the body lies in this volume"), std::string::npos);
}

} // namespace corticle
