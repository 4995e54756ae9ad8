// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/response.hpp"
#include "corticle/material/wide_remodelling.hpp"
#include "corticle/mechanics/fem/elements.hpp"
#include "corticle/mechanics/fem/extrapolation.hpp"

// The law of a linear tetrahedron, for the eight of a block at once. See docs/theory/fem.md.

namespace corticle::fem
{

/// What the nodes of a tet give it: sums over its four corners.
template <RealLike Real>
struct BasicNodalSums
{
    Real pressure; ///< K U'(Ja) [mu_w]
    Real density;  ///< U(Ja): volumetric energy per bulk modulus [-]
    Real work;     ///< K U'(Ja) Ja [mu_w]
};
using NodalSums = BasicNodalSums<WideLanes>;

/// Power of growth and of moving layers on the volumetric energy of the nodes of a tet, per grown volume [mu_w].
template <bool plain = false, RealLike Real>
CORTICLE_INLINE Real nodal_power(const material::BasicMaterialPoint<Real>& point, const BasicNodalSums<Real>& nodal)
{
    const Real swelling = material::swelling_rate<plain>(point);
    return 0.25 * ((swelling * point.bulk_modulus + point.bulk_rate) * nodal.density - swelling * nodal.work);
}

/// What a tet gives.
struct TetResponse
{
    WideVec3 force[3];   ///< on the corners 1, 2, 3 [mu_w mm²]; corner 0 gets minus their sum
    WideLanes stiffness; ///< V (K + 4 mu/3) J_g times the largest eigenvalue of the sum of g g^T over the corners,
                         ///< with g the gradient of the shape function in the current configuration [mu_w mm]
    WideLanes energy;    ///< deviatoric [mu_w mm³]
    WideLanes power;     ///< dE/dt at fixed positions, the nodal part included [mu_w mm³]
    WideLanes released;  ///< by the step of the history, the nodal part included to first order [mu_w mm³]
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

/// A lower bound of the smallest principal stretch: s_3 = J_e / (s_1 s_2), and s_1 s_2 <= (s_1² + s_2²) / 2.
template <class Law>
CORTICLE_INLINE WideLanes flatness(const Law& /*law*/, const material::ElasticDeformation<WideLanes>& e)
{
    return 2.0 * e.J_e / contract(e.F_e, e.F_e);
}
/// Of what the matrix sees.
CORTICLE_INLINE WideLanes flatness(const material::WideRemodelled& law,
                                   const material::ElasticDeformation<WideLanes>& e)
{
    const WideMat3 seen = e.F_e * law.branch;
    return 2.0 * e.J_e * (law.branch(0, 0) * law.branch(1, 1) * law.branch(2, 2)) / contract(seen, seen);
}

/// Forces, energy and growth power of the tets where nothing is extrapolated.
template <bool plain, material::Material<WideLanes> Law>
CORTICLE_INLINE TetResponse respond(const Law& law, const TetBlock& block, const WideEdges& edge, const WideMat3& F,
                                    const material::WideTissue& tissue, const NodalSums& nodal)
{
    const auto& point = tissue.point;
    const WideLanes V = in_lanes(block.volume);
    const WideLanes J_g = material::growth_volume<plain>(point);
    const material::ElasticDeformation<WideLanes> e = material::elastic_deformation<plain>(point, tissue.normal, F);
    const material::DeviatoricResponse<WideLanes> shape =
        law.respond_to_shape(point.shear_modulus, e.F_e, e.cofactor_e, e.J_e);

    TetResponse out;
    const WideMat3 P = (V * J_g) * (shape.stress * e.inverse_G) + (0.25 * nodal.pressure * V) * cofactor(F);
    for (int a = 0; a < 3; ++a)
    {
        out.force[a] = -(P * shape_gradient(block, a));
    }
    out.power = V * J_g *
                (material::growth_power<plain>(point, tissue.normal, e.F_e, {shape.energy, WideLanes{}, shape.stress}) +
                 nodal_power<plain>(point, nodal));
    out.energy = V * J_g * shape.energy;
    const WideLanes six_v = 6.0 * volumes(edge);
    out.J = six_v / (6.0 * V);
    out.flatness = flatness(law, e);
    out.released = WideLanes{};
    if constexpr (requires { law.released; })
    {
        const WideLanes nodal_part =
            0.25 * law.growth_step * (point.bulk_modulus * nodal.density - nodal.work); // as in nodal_power
        out.released =
            out.flatness > extrapolated_stretch ? WideLanes{V * (law.released - J_g * nodal_part)} : WideLanes{};
    }

    // Twice the areas of the faces opposite to the corners, inwards, are 6 v times the gradients now. The largest
    // eigenvalue of their sum of squares by the mean and deviation of the three (Wolkowicz & Styan 1980).
    const WideVec3 a1 = cross(edge[1], edge[2]);
    const WideVec3 a2 = cross(edge[2], edge[0]);
    const WideVec3 a3 = cross(edge[0], edge[1]);
    const WideVec3 a0 = a1 + a2 + a3;
    const WideMat3 T = (outer(a0, a0) + outer(a1, a1)) + (outer(a2, a2) + outer(a3, a3));
    const WideLanes mean = trace(T) / 3.0;
    const WideLanes variance = larger<WideLanes>(contract(T, T) / 3.0 - mean * mean, WideLanes{});
    out.stiffness = V * J_g * material::longitudinal_modulus(law, point) *
                    (mean + square_root<WideLanes>(2.0 * variance)) / (six_v * six_v);
    return out;
}

} // namespace corticle::fem
