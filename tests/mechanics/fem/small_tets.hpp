// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/random.hpp"
#include "corticle/mechanics/fem/solver.hpp"
#include "geometry/simple_tets.hpp"
#include "material/own_tissue.hpp"
#include "mechanics/tlsph/small_body.hpp"
#include "mesh/mesh_volume.hpp"

namespace corticle::test
{

/// Tets and the tissue at their centroids.
struct ElementBody
{
    fem::TetElements elements;
    OwnTissue tissue;
};

/// Elements of a mesh with tissue of one kind: no growth, white, normals along z.
inline ElementBody plain_elements(const TetMesh& mesh)
{
    const double spacing = std::cbrt(mesh_volume(mesh) / static_cast<double>(mesh.vertices.size()));
    ElementBody body{fem::make_elements(mesh.vertices, fem::ordered_tets(mesh.vertices, mesh.tets), spacing), {}};
    const std::size_t count = body.elements.tets.size();
    body.tissue.volume = body.elements.volume;
    body.tissue.depth.assign(count, 1.0);
    body.tissue.normal.assign(count, Vec3{0, 0, 1});
    body.tissue.regional_rate.assign(count, 1.0);
    body.tissue.theta.assign(count, 0.0);
    return body;
}

/// A cube of 5 mm of 3,072 irregular tets with theta from 1 at the surface to 0, growth that varies, and normals along
/// the radii from its middle.
inline ElementBody layered_block()
{
    constexpr double half = 2.5;
    TetMesh mesh = tet_box(8, {-half, -half, -half}, {half, half, half});
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        mesh.vertices[i] += 0.06 * random_vector(11, i);
    }
    ElementBody body = plain_elements(mesh);
    const std::vector<Vec3> centres = fem::centroids(body.elements.X, body.elements.tets);
    for (std::size_t e = 0; e < centres.size(); ++e)
    {
        const Vec3& X = centres[e];
        body.tissue.depth[e] = half - std::max({std::abs(X.x), std::abs(X.y), std::abs(X.z)});
        body.tissue.normal[e] = normalized(X);
        body.tissue.regional_rate[e] = 0.7 + 0.5 * hash_uniform(5, e);
    }
    body.tissue.options.thickness_mm = 0.8;
    body.tissue.set_layer(0.0);
    return body;
}

} // namespace corticle::test
