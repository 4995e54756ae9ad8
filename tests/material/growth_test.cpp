// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/growth.hpp"

#include "corticle/material/tissue.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include "material/own_tissue.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

const Mat3 sheared{{{1.3, 0.1, -0.2}, {0.4, 0.8, 0.1}, {-0.1, 0.3, 1.1}}};
const Vec3 oblique = Vec3{1, 2, 2} / 3.0;

/// A tissue of one particle in pure cortex.
test::OwnTissue cortex()
{
    test::OwnTissue tissue;
    tissue.depth = {0.0};
    tissue.volume = {1.0};
    tissue.normal = {oblique};
    tissue.regional_rate = {0.8};
    tissue.theta = {1.0};
    tissue.options.alpha_t = 1.5;
    return tissue;
}

TEST(GrowthCourse, LinearIsTWithItsDefaults)
{
    const material::GrowthCourse course;
    for (const double t : {0.0, 0.1, 0.7, 1.0})
    {
        EXPECT_EQ(course.value(t), t);
        EXPECT_EQ(course.slope(t), 1.0);
    }
    const material::GrowthCourse late{material::GrowthLaw::linear, 0.4, 2.0};
    EXPECT_EQ(late.value(0.3), 0.0);
    EXPECT_EQ(late.slope(0.3), 0.0);
    EXPECT_DOUBLE_EQ(late.value(0.6), 0.4);
}

TEST(GrowthCourse, GompertzHasTheLinearCourseForItsSteepestTangent)
{
    const material::GrowthCourse course{material::GrowthLaw::gompertz, 0.2, 3.0};
    double steepest = 0.0;
    double steepest_at = 0.0;
    for (int k = 0; k <= 20000; ++k)
    {
        const double t = -0.5 + 2.5 * k / 20000.0;
        const double h = 1e-6;
        EXPECT_NEAR(course.slope(t), (course.value(t + h) - course.value(t - h)) / (2.0 * h), 1e-8);
        EXPECT_GE(course.slope(t), 0.0);
        if (course.slope(t) > steepest)
        {
            steepest = course.slope(t);
            steepest_at = t;
        }
    }
    EXPECT_NEAR(steepest, 3.0, 1e-6);
    EXPECT_NEAR(course.value(steepest_at) - 3.0 * (steepest_at - 0.2), 0.0, 1e-3);
    EXPECT_NEAR(course.value(5.0), 1.0, 1e-12);
    EXPECT_LT(course.value(-0.5), 1e-12);
}

TEST(GrowthTensor, HasTheTwoRatiosForItsPrincipalStretches)
{
    const Mat3 inverse_G = material::inverse_growth_tensor(1.3, oblique, 1.1);
    const Vec3 tangent = Vec3{2, 1, -2} / 3.0;
    EXPECT_LT(norm(inverse_G * oblique - oblique / 1.1), 1e-15);
    EXPECT_LT(norm(inverse_G * tangent - tangent / 1.3), 1e-15);
    EXPECT_NEAR(1.0 / determinant(inverse_G), 1.3 * 1.3 * 1.1, 1e-14);
    EXPECT_LT(
        test::largest_difference(material::inverse_growth_tensor(1.2, oblique, 1.2), (1.0 / 1.2) * Mat3::identity()),
        1e-15);
}

TEST(PolarRotation, IsARotationThatLeavesASymmetricPositiveStretch)
{
    for (const Mat3& F : {sheared, 100.0 * sheared, sheared * Mat3::diagonal(1e-3, 1.0, 5.0),
                          test::rotation(oblique, 3.0) * Mat3::diagonal(0.2, 4.0, 1.0)})
    {
        const Mat3 R = polar_rotation(F);
        EXPECT_LT(test::largest_difference(transpose(R) * R, Mat3::identity()), 1e-14);
        EXPECT_GT(determinant(R), 0.0);
        const Mat3 U = transpose(R) * F;
        EXPECT_LT(test::largest_difference(U, transpose(U)), 1e-13 * std::sqrt(contract(F, F)));
        EXPECT_GT(U(0, 0), 0.0);
        EXPECT_GT(trace(cofactor(U)), 0.0);
    }
}

