// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::geometry
{

/// A closed surface around any set of triangles, as a ball of radius `alpha` [mm] that rolls over them at a distance of
/// `offset` [mm] feels it (CGAL; Portaneri, Rouxel-Labbé, Hemmer, Cohen-Steiner & Alliez 2022). It bridges holes
/// narrower than the ball and leaves out whatever lies inside. Triangles must not be degenerate.
TriangleMesh alpha_wrap(const TriangleMesh& surface, double alpha, double offset);

/// alpha_wrap, drawn back onto the triangles: every vertex moves towards its closest point by the mean distance between
/// the wrap and the triangles, so the offset no longer adds to the volume. Where the surface then crosses itself, it
/// moves half as far, or not at all.
TriangleMesh fitted_alpha_wrap(const TriangleMesh& surface, double alpha, double offset);

/// What a ball of the given radius [mm] that rolls around a closed surface leaves free of it, a morphological closing:
/// a wrap at the distance of the radius, each vertex of it moved to its closest point of the surface. So all vertices
/// lie on the surface, and straight triangles stand for the ball where it spans a gap. For distances: triangles without
/// area are left out, and others may fold over at the rim of a gap.
TriangleMesh closed_around(const TriangleMesh& surface, double radius);

} // namespace corticle::geometry
