// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/metrics/measure_table.hpp"

#include "geometry/simple_surfaces.hpp"
#include "metrics/turned_surfaces.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

metrics::FoldMeasures folds_of(const TriangleMesh& mesh, const metrics::FoldOptions& options = {})
{
    return metrics::measure_folds(mesh.vertices, mesh.triangles,
                                  metrics::fold_fields(mesh.vertices, mesh.triangles, options), options);
}

/// A sphere with waves along and around.
TriangleMesh wavy()
{
    return test::star([](const Vec3& n) { return 10.0 + 0.6 * std::cos(14.0 * n.z) * std::cos(11.0 * n.x); });
}

TEST(FoldMeasures, ScaleWithTheBody)
{
    TriangleMesh mesh = wavy();
    const metrics::FoldMeasures small = folds_of(mesh);
    EXPECT_GT(small.sulcal_pits, 5.0);
    EXPECT_GT(small.fold_wavelength_mm, 0.0);
    for (Vec3& v : mesh.vertices)
    {
        v *= 4.0; // exact, so that nothing but the unit changes
    }
    const metrics::FoldMeasures large = folds_of(mesh);
    for (const metrics::FoldColumn& column : metrics::fold_columns())
    {
        const double factor = column.unit == "mm" ? 4.0 : (column.unit == "1/mm" ? 0.25 : 1.0);
        EXPECT_NEAR(large.*column.value, factor * small.*column.value, 1e-6 * (1.0 + std::abs(small.*column.value)))
            << column.key;
    }
}

TEST(FoldMeasures, DoNotDependOnWhereTheBodyIs)
{
    TriangleMesh mesh = wavy();
    const metrics::FoldMeasures here = folds_of(mesh);
    for (Vec3& v : mesh.vertices)
    {
        v += {300, -200, 100};
    }
    const metrics::FoldMeasures there = folds_of(mesh);
    EXPECT_NEAR(there.gi_zilles / here.gi_zilles, 1.0, 1e-9);
    EXPECT_NEAR(there.gi_local_mean / here.gi_local_mean, 1.0, 1e-3); // the cubes of thinned places lie otherwise
    EXPECT_NEAR(there.sulcal_depth_mean_mm / here.sulcal_depth_mean_mm, 1.0, 1e-6);
    EXPECT_NEAR(there.curvedness_per_mm / here.curvedness_per_mm, 1.0, 1e-6);
    EXPECT_EQ(there.sulcal_pits, here.sulcal_pits);
    EXPECT_EQ(there.gyral_crowns, here.gyral_crowns);
    EXPECT_NEAR(there.asymmetry_volume, here.asymmetry_volume, 1e-9);
}

TEST(FoldMeasures, AreFiniteForCoarseThinAndSeparateBodies)
{
    const TriangleMesh cube = test::box({0, 0, 0}, {1, 1, 1});
    const TriangleMesh cavity = [&]
    {
        TriangleMesh hole = test::box({0.3, 0.3, 0.3}, {0.6, 0.6, 0.6});
        for (Triangle& t : hole.triangles)
        {
            std::swap(t[1], t[2]);
        }
        return test::together(cube, hole);
    }();
    for (const TriangleMesh& mesh : {cube, cavity, test::together(cube, test::box({3, 0, 0}, {4, 1, 1})),
                                     test::box({0, 0, 0}, {100, 100, 0.01}), test::box({0, 0, 0}, {1e-3, 2e-3, 1e-3})})
    {
        const metrics::FoldMeasures folds = folds_of(mesh);
        for (const metrics::FoldColumn& column : metrics::fold_columns())
        {
            EXPECT_TRUE(std::isfinite(folds.*column.value)) << column.key;
        }
    }
}

TEST(FoldMeasures, AClosedOuterSurfaceFollowsWideConcavities)
{
    // Two bulges of radius 10 with a waist of 6 between them, and on one of them fine waves: the hull spans the waist,
    // the ball enters it but not the waves.
    const auto outline = [](double z)
    {
        const double smooth = 8.0 - 2.0 * std::cos(std::numbers::pi * z / 10.0);
        return smooth + (z > 5.0 ? 0.5 * (std::cos(4.0 * std::numbers::pi * (z - 5.0)) - 1.0) : 0.0);
    };
    std::vector<test::ProfilePoint> profile{{0.1, -14.0}};
    for (double z = -14.0; z <= 14.0; z += 0.05)
    {
        profile.push_back({outline(z), z});
    }
    profile.push_back({0.1, 14.0});
    const TriangleMesh mesh = test::turned(profile, -14.0, 14.0, 120);
    metrics::FoldOptions options;
    const metrics::FoldFields hull = metrics::fold_fields(mesh.vertices, mesh.triangles, options);
    options.outer = metrics::OuterSurface::closed;
    const metrics::FoldFields closed = metrics::fold_fields(mesh.vertices, mesh.triangles, options);
    double hull_at_waist = 0.0;
    double closed_at_waist = 0.0;
    double closed_in_waves = 0.0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
        const double z = mesh.vertices[v].z;
        if (std::abs(z) < 0.5)
        {
            hull_at_waist = std::max(hull_at_waist, hull.sulcal_depth[v]);
            closed_at_waist = std::max(closed_at_waist, closed.sulcal_depth[v]);
        }
        closed_in_waves = z > 7.0 && z < 12.0 ? std::max(closed_in_waves, closed.sulcal_depth[v]) : closed_in_waves;
    }
    EXPECT_GT(hull_at_waist, 3.0);
    EXPECT_LT(closed_at_waist, 0.3);
    EXPECT_NEAR(closed_in_waves, 1.0, 0.25);
}

TEST(FoldMeasures, TakeTheMidplaneThatIsGiven)
{
    const TriangleMesh mesh = test::box({-1, 0, 0}, {3, 1, 1});
    metrics::FoldOptions options;
    options.midplane = metrics::Plane{{0, 0, 0}, {1, 0, 0}};
    EXPECT_NEAR(folds_of(mesh, options).asymmetry_volume, -1.0, 1e-12);
    EXPECT_NEAR(folds_of(mesh).asymmetry_volume, 0.0, 1e-12);
}

} // namespace
} // namespace corticle
