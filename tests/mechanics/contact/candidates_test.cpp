// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/candidates.hpp"

#include "corticle/geometry/shapes.hpp"
#include "corticle/mesh/distance.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

bool share(std::span<const std::int32_t> a, std::span<const std::int32_t> b)
{
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

TEST(Candidates, EqualThoseOfABruteForceSearchOnACrumpledSurface)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({3, 2, 1}, 0.4);
    std::vector<Vec3> x = test::perturbed(mesh.vertices, 0.3);
    x[5].x += 40.0; // long boxes among short ones
    x[9].y += 4.0;
    contact::SurfaceParts parts(mesh.triangles, mesh.vertices);
    const std::span<const contact::Edge> edges = parts.edges();
    const std::span<const Triangle> triangles = parts.triangles();
    const auto at = [&](std::int32_t k) { return x[static_cast<std::size_t>(k)]; };
    for (const double range : {0.05, 0.3})
    {
        std::vector<double> reach;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            reach.push_back(0.1 * range * static_cast<double>(7 * k % 5));
        }
        const auto reach_of = [&](std::span<const std::int32_t> part)
        {
            double largest = 0.0;
            for (const std::int32_t k : part)
            {
                largest = std::max(largest, reach[static_cast<std::size_t>(k)]);
            }
            return largest;
        };
        std::vector<std::pair<std::int32_t, std::int32_t>> vertex_triangle;
        std::vector<std::pair<std::int32_t, std::int32_t>> edge_edge;
        for (std::int32_t v = 0; v < std::ssize(x); ++v)
        {
            for (std::int32_t k = 0; k < std::ssize(triangles); ++k)
            {
                const Triangle& t = triangles[static_cast<std::size_t>(k)];
                const auto w = closest_on_triangle(at(v), at(t[0]), at(t[1]), at(t[2]));
                const Vec3 between = at(v) - w[0] * at(t[0]) - w[1] * at(t[1]) - w[2] * at(t[2]);
                if (!share(std::array{v}, t) && norm(between) < range + reach_of(std::array{v}) + reach_of(t))
                {
                    vertex_triangle.emplace_back(v, k);
                }
            }
        }
        for (std::int32_t a = 0; a < std::ssize(edges); ++a)
        {
            for (std::int32_t b = a + 1; b < std::ssize(edges); ++b)
            {
                const contact::Edge& e = edges[static_cast<std::size_t>(a)];
                const contact::Edge& o = edges[static_cast<std::size_t>(b)];
                const auto [s, t] = closest_of_segments(at(e[0]), at(e[1]), at(o[0]), at(o[1]));
                const Vec3 between = (1.0 - s) * at(e[0]) + s * at(e[1]) - (1.0 - t) * at(o[0]) - t * at(o[1]);
                if (!share(e, o) && norm(between) < range + reach_of(e) + reach_of(o))
                {
                    edge_edge.emplace_back(a, b);
                }
            }
        }
        ASSERT_GT(vertex_triangle.size(), 50u);
        contact::Candidates found;
        parts.find_candidates(x, range, reach, {}, found);
        std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
        for (const contact::VertexTriangle& pair : found.vertex_triangle)
        {
            pairs.emplace_back(pair.vertex, pair.triangle);
        }
        std::ranges::sort(pairs);
        EXPECT_EQ(pairs, vertex_triangle);
        pairs.clear();
        for (const contact::EdgeEdge& pair : found.edge_edge)
        {
            pairs.emplace_back(pair.first, pair.second);
        }
        std::ranges::sort(pairs);
        EXPECT_EQ(pairs, edge_edge);
    }
}

/// What a list holds stays in the order of a longer one: forces are sums over near pairs, whichever list they came
/// from.
TEST(Candidates, StandInTheSameOrderInAShortAndALongList)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({3, 2, 1}, 0.3);
    const std::vector<Vec3> x = test::perturbed(mesh.vertices, 0.3);
    contact::SurfaceParts parts(mesh.triangles, mesh.vertices);
    const auto edge_pairs = [&](double reach)
    {
        contact::Candidates found;
        parts.find_candidates(x, 0.05, std::vector(x.size(), reach), {}, found);
        return found.edge_edge;
    };
    const std::vector<contact::EdgeEdge> few = edge_pairs(0.0);
    const std::vector<contact::EdgeEdge> many = edge_pairs(0.1);
    ASSERT_GT(few.size(), 50u);
    ASSERT_GT(many.size(), 2 * few.size());
    auto next = many.begin();
    for (const contact::EdgeEdge& pair : few)
    {
        next = std::find_if(next, many.end(),
                            [&](const contact::EdgeEdge& other)
                            { return other.first == pair.first && other.second == pair.second; });
        ASSERT_NE(next, many.end());
    }
}

TEST(SurfaceParts, MeasureEveryPairAsTheClosestPointsOfItsPartsDo)
{
    const TriangleMesh mesh = geometry::make_ellipsoid({3, 2, 1}, 0.5);
    const std::vector<Vec3> x = test::perturbed(mesh.vertices, 0.3);
    const contact::SurfaceParts parts(mesh.triangles, mesh.vertices);
    const auto at = [&](std::int32_t k) { return x[static_cast<std::size_t>(k)]; };
    std::vector<contact::VertexTriangle> faces;
    std::vector<contact::EdgeEdge> crossings;
    for (std::int32_t k = 0; k < 21; ++k) // the last group is not full
    {
        faces.push_back({(7 * k) % static_cast<std::int32_t>(x.size()), k, 0.0});
        crossings.push_back({k, (11 * k + 5) % static_cast<std::int32_t>(parts.edges().size()), 0.0});
    }
    parts.measure(x, faces);
    parts.measure(x, crossings);
    for (std::size_t k = 0; k < faces.size(); ++k)
    {
        const auto v = contact::vertices_of(faces[k], parts.triangles().data());
        const auto w = closest_on_triangle(at(v[0]), at(v[1]), at(v[2]), at(v[3]));
        EXPECT_NEAR(faces[k].distance, norm(at(v[0]) - w[0] * at(v[1]) - w[1] * at(v[2]) - w[2] * at(v[3])), 1e-12);
        const auto e = contact::vertices_of(crossings[k], parts.edges().data());
        const auto [s, t] = closest_of_segments(at(e[0]), at(e[1]), at(e[2]), at(e[3]));
        const Vec3 between = (1.0 - s) * at(e[0]) + s * at(e[1]) - (1.0 - t) * at(e[2]) - t * at(e[3]);
        EXPECT_NEAR(crossings[k].distance, norm(between), 1e-12);
    }
}

TEST(UniqueEdges, EachOnceInOrder)
{
    const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    EXPECT_EQ(contact::unique_edges(tetrahedron),
              (std::vector<contact::Edge>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

} // namespace
} // namespace corticle
