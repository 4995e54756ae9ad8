// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/plain_text.hpp"
#include "corticle/report/thinning.hpp"

#include "corticle/geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <map>

namespace corticle
{

TEST(PlainText, PathsLoseTheirFolders)
{
    EXPECT_EQ(report::without_paths("\"/home/ann/data/brain.off\""), "\"brain.off\"");
    EXPECT_EQ(report::without_paths("read /a/b/c.nii.gz, then ../x/y.off: done"), "read c.nii.gz, then y.off: done");
    EXPECT_EQ(report::without_paths("~/runs/a/"), "a");
    EXPECT_EQ(report::without_paths("curvature [1/mm], m (c_p/h)^2 and 3/4"), "curvature [1/mm], m (c_p/h)^2 and 3/4");
    EXPECT_EQ(report::without_paths("a / b"), "a / b");
}

TEST(PlainText, KeysAndUnitsInWords)
{
    EXPECT_EQ(report::label_of("sulcal_depth_mean_mm"), "sulcal depth, mean");
    EXPECT_EQ(report::label_of("something_new_mm2"), "something new");
    EXPECT_EQ(report::unit_text("mm2"), "mm²");
    EXPECT_EQ(report::unit_text("mu_w mm3"), "μ_w mm³");
    EXPECT_EQ(report::unit_text("-"), "");
}

TEST(Thinning, ChoosesFirstAndLast)
{
    EXPECT_EQ(report::spread(11, 3), (std::vector<std::size_t>{0, 5, 10}));
    EXPECT_EQ(report::spread(3, 9), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(report::spread(1, 5), (std::vector<std::size_t>{0}));
}

TEST(Thinning, AThinSphereIsStillClosed)
{
    const TriangleMesh sphere = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 1.0);
    const report::ThinSurface thin = report::thin_surface(sphere.triangles, sphere.vertices.size(), 300);
    EXPECT_EQ(thin.kept.size(), 300u);
    std::map<std::pair<int, int>, int> edges;
    for (const Triangle& triangle : thin.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            ++edges[std::minmax(triangle[k], triangle[(k + 1) % 3])];
        }
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : edges)
    {
        open += count == 2 ? 0 : 1;
    }
    EXPECT_LT(open, edges.size() / 50);
}

TEST(Thinning, AllAreKeptWhereThereIsRoom)
{
    const TriangleMesh sphere = geometry::make_ellipsoid({10.0, 10.0, 10.0}, 3.0);
    const report::ThinSurface same = report::thin_surface(sphere.triangles, sphere.vertices.size(), 1000000);
    EXPECT_EQ(same.kept.size(), sphere.vertices.size());
    EXPECT_EQ(same.triangles, sphere.triangles);
}

} // namespace corticle
