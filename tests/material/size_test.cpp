// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/size.hpp"

#include "corticle/base/error.hpp"
#include "corticle/material/layer.hpp"
#include "corticle/material/tissue.hpp"

#include "material/own_tissue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

TEST(Size, QuadraticTable)
{
    const double weeks[] = {22, 30, 40};
    const double lengths[] = {59.0, 88.5, 113.1};
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::wang, weeks[k]),
                    lengths[k],
                    0.0501); // L(40) is 113.15
        // It speaks of weeks, so the clock does not matter.
        EXPECT_EQ(material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::cubic, weeks[k]),
                  material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::wang, weeks[k]));
    }
}

TEST(Size, HyperbolicLawStartsAt59MillimetresAndFollowsItsClock)
{
    EXPECT_NEAR(material::brain_length(material::LengthLaw::hyperbolic, material::GestationalClock::cubic, 22.0), 59.0,
                0.05);
    const double t = material::growth_time(material::GestationalClock::cubic, 30.0);
    EXPECT_DOUBLE_EQ(material::brain_length(material::LengthLaw::hyperbolic, material::GestationalClock::cubic, 30.0),
                     59.0 / (1.0 - 0.55 * t));
    EXPECT_GT(material::brain_length(material::LengthLaw::hyperbolic, material::GestationalClock::wang, 22.0),
              61.0); // the wrong clock
}

TEST(Size, BrainsGetLonger)
{
    for (const material::GestationalClock clock : {material::GestationalClock::wang, material::GestationalClock::cubic})
    {
        for (const material::LengthLaw law : {material::LengthLaw::hyperbolic, material::LengthLaw::quadratic})
        {
            for (double week = 22.0; week < 44.0; week += 0.125)
            {
                EXPECT_LT(material::brain_length(law, clock, week), material::brain_length(law, clock, week + 0.125))
                    << week;
            }
        }
    }
    EXPECT_THROW(material::brain_length(material::LengthLaw::quadratic, material::GestationalClock::wang, 61.0),
                 InputError);
}

TEST(Size, ScaleIsOneAtTheStart)
{
    EXPECT_EQ(material::ReferenceSize{}.scale(0.7), 1.0);
    const material::ReferenceSize size{material::GestationalClock::wang, material::LengthLaw::quadratic, 23.0};
    EXPECT_NEAR(size.scale(material::growth_time(size.clock, 23.0)), 1.0, 1e-13);
    const double ratio = (-0.067 * 38 * 38 + 7.16 * 38 - 66.05) / (-0.067 * 23 * 23 + 7.16 * 23 - 66.05);
    EXPECT_NEAR(size.scale(material::growth_time(size.clock, 38.0)), ratio, 1e-12);
}

TEST(Size, ItsRateIsTheSlope)
{
    EXPECT_EQ(material::ReferenceSize{}.scale_rate(0.7), 0.0);
    for (const material::GestationalClock clock : {material::GestationalClock::wang, material::GestationalClock::cubic})
    {
        for (const material::LengthLaw law : {material::LengthLaw::hyperbolic, material::LengthLaw::quadratic})
        {
            const material::ReferenceSize size{clock, law, 23.0};
            for (double t = 0.1; t < 0.85; t += 0.05)
            {
                const double h = 1e-5;
                EXPECT_NEAR(size.scale_rate(t), (size.scale(t + h) - size.scale(t - h)) / (2.0 * h), 1e-7) << t;
            }
        }
    }
}

TEST(Size, AGrowingReferenceStateThinsTheCortex)
{
    test::OwnTissue tissue;
    tissue.options.thickness_mm = 2.5;
    tissue.options.thickness_rate_mm = 0.3;
    tissue.size = {material::GestationalClock::wang, material::LengthLaw::quadratic, 23.0};
    const double t = material::growth_time(material::GestationalClock::wang, 38.0);
    // Half of the cortex in mm at 38 weeks, in units of the reference state, is where theta is 1/2.
    const double boundary = (2.5 + 0.3 * t) / tissue.size.scale(t);
    tissue.depth = {0.5 * boundary, boundary, 2.5};
    tissue.volume.assign(3, 1.0);
    tissue.set_layer(t);
    EXPECT_DOUBLE_EQ(tissue.theta[1], 0.5);
    EXPECT_GT(tissue.theta[0], 0.99);
    EXPECT_LT(tissue.theta[2], 0.01); // cortex at 23 weeks
    EXPECT_LT(boundary, 1.7);
}

TEST(Size, LocalThicknessReplacesTheOne)
{
    test::OwnTissue tissue;
    tissue.options.thickness_mm = 9.0;
    tissue.depth = {1.0, 1.0};
    tissue.volume.assign(2, 1.0);
    tissue.thickness = {1.0, 2.0};
    tissue.set_layer(0.0);
    EXPECT_DOUBLE_EQ(tissue.theta[0], 0.5);
    EXPECT_DOUBLE_EQ(tissue.theta[1], material::smooth_layer(1.0, 2.0));
}

} // namespace
} // namespace corticle
