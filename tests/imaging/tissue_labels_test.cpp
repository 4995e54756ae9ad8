// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/tissue_labels.hpp"

#include "corticle/base/error.hpp"
#include "imaging/label_shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle::imaging
{
namespace
{

using material::TissueKind;
using ::testing::HasSubstr;

constexpr double radius = 12.0;
constexpr double inner = 9.5;

/// A ball with a cortical plate (2) of 2.5 mm over white matter (3) with a deep core (7); without plate below z = -6.
std::int32_t ball(const Vec3& p)
{
    const double r = norm(p);
    return r > radius ? 0 : r > inner && p.z > -6.0 ? 2 : r < 4.0 ? 7 : 3;
}

LabelVolume image()
{
    return label_image(Mat3::identity(), {0.8, 0.8, 0.8}, {}, 16.0, ball);
}

TissueLabels labels()
{
    return {std::vector<std::int64_t>{2}, {3}, {7}, {}, {}};
}

TEST(TissueLabels, TellDistancesFromTheInnerBoundaryOfTheCortex)
{
    const TissueReader reader(image(), labels(), {}, 0.5);
    for (const double r : {7.0, 8.5, 9.5, 10.5, 11.8})
    {
        std::vector<Vec3> points;
        for (int k = 0; k < 60; ++k)
        {
            const double z = 0.95 - 0.018 * k; // well above the rim of the plate
            const double turn = 2.4 * k;
            points.push_back(r * Vec3{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
        }
        double mean = 0.0;
        for (const double inside : reader.at(points).cortex_inside)
        {
            EXPECT_NEAR(inside, r - inner, 0.6) << r; // stairs of voxels of 0.8 mm
            mean += inside / 60.0;
        }
        EXPECT_NEAR(mean, r - inner, r == inner ? 0.12 : 0.3) << r; // the nearest of the stairs is nearer
    }
}

TEST(TissueLabels, WhereThereIsNoPlateIsNoCortex)
{
    const TissueReader reader(image(), labels(), {}, 0.5);
    const std::vector<Vec3> points{{0.0, 0.0, -11.9}, {0.0, 0.0, -1.0}, {0.0, 0.0, 7.0}, {0.0, 0.0, 13.0}};
    const LabelledPoints got = reader.at(points);
    EXPECT_LT(got.cortex_inside[0], -3.0);
    EXPECT_GT(got.cortex_inside[3], 2.0); // beyond the surface, by what is nearest
    EXPECT_EQ(got.tissue[0], TissueKind::white);
    EXPECT_EQ(got.tissue[1], TissueKind::deep);
    EXPECT_EQ(got.tissue[2], TissueKind::white);
}

TEST(TissueLabels, OfTheBodyInNoListAreWhiteMatter)
{
    TissueLabels some = labels();
    some[static_cast<std::size_t>(TissueKind::deep)].clear();
    const TissueReader reader(image(), some, {}, 0.5);
    EXPECT_THAT(reader.note, HasSubstr("white matter"));
    const std::vector<Vec3> centre{{0.0, 0.0, 0.0}};
    EXPECT_EQ(reader.at(centre).tissue[0], TissueKind::white);
    EXPECT_TRUE(TissueReader(image(), labels(), {}, 0.5).note.empty());
}

std::string refusal(const TissueLabels& wanted, std::vector<std::int64_t> body = {})
{
    try
    {
        const TissueReader reader(image(), wanted, body, 0.5);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

TEST(TissueLabels, RefuseLabelsThatAreNotThere)
{
    TissueLabels wanted = labels();
    wanted[0] = {99};
    EXPECT_THAT(refusal(wanted), HasSubstr("no voxel has label 99"));
    EXPECT_THAT(refusal(labels(), {3, 7}), HasSubstr("0 voxels of cortex"));
    EXPECT_THAT(refusal(labels(), {2}), HasSubstr("0 of other tissue"));
}

} // namespace
} // namespace corticle::imaging
