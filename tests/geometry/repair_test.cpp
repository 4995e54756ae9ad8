// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/repair.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/validate.hpp"
#include "geometry/simple_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace corticle::test
{

namespace
{

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double ellipsoid_volume = 4.0 / 3.0 * std::numbers::pi * 10.0 * 8.0 * 7.0;

const TriangleMesh& ellipsoid()
{
    static const TriangleMesh mesh = geometry::make_ellipsoid({10.0, 8.0, 7.0}, 0.8);
    return mesh;
}

/// Without a share of its triangles.
TriangleMesh with_holes(const TriangleMesh& surface, double share, std::uint64_t seed)
{
    std::vector<char> keep;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        keep.push_back(hash_uniform(seed, t) < share ? 0 : 1);
    }
    return geometry::kept_triangles(surface, keep);
}

TriangleMesh without_cap(const TriangleMesh& surface)
{
    std::vector<char> keep;
    for (const Triangle& t : surface.triangles)
    {
        keep.push_back(surface.vertices[static_cast<std::size_t>(t[0])].z > 5.5 ? 0 : 1);
    }
    return geometry::kept_triangles(surface, keep);
}

TriangleMesh inside_out(TriangleMesh surface)
{
    for (Triangle& t : surface.triangles)
    {
        std::swap(t[1], t[2]);
    }
    return surface;
}

TriangleMesh moved(TriangleMesh surface, const Vec3& shift)
{
    for (Vec3& p : surface.vertices)
    {
        p += shift;
    }
    return surface;
}

/// Every triangle with vertices of its own, as STL has them.
TriangleMesh exploded(const TriangleMesh& surface)
{
    TriangleMesh result;
    for (const Triangle& t : surface.triangles)
    {
        const auto first = static_cast<std::int32_t>(result.vertices.size());
        for (const std::int32_t vertex : t)
        {
            result.vertices.push_back(surface.vertices[static_cast<std::size_t>(vertex)]);
        }
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

std::string refusal(const TriangleMesh& surface, geometry::Repair choice, const geometry::RepairOptions& options = {})
{
    try
    {
        geometry::repair_surface(surface, "body.stl", choice, options);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return {};
}

/// Repaired by both means to within 1 % of the volume; returns the report of the first.
geometry::RepairReport expect_repaired(const TriangleMesh& surface, double volume = ellipsoid_volume)
{
    geometry::RepairReport first;
    for (const geometry::Repair choice : {geometry::Repair::automatic, geometry::Repair::wrap})
    {
        const geometry::RepairedSurface result = geometry::repair_surface(surface, "body.stl", choice);
        EXPECT_NO_THROW(geometry::require_valid_surface(result.mesh, "repaired"));
        EXPECT_NEAR(result.report.volume_after_mm3, volume, 0.01 * volume)
            << (choice == geometry::Repair::wrap ? "wrap" : "automatic");
        EXPECT_EQ(result.report.volume_after_mm3, enclosed_volume(result.mesh.vertices, result.mesh.triangles));
        EXPECT_TRUE(choice == geometry::Repair::automatic || result.report.wrapped);
        first = choice == geometry::Repair::automatic ? result.report : first;
    }
    return first;
}

} // namespace

TEST(Repair, LeavesASoundSurfaceAsItIs)
{
    for (const geometry::Repair choice : {geometry::Repair::automatic, geometry::Repair::none})
    {
        const geometry::RepairedSurface result = geometry::repair_surface(ellipsoid(), "body.stl", choice);
        const TriangleMesh expected = geometry::merge_duplicates(ellipsoid());
        EXPECT_EQ(result.mesh.vertices, expected.vertices);
        EXPECT_EQ(result.mesh.triangles, expected.triangles);
        EXPECT_THAT(result.report.lines, IsEmpty());
        EXPECT_FALSE(result.report.wrapped);
    }
}

TEST(Repair, FillsTheHolesThatOneTriangleInAHundredLeaves)
{
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
    {
        const TriangleMesh open = with_holes(ellipsoid(), 0.01, seed);
        ASSERT_LT(open.triangles.size(), ellipsoid().triangles.size());
        EXPECT_THAT(refusal(open, geometry::Repair::none), HasSubstr("body.stl: open surface"));
        const geometry::RepairReport report = expect_repaired(open);
        EXPECT_FALSE(report.wrapped) << seed;
        EXPECT_GT(report.edges.boundary_edges, 0);
        EXPECT_THAT(report.lines, Contains(HasSubstr("filled")));
    }
}

TEST(Repair, FillsALargeHoleRoundly)
{
    const TriangleMesh open = without_cap(ellipsoid());
    const geometry::RepairedSurface result = geometry::repair_surface(open, "body.stl", geometry::Repair::automatic);
    EXPECT_FALSE(result.report.wrapped);
    EXPECT_NO_THROW(geometry::repair_surface(open, "body.stl", geometry::Repair::wrap)); // the ball stays outside
    ASSERT_EQ(result.report.edges.holes.size(), 1u);
    EXPECT_GT(result.report.edges.holes[0].length_mm, 20.0);
    // A flat lid would lose 3.5 % of the volume.
    EXPECT_NEAR(result.report.volume_after_mm3, ellipsoid_volume, 0.015 * ellipsoid_volume);
}

TEST(Repair, MendsWhatCrossesItself)
{
    TriangleMesh crossed = ellipsoid();
    for (const std::size_t v : {10u, 300u})
    {
        crossed.vertices[v] = -1.2 * crossed.vertices[v]; // through the opposite side
    }
    EXPECT_THAT(refusal(crossed, geometry::Repair::none), HasSubstr("self-intersecting"));
    const geometry::RepairedSurface result = geometry::repair_surface(crossed, "body.stl", geometry::Repair::automatic);
    EXPECT_GT(result.report.crossing_pairs, 0);
    EXPECT_NEAR(result.report.volume_after_mm3, ellipsoid_volume, 0.01 * ellipsoid_volume);

    TriangleMesh rumpled = ellipsoid();
    for (std::size_t v = 0; v < rumpled.vertices.size(); v += 50)
    {
        rumpled.vertices[v] += 1.2 * normalized(Vec3{hash_uniform(1, v), hash_uniform(2, v), hash_uniform(3, v)});
    }
    EXPECT_THAT(refusal(rumpled, geometry::Repair::none), HasSubstr("self-intersecting"));
    expect_repaired(rumpled);
}

TEST(Repair, TurnsASurfaceOutward)
{
    EXPECT_THAT(refusal(inside_out(ellipsoid()), geometry::Repair::none), HasSubstr("inside-out"));
    const geometry::RepairReport report = expect_repaired(inside_out(ellipsoid()));
    EXPECT_TRUE(report.inside_out);
    EXPECT_THAT(report.lines, Contains(HasSubstr("outward")));
    TriangleMesh mixed = ellipsoid();
    for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    {
        std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
    }
    EXPECT_THAT(refusal(mixed, geometry::Repair::none), HasSubstr("inconsistent orientation"));
    EXPECT_GT(expect_repaired(mixed).edges.opposed_edges, 0);
}

TEST(Repair, MergesEqualAndNearlyEqualVertices)
{
    EXPECT_EQ(refusal(exploded(ellipsoid()), geometry::Repair::none), "");
    TriangleMesh rough = exploded(ellipsoid());
    for (std::size_t v = 0; v < rough.vertices.size(); ++v)
    {
        rough.vertices[v].x += 1e-6 * hash_uniform(7, v);
    }
    EXPECT_THAT(refusal(rough, geometry::Repair::none), HasSubstr("open surface"));
    const geometry::RepairReport report = expect_repaired(rough);
    EXPECT_EQ(report.duplicate_vertices, std::ssize(rough.vertices) - std::ssize(ellipsoid().vertices));
    EXPECT_EQ(report.edges.boundary_edges, 0);
}

TEST(Repair, DropsDoubledTriangles)
{
    TriangleMesh doubled = ellipsoid();
    doubled.triangles.push_back(doubled.triangles[5]);
    doubled.triangles.push_back({doubled.triangles[9][1], doubled.triangles[9][0], doubled.triangles[9][2]});
    EXPECT_THAT(refusal(doubled, geometry::Repair::none), HasSubstr("not manifold"));
    const geometry::RepairReport report = expect_repaired(doubled);
    EXPECT_EQ(report.dropped_triangles, 2);
    EXPECT_FALSE(report.wrapped);
}

TEST(Repair, KeepsTheBodyAmongShells)
{
    const TriangleMesh cavity = inside_out(geometry::make_ellipsoid({4.0, 3.0, 3.0}, 0.8));
    const TriangleMesh crumb = moved(geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.5), {20.0, 0.0, 0.0});
    const TriangleMesh shells = together(together(cavity, ellipsoid()), crumb);
    EXPECT_THAT(refusal(shells, geometry::Repair::none), HasSubstr("3 components"));
    const geometry::RepairReport report = expect_repaired(shells);
    EXPECT_EQ(report.shell_volumes_mm3.size(), 3u);
    EXPECT_THAT(report.lines, Contains(HasSubstr("inner shell")));
    EXPECT_THAT(report.lines, Contains(HasSubstr("loose shells")));
}

TEST(Repair, RefusesToChooseBetweenBodies)
{
    const TriangleMesh two = together(ellipsoid(), moved(ellipsoid(), {30.0, 0.0, 0.0}));
    for (const geometry::Repair choice : {geometry::Repair::automatic, geometry::Repair::wrap})
    {
        const std::string message = refusal(two, choice);
        EXPECT_THAT(message, HasSubstr("body.stl: several shells"));
        EXPECT_THAT(message, Not(HasSubstr("\n")));
    }
}

TEST(Repair, WrapsBodiesThatOverlapIntoOne)
{
    const TriangleMesh two = together(ellipsoid(), moved(ellipsoid(), {10.0, 0.0, 0.0}));
    EXPECT_THAT(refusal(two, geometry::Repair::automatic), HasSubstr("several shells"));
    // The lens that two unit spheres share at distance 1 has the volume 5 pi / 12.
    const double both = 2.0 * ellipsoid_volume - 5.0 * std::numbers::pi / 12.0 * 10.0 * 8.0 * 7.0;
    const geometry::RepairedSurface result = geometry::repair_surface(two, "body.stl", geometry::Repair::wrap);
    EXPECT_NEAR(result.report.volume_after_mm3, both, 0.01 * both);
}

TEST(Repair, WrapsWhatCannotBeMended)
{
    TriangleMesh walled = box({0, 0, 0}, {10, 8, 6});
    walled.triangles.insert(walled.triangles.end(), {{2, 3, 5}, {2, 5, 4}}); // a wall inside, along two diagonals
    EXPECT_THAT(refusal(walled, geometry::Repair::none), HasSubstr("not manifold: 4 edges"));
    const geometry::RepairedSurface result = geometry::repair_surface(walled, "body.stl", geometry::Repair::automatic);
    EXPECT_EQ(result.report.edges.crowded_edges, 4);
    EXPECT_TRUE(result.report.wrapped);
    EXPECT_THAT(result.report.lines, Contains(HasSubstr("mending was not enough")));
    EXPECT_NEAR(result.report.volume_after_mm3, 480.0, 0.01 * 480.0);
}

TEST(Repair, RefusesNumbersThatAreNotFiniteAndWrapsThatFallInside)
{
    TriangleMesh bad = ellipsoid();
    bad.vertices[3].y = std::nan("");
    EXPECT_THAT(refusal(bad, geometry::Repair::automatic), HasSubstr("body.stl: vertex 3 is not finite"));
    const TriangleMesh open = without_cap(ellipsoid());
    EXPECT_THAT(refusal(open, geometry::Repair::wrap, {1.0, 0.1}), HasSubstr("through a hole"));
    EXPECT_THAT(refusal(open, geometry::Repair::wrap, {-1.0, 0.02}), HasSubstr("alpha_mm"));
    EXPECT_THAT(refusal(open, geometry::Repair::wrap, {1.0, 1e-9}), HasSubstr("offset_mm"));
    const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    for (const geometry::Repair choice : {geometry::Repair::automatic, geometry::Repair::wrap})
    {
        EXPECT_NE(refusal(flat, choice), "");
    }
}

TEST(Repair, GivesTheSameBitsWithAnyNumberOfThreads)
{
    const TriangleMesh open = with_holes(ellipsoid(), 0.01, 5);
    const int threads = thread_count();
    for (const geometry::Repair choice : {geometry::Repair::automatic, geometry::Repair::wrap})
    {
        set_thread_count(1);
        const geometry::RepairedSurface one = geometry::repair_surface(open, "body.stl", choice);
        set_thread_count(3);
        const geometry::RepairedSurface three = geometry::repair_surface(open, "body.stl", choice);
        set_thread_count(threads);
        EXPECT_EQ(one.mesh.vertices, three.mesh.vertices);
        EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
    }
}

TEST(Repair, AWrapDoesNotJoinBodiesThatLieApart)
{
    const TriangleMesh two = together(ellipsoid(), moved(ellipsoid(), {20.5, 0.0, 0.0}));
    for (const TriangleMesh& surface : {two, with_holes(two, 0.003, 3)})
    {
        const std::string message = refusal(surface, geometry::Repair::wrap, {2.0, 0.1});
        EXPECT_THAT(message, HasSubstr("2 bodies that lie apart"));
        EXPECT_THAT(message, HasSubstr("about (10."));
    }
}

TEST(Repair, SaysWhatAWrapSpans)
{
    // A pit of 6 mm depth and 2.4 mm width, which a ball of 2 mm does not enter.
    TriangleMesh pitted = ellipsoid();
    for (Vec3& p : pitted.vertices)
    {
        p.z -= p.z > 0.0 && std::hypot(p.x, p.y) < 1.2 ? 6.0 : 0.0;
    }
    const geometry::RepairReport report =
        geometry::repair_surface(pitted, "body.stl", geometry::Repair::wrap, {2.0, 0.1}).report;
    EXPECT_EQ(report.bodies_before, 1);
    EXPECT_EQ(report.genus_before, 0);
    EXPECT_EQ(report.genus_after, 0);
    EXPECT_GT(report.left_out_mm, 3.0);
    EXPECT_THAT(report.lines, Contains(HasSubstr("into 1 body: genus 0 became 0")));
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("spans gaps narrower than 4 mm")));
    EXPECT_THAT(geometry::repair_surface(ellipsoid(), "body.stl", geometry::Repair::wrap, {2.0, 0.1}).report.warnings,
                IsEmpty());
}

} // namespace corticle::test
