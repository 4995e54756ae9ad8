// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/material_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle
{

namespace
{

/// Undeformed particles on a cubic lattice of spacing 1 mm, from -extent to extent.
struct Lattice
{
    std::vector<Vec3> origins;
    std::vector<Vec3> positions;
    std::vector<Mat3> F;
    std::vector<double> theta; ///< 1 above z = 0.5 mm before deformation

    explicit Lattice(int extent)
    {
        for (int x = -extent; x <= extent; ++x)
        {
            for (int y = -extent; y <= extent; ++y)
            {
                for (int z = -extent; z <= extent; ++z)
                {
                    origins.push_back({1.0 * x, 1.0 * y, 1.0 * z});
                    theta.push_back(z > 0 ? 1.0 : 0.0);
                }
            }
        }
        positions = origins;
        F.assign(origins.size(), Mat3::identity());
    }

    view::CutInput input() const
    {
        return {.positions = positions,
                .origins = origins,
                .F = F,
                .theta = theta,
                .scalar = theta,
                .spacing = 1.0,
                .surface_points = {},
                .triangles = {},
                .axis = 1,
                .coordinate = 0.3};
    }
};

} // namespace

TEST(MaterialSection, ShowsTheMaterialOfAnAffineMotionExactly)
{
    // Stretched 3 and 2.5 times along the layers and sheared across them: in space the nearest particle is often one of
    // another layer.
    const Mat3 F = Mat3{{{1, 0, 0}, {0, 1, 0}, {0.8, 0.4, 1}}} * Mat3::diagonal(3.0, 2.5, 0.8);
    Lattice lattice(8);
    for (std::size_t i = 0; i < lattice.origins.size(); ++i)
    {
        lattice.positions[i] = F * lattice.origins[i];
        lattice.F[i] = F;
    }
    const view::PixelGrid grid{61, 40, -9.13, -3.07, 0.15};
    const std::vector<std::uint8_t> everywhere(61 * 40, 1);
    const view::CutInput input = lattice.input();
    const std::vector<std::int32_t> shown = view::material_particles(input, grid, everywhere);
    const std::vector<std::int32_t> nearest = view::nearest_particles(lattice.positions, {1, 0.3}, grid, everywhere);
    int wrong_nearest = 0;
    for (int row = 0; row < grid.height; ++row)
    {
        for (int column = 0; column < grid.width; ++column)
        {
            const Vec3 origin = inverse(F) * Vec3{grid.right_of(column), 0.3, grid.up_of(row)};
            const auto pixel = static_cast<std::size_t>(row * grid.width + column);
            double best = std::numeric_limits<double>::infinity();
            for (const Vec3& place : lattice.origins)
            {
                best = std::min(best, norm(place - origin));
            }
            const auto particle = static_cast<std::size_t>(shown[pixel]);
            EXPECT_NEAR(norm(lattice.origins[particle] - origin), best, 1e-12);
            wrong_nearest += lattice.theta[static_cast<std::size_t>(nearest[pixel])] != lattice.theta[particle];
        }
    }
    EXPECT_GT(wrong_nearest, 50); // so the case does tell the two apart
}

TEST(MaterialSection, AParticleAheadOfItsNeighboursLeavesNoSpeckle)
{
    // A particle just below the boundary moves half a spacing beyond it.
    Lattice lattice(4);
    const auto stray =
        std::find(lattice.origins.begin(), lattice.origins.end(), Vec3{0, 0, 0}) - lattice.origins.begin();
    lattice.positions[static_cast<std::size_t>(stray)].z = 1.0;
    const view::PixelGrid grid{40, 12, -2.0, 0.9, 0.1};
    for (const std::int32_t particle :
         view::material_particles(lattice.input(), grid, std::vector<std::uint8_t>(480, 1)))
    {
        EXPECT_EQ(lattice.theta[static_cast<std::size_t>(particle)], 1.0);
    }
}

TEST(MaterialSection, FillsWhatNoParticleReachesAndOnlyTheMask)
{
    Lattice lattice(0); // a single particle
    view::CutInput input = lattice.input();
    const view::PixelGrid grid{30, 1, 0.0, 0.0, 1.0}; // from the particle to 30 spacings away
    std::vector<std::uint8_t> mask(30, 1);
    mask[7] = 0;
    std::vector<std::int32_t> expected(30, 0);
    expected[7] = -1;
    EXPECT_EQ(view::material_particles(input, grid, mask), expected);
    lattice.F[0] = Mat3::diagonal(1.0, 0.0, std::nan("")); // no inverse
    EXPECT_EQ(view::material_particles(input, grid, mask), expected);
    EXPECT_EQ(view::material_particles({}, grid, mask), std::vector<std::int32_t>(30, -1));
}

} // namespace corticle
