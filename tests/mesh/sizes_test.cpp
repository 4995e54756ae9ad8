// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/sizes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/cloud/from_tets.hpp"
#include "corticle/cloud/line_lattice.hpp"
#include "corticle/cloud/neighbors.hpp"
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/cloud/thinning.hpp"
#include "corticle/geometry/alpha_wrap.hpp"
#include "corticle/geometry/bodies.hpp"
#include "corticle/geometry/delaunay_flips.hpp"
#include "corticle/geometry/mend.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/geometry/repulsion.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/tetrahedralize.hpp"
#include "corticle/imaging/distance_transform.hpp"
#include "corticle/imaging/handles.hpp"
#include "corticle/imaging/kuhn_grid.hpp"
#include "corticle/imaging/marching_tetrahedra.hpp"
#include "corticle/imaging/mask_cleanup.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/metrics/surface_measures.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace corticle
{
namespace
{

TEST(Sizes, ArraysOfAnotherLengthAreRefusedAtEntry)
{
    const test::Body body = test::small_sphere();
    tlsph::TlsphSolver solver(body.particles, body.tissue);
    const std::vector<Vec3>& X = body.cloud.positions;
    std::vector<Vec3> few(7);
    std::vector<Vec3> forces(X.size());
    EXPECT_THROW(solver.evaluate(few, 0.0, forces), InputError);
    EXPECT_THROW(solver.evaluate(X, 0.0, few), InputError);
    EXPECT_THROW(solver.deformation_gradients(few), InputError);
    EXPECT_THROW(contact::SurfaceContact(body.surface.triangles, body.surface.vertices, {1.0, 2.0}, 1.0, 1.0, {}),
                 InputError);
    EXPECT_THROW(metrics::measure_folds(body.surface.vertices, body.surface.triangles, {}), InputError);
}

TEST(Sizes, TrianglesNameVerticesThatExist)
{
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NO_THROW(require_triangles(vertices, std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_THROW(require_triangles(vertices, {}), InputError);
    try
    {
        metrics::measure_surface(vertices, std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}});
        ADD_FAILURE() << "no error";
    }
    catch (const InputError& error)
    {
        EXPECT_STREQ(error.what(), "triangle 1: got vertex 3, expected 0 to 2");
    }
}

TEST(Sizes, LengthsArePositiveAndFinite)
{
    const TriangleMesh sphere = geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.5);
    for (const double length : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    {
        EXPECT_THROW(cloud::fill_surface(sphere, {.spacing = length}), InputError);
        EXPECT_THROW(cloud::find_pairs_within(sphere.vertices, length), InputError);
        EXPECT_THROW(cloud::spacing_for_particles(length, 10), InputError);
        EXPECT_THROW(cloud::LineLattice(sphere, length), InputError);
        EXPECT_THROW(geometry::remesh_isotropic(sphere, length), InputError);
        EXPECT_THROW(geometry::alpha_wrap(sphere, length, 0.1), InputError);
        EXPECT_THROW(geometry::make_ellipsoid({1.0, length, 1.0}, 0.5), InputError);
        EXPECT_THROW(geometry::nodes_for_tets(1000, length, 1.0, 1.0), InputError);
    }
}

TEST(Sizes, MeshesNameVerticesThatExist)
{
    TriangleMesh broken = geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.5);
    broken.triangles[7][1] = 100000;
    EXPECT_THROW(geometry::SurfaceTree(broken.vertices, broken.triangles), InputError);
    EXPECT_THROW(geometry::self_intersections(broken), InputError);
    std::int64_t filled = 0;
    EXPECT_THROW(geometry::orient_and_fill_holes(broken, filled), InputError);
    EXPECT_THROW(geometry::find_bodies(broken), InputError);
    EXPECT_THROW(geometry::flip_to_delaunay(broken), InputError);
    EXPECT_THROW(geometry::remesh_isotropic(broken, 0.5), InputError);
    EXPECT_THROW(geometry::tetrahedralize(broken, 100), InputError);
    EXPECT_THROW(cloud::fill_surface(broken, {.spacing = 0.3}), InputError);
    EXPECT_THROW(cloud::cloud_from_tets({broken.vertices, {{0, 1, 2, -1}}}), InputError);
    EXPECT_THROW(cloud::cloud_from_tets({broken.vertices, {}}), InputError);
}

TEST(Sizes, PointsAreFiniteAndAllHaveVolumes)
{
    TriangleMesh sphere = geometry::make_ellipsoid({1.0, 1.0, 1.0}, 0.5);
    const std::vector<double> few(7, 1.0);
    EXPECT_THROW(cloud::ordered_cloud(sphere.vertices, {few, sphere.vertices}, sphere), InputError);
    EXPECT_THROW(cloud::thin_random_by_volume(sphere.vertices, few, 3, 1), InputError);
    EXPECT_THROW(cloud::thin_uniform_beside({}, sphere.vertices, few, 3, 1), InputError);
    std::vector<Vec3> moves;
    const std::vector<double> ranges(sphere.vertices.size(), 1.0);
    EXPECT_THROW(geometry::repulsion_moves(sphere.vertices, 0, few, 0.1, 0.1, moves), InputError);
    EXPECT_THROW(geometry::repulsion_moves(sphere.vertices, 100000, ranges, 0.1, 0.1, moves), InputError);
    sphere.vertices[4].y = std::nan("");
    EXPECT_THROW(cloud::thin_uniform(sphere.vertices, 3, 1), InputError);
    EXPECT_THROW(cloud::find_pairs_within(sphere.vertices, 1.0), InputError);
    EXPECT_THROW(geometry::SurfaceTree(sphere.vertices, sphere.triangles), InputError);
}

TEST(Sizes, MasksHaveTheVoxelsOfTheirGrid)
{
    const imaging::VoxelGrid grid{{4, 5, 6}, {}};
    imaging::Mask few(7, 0);
    std::vector<float> values(7, 0.0F);
    EXPECT_THROW(imaging::euler_characteristic(grid, few), InputError);
    EXPECT_THROW(imaging::kuhn_components(grid, few, 0), InputError);
    EXPECT_THROW(imaging::squared_distance_to(grid, few, 1), InputError);
    EXPECT_THROW(imaging::fill_cavities(grid, few), InputError);
    EXPECT_THROW(imaging::marching_tetrahedra(grid, values, 0.5F), InputError);
    EXPECT_THROW(imaging::remove_handles(grid, few, values, 0.5F), InputError);
    EXPECT_THROW(imaging::kuhn_components({{0, 5, 6}, {}}, {}, 0), InputError);
}

} // namespace
} // namespace corticle
