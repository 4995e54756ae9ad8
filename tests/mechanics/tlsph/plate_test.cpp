// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/material/layer.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "mechanics/tlsph/plate.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace corticle
{
namespace
{

/// Growth that goes linearly through the thickness bends a free plate without stress, to the curvature growth / h.
double linear_growth_error(int spacings)
{
    test::Plate plate(spacings);
    for (std::size_t i = 0; i < plate.cloud.positions.size(); ++i)
    {
        plate.tissue.regional_rate[i] = plate.cloud.centroids[i].z / plate.thickness;
    }
    return test::curvature_of(plate) / (-test::plate_growth / plate.thickness) - 1.0;
}

/// Growth of the upper half bends it to 3/2 growth / h (Timoshenko 1925, for two layers of one material).
double bilayer_error(int spacings)
{
    test::Plate plate(spacings);
    std::vector<double> height;
    for (const Vec3& centroid : plate.cloud.centroids)
    {
        height.push_back(centroid.z);
    }
    const double total = std::accumulate(plate.cloud.volumes.begin(), plate.cloud.volumes.end(), 0.0);
    plate.tissue.theta = material::sharp_layer(height, plate.cloud.volumes, 0.5 * total);
    return test::curvature_of(plate) / (-1.5 * test::plate_growth / plate.thickness) - 1.0;
}

/// The exact motion is quadratic, and fits near the surface follow it: what is left, at any spacing, is what their
/// regularisation and the linear fits deeper down make of it.
TEST(Plate, BendsToTheExactCurvature)
{
    for (const int spacings : {3, 4, 6})
    {
        EXPECT_LT(std::abs(linear_growth_error(spacings)), 2e-3) << spacings << " spacings";
    }
}

TEST(Plate, BilayerBendsAsTheorySays)
{
    for (const auto& [spacings, tolerance] : {std::pair{2, 0.08}, {3, 0.08}, {4, 0.03}, {6, 0.03}})
    {
        EXPECT_LT(std::abs(bilayer_error(spacings)), tolerance) << spacings << " spacings";
    }
}

} // namespace
} // namespace corticle
