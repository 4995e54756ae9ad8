// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace corticle::study
{

/// A part of a surface as other programs want it: alone in its file.
struct SurfacePart
{
    std::string structure;           ///< as Connectome Workbench calls it: "CortexLeft"
    std::string letter;              ///< "L", "R"
    std::vector<std::int32_t> kept;  ///< numbers of its vertices in the whole surface, ascending
    std::vector<Triangle> triangles; ///< in numbers of `kept`
};

/// Whether the surface falls into pieces that lie to the left or to the right of the middle of its extent along x, some
/// on each side: hemispheres that nothing connects.
bool has_separate_hemispheres(const TriangleMesh& surface);

/// The left and the right part. With `cuts` the surface is cut in the middle of its extent along x, between triangles,
/// each of which goes where its centre is; else each piece that nothing connects with others goes where its middle is.
std::vector<SurfacePart> hemispheres(const TriangleMesh& surface, bool cuts);

} // namespace corticle::study
