// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/wide_tissue.hpp"
#include "corticle/mechanics/fem/elements.hpp"

// The law of a linear tetrahedron, for the eight of a block at once. See docs/theory/fem.md.

namespace corticle
{

/// What the nodes of a tet give it: sums over its four corners.
struct NodalSums
{
    WideLanes pressure; ///< K U'(Ja) [mu_w]
    WideLanes density;  ///< U(Ja): volumetric energy per bulk modulus [-]
    WideLanes work;     ///< K U'(Ja) Ja [mu_w]
};

/// What a tet gives.
struct TetResponse
{
    WideVec3 force[3];   ///< on the corners 1, 2, 3 [mu_w mm²]; corner 0 gets minus their sum
    WideLanes stiffness; ///< V (K + 4 mu/3) J_g times the largest eigenvalue of the sum of g g^T over the corners,
                         ///< with g the gradient of the shape function in the current configuration [mu_w mm]
    WideLanes energy;    ///< deviatoric [mu_w mm³]
    WideLanes power;     ///< dE/dt at fixed positions, the nodal part included [mu_w mm³]
    WideLanes J;
    WideLanes flatness; ///< a lower bound of the smallest principal stretch of F_e where J > 0
};

/// Positions of the tets of a block now: edges x_a - x_0, a = 1, 2, 3.
using WideEdges = WideVec3[3];

CORTICLE_INLINE WideLanes in_lanes(const double (&values)[wide_lanes])
{
    return *reinterpret_cast<const WideMemory*>(values);
}

/// Sums of rows and edges between them: @param local  four numbers of every node of the chunk
CORTICLE_INLINE WideVec3 gather_corner(const TetBlock& block, const Lanes* local, int corner)
{
    return WideGroup{0, wide_lanes}.gather_rows([&](std::int64_t l) -> const Lanes&
                                                { return local[block.corner[corner][l]]; });
}
CORTICLE_INLINE void gather_edges(const TetBlock& block, const Lanes* local, WideEdges& edge)
{
    const WideVec3 origin = gather_corner(block, local, 0);
    for (int a = 0; a < 3; ++a)
    {
        edge[a] = gather_corner(block, local, a + 1) - origin;
    }
}

/// Gradient of the shape function of corner a + 1 in the reference configuration [1/mm].
CORTICLE_INLINE WideVec3 shape_gradient(const TetBlock& block, int a)
{
    return {in_lanes(block.inverse_edges[3 * a]), in_lanes(block.inverse_edges[3 * a + 1]),
            in_lanes(block.inverse_edges[3 * a + 2])};
}

/// F = sum_a e_a B_a^T
CORTICLE_INLINE WideMat3 gradients(const TetBlock& block, const WideEdges& edge)
{
    return outer(edge[0], shape_gradient(block, 0)) + outer(edge[1], shape_gradient(block, 1)) +
           outer(edge[2], shape_gradient(block, 2));
}

/// v of every tet [mm³]
CORTICLE_INLINE WideLanes volumes(const WideEdges& edge)
{
    return dot(edge[0], cross(edge[1], edge[2])) / 6.0;
}

/// det G
CORTICLE_INLINE WideLanes growth_volume(const BasicMaterialPoint<WideLanes>& point)
{
    return point.growth * point.growth * point.radial_growth;
}

/// Forces, energy and growth power of the tets where nothing is extrapolated.
CORTICLE_INLINE TetResponse respond(const TetBlock& block, const WideEdges& edge, const WideMat3& F,
                                    const WideTissue& tissue, const NodalSums& nodal)
{
    const auto& point = tissue.point;
    const WideLanes V = in_lanes(block.volume);
    const WideLanes J_g = growth_volume(point);
    const WideMat3 inverse_G = inverse_growth_tensor(point.growth, tissue.normal, point.radial_growth);
    const WideMat3 F_e = F * inverse_G;
    const WideMat3 cofactor_e = cofactor(F_e);
    const WideLanes J_e = dot(F_e.column[0], cofactor_e.column[0]);
    const BasicNeoHookean<WideLanes> law{point.shear_modulus, point.bulk_modulus, 0.0};
    const DeviatoricResponse<WideLanes> shape = law.respond_to_shape(F_e, cofactor_e, J_e);

    TetResponse out;
    const WideMat3 P = (V * J_g) * (shape.stress * inverse_G) + (0.25 * nodal.pressure * V) * cofactor(F);
    for (int a = 0; a < 3; ++a)
    {
        out.force[a] = -(P * shape_gradient(block, a));
    }

    const WideLanes growth = point.growth_rate / point.growth;
    const WideLanes radial_growth = point.radial_growth_rate / point.radial_growth;
    const WideLanes swelling = 2.0 * growth + radial_growth; // dJ_g/dt / J_g
    const WideLanes radial = dot(shape.stress * tissue.normal, F_e * tissue.normal);
    const WideLanes tangential = contract(shape.stress, F_e) - radial;
    out.power = V * J_g *
                (swelling * shape.energy - growth * tangential - radial_growth * radial +
                 shape.energy * point.shear_rate / point.shear_modulus +
                 0.25 * ((swelling * point.bulk_modulus + point.bulk_rate) * nodal.density - swelling * nodal.work));
    out.energy = V * J_g * shape.energy;
    const WideLanes six_v = 6.0 * volumes(edge);
    out.J = six_v / (6.0 * V);
    out.flatness = 2.0 * J_e / contract(F_e, F_e); // s_3 = J_e / (s_1 s_2), and s_1 s_2 <= (s_1² + s_2²) / 2

    // Twice the areas of the faces opposite to the corners, inwards, are 6 v times the gradients now. The largest
    // eigenvalue of their sum of squares by the mean and deviation of the three (Wolkowicz & Styan 1980).
    const WideVec3 a1 = cross(edge[1], edge[2]);
    const WideVec3 a2 = cross(edge[2], edge[0]);
    const WideVec3 a3 = cross(edge[0], edge[1]);
    const WideVec3 a0 = a1 + a2 + a3;
    const WideMat3 T = (outer(a0, a0) + outer(a1, a1)) + (outer(a2, a2) + outer(a3, a3));
    const WideLanes mean = trace(T) / 3.0;
    const WideLanes variance = larger<WideLanes>(contract(T, T) / 3.0 - mean * mean, WideLanes{});
    out.stiffness = V * J_g * (point.bulk_modulus + 4.0 / 3.0 * point.shear_modulus) *
                    (mean + square_root(2.0 * variance)) / (six_v * six_v);
    return out;
}

} // namespace corticle
