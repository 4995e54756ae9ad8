// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanics/tlsph/small_body.hpp"
#include "momenta.hpp"

#include <gtest/gtest.h>

namespace corticle::test
{

/// Forces are minus the gradient of the energy, along some random directions of all nodes together, and keep both
/// momenta. @param energy_at  of positions @param h  step of the differences [mm]
template <class Energy>
void expect_energy_gradient(std::span<const Vec3> at, std::span<const Vec3> forces, const Energy& energy_at, double h,
                            double tolerance)
{
    for (std::uint64_t direction = 0; direction < 5; ++direction)
    {
        std::vector<Vec3> above(at.begin(), at.end());
        std::vector<Vec3> below(at.begin(), at.end());
        double expected = 0.0;
        double size = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            const Vec3 d = random_vector(direction, i);
            above[i] += h * d;
            below[i] -= h * d;
            expected -= dot(forces[i], d);
            size += std::abs(dot(forces[i], d));
        }
        EXPECT_NEAR((energy_at(above) - energy_at(below)) / (2.0 * h), expected, tolerance * size);
    }
    expect_momenta_conserved(at, forces);
}

} // namespace corticle::test