TEST(CurrentNormal, IsThatOfTheDeformedSurfaceTurnedBack)
{
    // Two tangents carried by F span the deformed surface; R takes the growth normal to its normal.
    const Vec3 n = material::current_normal(sheared, oblique);
    EXPECT_NEAR(norm(n), 1.0, 1e-15);
    const Vec3 there = polar_rotation(sheared) * n;
    EXPECT_NEAR(dot(there, sheared * (Vec3{2, 1, -2} / 3.0)), 0.0, 1e-14);
    EXPECT_NEAR(dot(there, sheared * (Vec3{2, -2, 1} / 3.0)), 0.0, 1e-14);
    EXPECT_GT(dot(there, sheared * oblique), 0.0);
    EXPECT_GT(norm(n - oblique), 0.05); // shear turns it
}

TEST(CurrentNormal, DoesNotSeeRotationsNorStretchesAlongTheNormal)
{
    const Mat3 Q = test::rotation(Vec3{2, -1, 2} / 3.0, 1.1);
    EXPECT_LT(norm(material::current_normal(Q * sheared, oblique) - material::current_normal(sheared, oblique)), 1e-14);
    const Mat3 stretch = 1.4 * Mat3::identity() + (0.7 - 1.4) * outer(oblique, oblique);
    EXPECT_LT(norm(material::current_normal(Q * stretch, oblique) - oblique), 1e-14);
}

TEST(Growth, HasTangentialRadialAndWhiteParts)
{
    test::OwnTissue tissue = cortex();
    EXPECT_TRUE(tissue.grows_plainly());
    EXPECT_DOUBLE_EQ(tissue.point(0, 0.5).growth, 1.0 + 1.5 * 0.8 * 0.5);
    EXPECT_EQ(tissue.point(0, 0.5).radial_growth, 1.0);
    tissue.options.alpha_r = 0.5;
    tissue.options.alpha_white = 0.2;
    tissue.theta = {0.75};
    EXPECT_FALSE(tissue.grows_plainly());
    const material::MaterialPoint point = tissue.point(0, 0.5);
    EXPECT_DOUBLE_EQ(point.growth, 1.0 + (1.5 * 0.75 + 0.2 * 0.25) * 0.8 * 0.5);
    EXPECT_DOUBLE_EQ(point.radial_growth, 1.0 + (0.5 * 0.75 + 0.2 * 0.25) * 0.8 * 0.5);
}

TEST(Growth, RegionsHaveTheirOwnOnsetAndRate)
{
    test::OwnTissue tissue = cortex();
    tissue.growth_onset = {0.3};
    tissue.growth_rate = {2.0};
    EXPECT_FALSE(tissue.grows_plainly());
    EXPECT_EQ(tissue.point(0, 0.2).growth, 1.0);
    EXPECT_DOUBLE_EQ(tissue.point(0, 0.5).growth, 1.0 + 1.5 * 0.8 * 0.4);
    EXPECT_DOUBLE_EQ(tissue.point(0, 0.5).growth_rate, 1.5 * 0.8 * 2.0);
}

TEST(Growth, RatesAreTheDerivativesOfTheRatios)
{
    test::OwnTissue tissue = cortex();
    tissue.options.alpha_r = 0.5;
    tissue.options.growth_law = material::GrowthLaw::gompertz;
    tissue.options.growth_onset = 0.1;
    tissue.options.growth_rate = 2.5;
    tissue.start_growth(0.2);
    const double h = 1e-6;
    for (const double t : {0.2, 0.4, 0.8})
    {
        const material::MaterialPoint above = tissue.point(0, t + h);
        const material::MaterialPoint below = tissue.point(0, t - h);
        const material::MaterialPoint at = tissue.point(0, t);
        EXPECT_NEAR(at.growth_rate, (above.growth - below.growth) / (2.0 * h), 1e-8);
        EXPECT_NEAR(at.radial_growth_rate, (above.radial_growth - below.radial_growth) / (2.0 * h), 1e-8);
    }
}

TEST(Growth, ABodyImagedLateStartsAtRestAndGrowsByWhatIsLeft)
{
    test::OwnTissue tissue = cortex();
    tissue.start_growth(0.0);
    EXPECT_TRUE(tissue.past.empty());
    tissue.start_growth(0.3);
    EXPECT_EQ(tissue.point(0, 0.3).growth, 1.0);
    // Composed with the growth before, it is the growth of a body imaged at 0.
    EXPECT_DOUBLE_EQ(tissue.point(0, 0.9).growth * (1.0 + 1.5 * 0.8 * 0.3), 1.0 + 1.5 * 0.8 * 0.9);
    EXPECT_EQ(tissue.point(0, 0.3).radial_growth, 1.0);
}

} // namespace
} // namespace corticle
