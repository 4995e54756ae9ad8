// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/comparison.hpp"
#include "corticle/metrics/measure_table.hpp"

#include "corticle/geometry/shapes.hpp"
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/metrics/surface_measures.hpp"
#include "corticle/metrics/surface_rows.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{
namespace
{

metrics::SurfaceView view(const TriangleMesh& mesh)
{
    return {mesh.vertices, mesh.triangles};
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by)
{
    for (Vec3& v : mesh.vertices)
    {
        v += by;
    }
    return mesh;
}

TriangleMesh ball(double radius)
{
    return geometry::make_ellipsoid({radius, radius, radius}, 0.1 * radius);
}

void expect_symmetric(const metrics::SurfaceView& a, const metrics::SurfaceView& b)
{
    const metrics::SurfaceDistance ab = metrics::surface_distance(a, b);
    const metrics::SurfaceDistance ba = metrics::surface_distance(b, a);
    EXPECT_NEAR(ab.mean, ba.mean, 1e-12);
    EXPECT_NEAR(ab.percentile_95, ba.percentile_95, 1e-12);
    EXPECT_EQ(ab.hausdorff, ba.hausdorff);
}

TEST(PercentDifference, IsOverTheFirst)
{
    EXPECT_DOUBLE_EQ(metrics::percent_difference(2.0, 3.0), 50.0);
    EXPECT_DOUBLE_EQ(metrics::percent_difference(-2.0, -3.0), -50.0);
    EXPECT_EQ(metrics::percent_difference(0.0, 0.0), 0.0);
    EXPECT_TRUE(std::isnan(metrics::percent_difference(0.0, 1.0)));
    EXPECT_TRUE(std::isnan(metrics::percent_difference(1.0, std::nan(""))));
}

TEST(TellingPercent, IsNotTakenOfSharesAndOfWhatIsNearZero)
{
    EXPECT_DOUBLE_EQ(metrics::telling_percent("area_mm2", 2.0, 3.0), 50.0);
    EXPECT_TRUE(std::isnan(metrics::telling_percent("asymmetry_volume", 1e-5, 0.002)));
    EXPECT_TRUE(std::isnan(metrics::telling_percent("overlap_area_share", 0.1, 0.2)));
    EXPECT_TRUE(std::isnan(metrics::telling_percent("energy_contact", 1e-3, 1.0)));
    EXPECT_TRUE(std::isnan(metrics::telling_percent("energy_contact", 1e-12, 2e-12, 1.0)));
    EXPECT_EQ(metrics::telling_percent("energy_contact", 0.0, 0.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(metrics::telling_percent("sulcal_pits", 2.0, 30.0), 1400.0);
}

TEST(Interpolate, IsLinearAndEndsWithTheCurve)
{
    const std::vector<double> x{0.0, 1.0, 3.0};
    const std::vector<double> y{2.0, 4.0, 0.0};
    EXPECT_EQ(metrics::interpolate(x, y, 0.0), 2.0);
    EXPECT_EQ(metrics::interpolate(x, y, 0.5), 3.0);
    EXPECT_EQ(metrics::interpolate(x, y, 1.0), 4.0);
    EXPECT_EQ(metrics::interpolate(x, y, 2.5), 1.0);
    EXPECT_EQ(metrics::interpolate(x, y, 3.0), 0.0);
    EXPECT_TRUE(std::isnan(metrics::interpolate(x, y, -0.1)));
    EXPECT_TRUE(std::isnan(metrics::interpolate(x, y, 3.1)));
    EXPECT_TRUE(std::isnan(metrics::interpolate(x, y, std::nan(""))));
}

TEST(SurfaceDistance, OfASurfaceToItselfIsZero)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({5, 4, 3}, 0.7);
    const metrics::SurfaceDistance distance = metrics::surface_distance(view(mesh), view(mesh));
    // A vertex is its own closest point, up to the round-off of the projection onto its triangles.
    EXPECT_LT(distance.hausdorff, 1e-14);
    EXPECT_LT(distance.mean, 1e-14);
}

TEST(SurfaceDistance, OfABoxAndATallerOneExactly)
{
    const TriangleMesh low = test::box({0, 0, 0}, {1, 1, 1});
    const TriangleMesh tall = test::box({0, 0, 0}, {1, 1, 3});
    const metrics::SurfaceDistance distance = metrics::surface_distance(view(low), view(tall));
    // The lid of the low box lies inside the tall one: its corners touch the sides. The four upper corners of the tall
    // box lie 2 above the low one; its surface is 14, half of it about those corners; that of the low box is 6.
    EXPECT_DOUBLE_EQ(distance.hausdorff, 2.0);
    EXPECT_NEAR(distance.mean, 2.0 * 7.0 / 20.0, 1e-14);
    EXPECT_DOUBLE_EQ(distance.percentile_95, 2.0);
    expect_symmetric(view(low), view(tall));
}

TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfTheirRadii)
{
    const TriangleMesh small = ball(10.0);
    const TriangleMesh large = ball(12.0);
    const metrics::SurfaceDistance distance = metrics::surface_distance(view(small), view(large));
    // Triangles of edge h = 1 (1.2) sag by h² / (8 R) = 0.015 off the sphere.
    EXPECT_NEAR(distance.mean, 2.0, 0.02);
    EXPECT_NEAR(distance.percentile_95, 2.0, 0.04);
    EXPECT_NEAR(distance.hausdorff, 2.0, 0.04);
    expect_symmetric(view(small), view(large));
}

TEST(SurfaceDistance, OfASphereMovedAside)
{
    const TriangleMesh mesh = ball(10.0);
    const TriangleMesh aside = moved(mesh, {0.6, 0.8, 0.0}); // by 1
    const metrics::SurfaceDistance distance = metrics::surface_distance(view(mesh), view(aside));
    // A point at angle u from the way moved lies |cos u| + O(1/20) off: the mean of |cos u| is 1/2, its 95 % 0.95.
    // The corrections sin²(u) / 20 have opposite signs on the two halves. Sag as above.
    EXPECT_NEAR(distance.mean, 0.5, 0.02);
    EXPECT_NEAR(distance.percentile_95, 0.95, 0.02);
    EXPECT_NEAR(distance.hausdorff, 1.0, 0.03);
    expect_symmetric(view(mesh), view(aside));
}

/// Points of a cubic lattice of n³ points, and values of a function there.
struct Lattice
{
    std::vector<Vec3> points;
    std::vector<double> values;
    double spacing;

