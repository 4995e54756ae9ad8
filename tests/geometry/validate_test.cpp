// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/validate.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/random.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace corticle
{
namespace
{

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// The complaint about a surface, empty if there is none.
std::string complaint(const TriangleMesh& surface)
{
    try
    {
        geometry::require_valid_surface(surface, "s.stl");
    }
    catch (const InputError& error)
    {
        EXPECT_THAT(error.what(), StartsWith("s.stl: "));
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        return error.what();
    }
    return "";
}

TriangleMesh unit_box()
{
    return test::box({0, 0, 0}, {1, 1, 1});
}

TEST(ValidSurface, ABoxIsFine)
{
    EXPECT_EQ(complaint(unit_box()), "");
}

TEST(ValidSurface, NamesWhatIsWrong)
{
    EXPECT_THAT(complaint({}), HasSubstr("empty surface"));

    TriangleMesh mesh = unit_box();
    mesh.vertices[5].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(complaint(mesh), HasSubstr("vertex 5 is not finite"));

    mesh = unit_box();
    mesh.triangles[3][1] = 8;
    EXPECT_THAT(complaint(mesh), HasSubstr("triangle 3 refers to vertex 8; expected 0 to 7"));
    mesh.triangles[3][1] = -1;
    EXPECT_THAT(complaint(mesh), HasSubstr("triangle 3 refers to vertex -1"));

    mesh = unit_box();
    mesh.triangles[2][0] = mesh.triangles[2][1];
    EXPECT_THAT(complaint(mesh), HasSubstr("triangle 2 has a vertex twice"));

    mesh = unit_box();
    mesh.triangles.pop_back();
    EXPECT_EQ(complaint(mesh), "s.stl: open surface: 3 boundary edges; expected a closed surface");

    mesh = unit_box();
    mesh.triangles.push_back(mesh.triangles[0]);
    EXPECT_THAT(complaint(mesh), HasSubstr("not manifold: 3 edges"));

    mesh = unit_box();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    EXPECT_THAT(complaint(mesh), HasSubstr("inconsistent orientation: 3 edges"));

    EXPECT_THAT(complaint(test::together(unit_box(), test::box({3, 0, 0}, {4, 1, 1}))),
                HasSubstr("2 components; expected 1"));

    mesh = unit_box();
    mesh.vertices.push_back({9, 9, 9});
    EXPECT_THAT(complaint(mesh), HasSubstr("vertex 8 belongs to no triangle"));

    mesh = unit_box();
    for (Triangle& t : mesh.triangles)
    {
        std::swap(t[0], t[1]);
    }
    EXPECT_THAT(complaint(mesh), HasSubstr("inside-out (enclosed volume -1 mm³)"));

    EXPECT_THAT(complaint(test::box({0, 0, 0}, {1, 1, 0})), HasSubstr("volume is zero"));

    mesh = unit_box();
    mesh.vertices[7] = {-1, -1, 0.5}; // a corner pulled through the opposite side
    EXPECT_THAT(complaint(mesh), HasSubstr("self-intersecting"));
}

TEST(ValidSurface, TwoBoxesThatShareAVertexAreNotManifold)
{
    TriangleMesh mesh = test::together(unit_box(), test::box({1, 1, 1}, {2, 2, 2}));
    EXPECT_THAT(complaint(geometry::merge_duplicates(mesh)), HasSubstr("not manifold: vertex 7 joins"));
}

TEST(ValidSurface, GarbageGivesAComplaintAndNoCrash)
{
    for (std::uint64_t seed = 0; seed < 300; ++seed)
    {
        TriangleMesh mesh = unit_box();
        for (std::uint64_t change = 0; change < 3; ++change)
        {
            const std::uint64_t draw = hash_bits(seed, change);
            mesh.triangles[draw % 12][draw / 16 % 3] = static_cast<std::int32_t>(draw / 64 % 9);
            mesh.vertices[draw / 1024 % 8].x *= draw % 5 == 0 ? 1e200 : (draw % 5 == 1 ? 0.0 : 1.0);
        }
        EXPECT_NO_FATAL_FAILURE(complaint(mesh));
        EXPECT_NO_FATAL_FAILURE({
            try
            {
                complaint(geometry::merge_duplicates(mesh));
            }
            catch (const InputError&)
            {
            }
        });
    }
}

TEST(MergeDuplicates, MakesABoxOfLooseTriangles)
{
    const TriangleMesh box = unit_box();
    TriangleMesh loose;
    for (const Triangle& t : box.triangles)
    {
        const auto first = static_cast<std::int32_t>(loose.vertices.size());
        loose.vertices.insert(loose.vertices.end(), {box.vertices[t[0]], box.vertices[t[1]], box.vertices[t[2]]});
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    loose.vertices.push_back({5, 5, 5});  // unused
    loose.triangles.push_back({0, 0, 1}); // collapsed
    EXPECT_THAT(complaint(loose), Not(""));
    const TriangleMesh merged = geometry::merge_duplicates(loose);
    EXPECT_EQ(merged.vertices.size(), 8u);
    EXPECT_EQ(merged.triangles.size(), 12u);
    EXPECT_EQ(complaint(merged), "");
}

} // namespace
} // namespace corticle
