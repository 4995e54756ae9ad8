// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/sizes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/metrics/surface_measures.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

} // namespace
} // namespace corticle