    template <class Value>
    Lattice(int n, double lattice_spacing, const Vec3& corner, Value&& value) : spacing(lattice_spacing)
    {
        for (int i = 0; i < n * n * n; ++i)
        {
            points.push_back(corner + spacing * Vec3{1.0 * (i % n), 1.0 * (i / n % n), 1.0 * (i / (n * n))});
            values.push_back(value(points.back()));
        }
    }
    metrics::PointField field() const { return {points, values, spacing}; }
};

double one(const Vec3&)
{
    return 1.0;
}

TEST(MeanDifference, AtTheSamePointsIsTheMeanOfTheAbsoluteDifferences)
{
    // |1 - (1 +- x)| at x = 0, 1, 2: mean 1, largest 2 (thesis eq. 27).
    const Lattice a(3, 1.0, {}, one);
    const Lattice b(3, 1.0, {}, [](const Vec3& p) { return p.y > 0.5 ? 1.0 + p.x : 1.0 - p.x; });
    const metrics::FieldDifference difference = metrics::mean_difference(a.field(), b.field());
    EXPECT_FALSE(difference.is_interpolated);
    EXPECT_NEAR(difference.mean, 1.0, 1e-15);
    EXPECT_EQ(difference.largest, 2.0);
    EXPECT_EQ(difference.compared_share, 1.0);
    EXPECT_EQ(difference.interpolation_error, 0.0);
    EXPECT_EQ(metrics::mean_difference(b.field(), a.field()).mean, difference.mean);
    EXPECT_EQ(metrics::mean_difference(b.field(), b.field()).mean, 0.0);
}

TEST(MeanDifference, OfTheSameSmoothFieldAtOtherPointsIsSmall)
{
    const auto linear = [](const Vec3& p) { return 1.0 + 0.3 * p.x - 0.2 * p.y + 0.1 * p.z; };
    const Lattice a(12, 1.0, {}, linear);
    const Lattice b(14, 0.8, {0.13, 0.21, 0.37}, linear);
    const metrics::FieldDifference difference = metrics::mean_difference(a.field(), b.field());
    EXPECT_TRUE(difference.is_interpolated);
    EXPECT_EQ(difference.compared_share, 1.0);
    // A linear field is met but where the bound to the values used cuts extrapolation off: at the outermost points.
    EXPECT_LT(difference.mean, 0.01);
    EXPECT_LT(difference.interpolation_error, 0.05);
}

TEST(MeanDifference, OfTwoConstantsIsTheirDifferenceWhereverThePointsAre)
{
    const Lattice a(7, 1.0, {}, one);
    const Lattice b(8, 0.9, {-0.2, 0.1, 0.05}, [](const Vec3&) { return 1.25; });
    const metrics::FieldDifference difference = metrics::mean_difference(a.field(), b.field());
    EXPECT_TRUE(difference.is_interpolated);
    EXPECT_NEAR(difference.mean, 0.25, 1e-12);
    EXPECT_NEAR(difference.largest, 0.25, 1e-12);
    EXPECT_NEAR(difference.interpolation_error, 0.0, 1e-12);
}

TEST(MeanDifference, IsSymmetricAlsoWhereInterpolated)
{
    const auto wavy = [](const Vec3& p) { return 1.5 + std::sin(p.x) * std::cos(0.7 * p.y) + 0.1 * p.z; };
    const Lattice a(9, 1.0, {}, wavy);
    const Lattice b(10, 0.85, {0.1, -0.1, 0.2}, one);
    const metrics::FieldDifference ab = metrics::mean_difference(a.field(), b.field());
    const metrics::FieldDifference ba = metrics::mean_difference(b.field(), a.field());
    EXPECT_NEAR(ab.mean, ba.mean, 1e-14);
    EXPECT_EQ(ab.largest, ba.largest);
    EXPECT_EQ(ab.compared_share, ba.compared_share);
    EXPECT_NEAR(ab.interpolation_error, ba.interpolation_error, 1e-14);
    EXPECT_GT(ab.mean, 0.3);
}

TEST(MeanDifference, LeavesOutPointsWithoutACounterpart)
{
    const Lattice a(4, 1.0, {}, one);
    const Lattice apart(4, 1.0, {100, 0, 0}, one);
    const metrics::FieldDifference none = metrics::mean_difference(a.field(), apart.field());
    EXPECT_EQ(none.compared_share, 0.0);
    EXPECT_TRUE(std::isnan(none.mean));
    // Half of the points of b overlap a, the other half lies 5 away.
    Lattice b(4, 1.0, {0.25, 0, 0}, one);
    for (std::size_t i = 0; i < b.points.size(); i += 2)
    {
        b.points[i].z += 8.0;
    }
    const metrics::FieldDifference half = metrics::mean_difference(a.field(), b.field());
    EXPECT_NEAR(half.compared_share, 0.75, 1e-12);
    EXPECT_NEAR(half.mean, 0.0, 1e-12);
}

TEST(SurfaceRows, AreThoseOfTheMeasures)
{
    const TriangleMesh mesh = test::box({0, 0, 0}, {1, 2, 3});
    const metrics::SurfaceMeasures measures = metrics::measure_surface(mesh.vertices, mesh.triangles);
    const std::vector<metrics::SurfaceRow> rows = metrics::surface_rows(mesh.vertices, mesh.triangles);
    const auto value = [&](const std::string& key)
    {
        for (const metrics::SurfaceRow& row : rows)
        {
            if (row.key == key)
            {
                return row.value;
            }
        }
        return std::nan("");
    };
    EXPECT_EQ(value("area_mm2"), 22.0);
    EXPECT_EQ(value("volume_mm3"), 6.0);
    EXPECT_EQ(value("gi_hull"), measures.gi_hull);
    EXPECT_EQ(value("gi_sphere"), measures.gi_sphere);
    EXPECT_EQ(value("hull_area_mm2"), measures.hull_area_mm2);
    EXPECT_EQ(value("width_mm"), 1.0);
    EXPECT_EQ(value("length_mm"), 2.0);
    EXPECT_EQ(value("height_mm"), 3.0);
    EXPECT_EQ(rows.size(), metrics::size_columns().size() + metrics::fold_columns().size());
}

} // namespace
} // namespace corticle
