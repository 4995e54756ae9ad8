// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/vec3.hpp"

#include <gtest/gtest.h>

namespace corticle
{

TEST(Vec3, EqualityIsThatOfThreeNumbers)
{
    const Vec3 a{1.0, 2.0, 3.0};
    Vec3 b = a;
    b.lane = 4.0; // a stiffness or a control that rides along
    EXPECT_EQ(a, b);
    b.z = 3.5;
    EXPECT_NE(a, b);
    EXPECT_EQ(Vec3{0.0}, Vec3{-0.0});
}

} // namespace corticle
