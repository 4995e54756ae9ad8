// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"
#include "corticle/fem/elements.hpp"
#include "corticle/tissue/neo_hookean.hpp"
#include "corticle/tissue/tissue.hpp"

#include <algorithm>

// The law of a linear tetrahedron, for the eight of a block at once: plain loops over lanes, which the compiler turns
// into vector instructions.

namespace corticle
{

/// One value per tet of a block.
using LaneValues = double[lane_count];

/// Moduli and growth of the tets of a block: MaterialPoint, and the normal that growth is tangential to.
struct alignas(64) BlockMaterial
{
    LaneValues growth, radial_growth, growth_rate, radial_growth_rate;
    LaneValues shear_modulus, bulk_modulus, shear_rate, bulk_rate;
    LaneValues normal[3];
};

/// Volume of a tet now and grown, a quarter of which each of its nodes gets.
struct alignas(64) BlockVolumes
{
    LaneValues current; ///< v [mm³]
    LaneValues grown;   ///< J_g V [mm³]
    LaneValues bulk;    ///< K J_g V [mu_w mm³]
};

/// What the nodes of a tet give it: sums over its four corners.
struct alignas(64) BlockNodal
{
    LaneValues pressure; ///< K U'(Ja) [mu_w]
    LaneValues density;  ///< U(Ja): volumetric energy per bulk modulus [-]
    LaneValues work;     ///< K U'(Ja) Ja [mu_w]
};

/// What a tet gives.
struct alignas(64) BlockResponse
{
    LaneValues force[9];  ///< on the corners 1, 2, 3, three components each [mu_w mm²]; corner 0 gets minus their sum
    LaneValues stiffness; ///< V (K + 4 mu/3) J_g times the largest eigenvalue of the sum of g g^T over the corners,
                          ///< with g the gradient of the shape function in the current configuration [mu_w mm]
    LaneValues energy;    ///< deviatoric [mu_w mm³]
    LaneValues power;     ///< dE/dt at fixed positions, the nodal part included [mu_w mm³]
    LaneValues J;
    LaneValues flatness; ///< a lower bound of the smallest principal stretch of F_e where J > 0
};

/// Edges x_a - x_0 of the tets, entry 3 (a - 1) + component.
CORTICLE_INLINE void gather_edges(const TetBlock& block, const Lanes* x, LaneValues* edge)
{
    for (int l = 0; l < lane_count; ++l)
    {
        const Lanes origin = x[block.corner[0][l]];
        for (int a = 0; a < 3; ++a)
        {
            const Lanes along = x[block.corner[a + 1][l]] - origin;
            edge[3 * a][l] = along[0];
            edge[3 * a + 1][l] = along[1];
            edge[3 * a + 2][l] = along[2];
        }
    }
}

/// Tets of growth that Tissue::grows_plainly.
CORTICLE_INLINE void plain_material(const Tissue& tissue, const std::size_t (&tet)[lane_count], double t,
                                    BlockMaterial& m)
{
    const TissueOptions& options = tissue.options;
    LaneValues theta;
    LaneValues rate;
    for (int l = 0; l < lane_count; ++l)
    {
        theta[l] = tissue.theta[tet[l]];
        rate[l] = tissue.regional_rate[tet[l]];
        const Vec3& n = tissue.normal[tet[l]];
        m.normal[0][l] = n.x;
        m.normal[1][l] = n.y;
        m.normal[2][l] = n.z;
    }
    const double per_shear = options.bulk == BulkRule::per_tissue ? options.bulk_modulus : 0.0;
    const double constant = options.bulk == BulkRule::per_tissue ? 0.0 : options.bulk_modulus;
#pragma omp simd
    for (int l = 0; l < lane_count; ++l)
    {
        const double mu = theta[l] * options.mu_cortex + (1.0 - theta[l]) * options.mu_white;
        m.growth_rate[l] = options.alpha_t * theta[l] * rate[l];
        m.growth[l] = 1.0 + m.growth_rate[l] * t;
        m.radial_growth[l] = 1.0;
        m.radial_growth_rate[l] = 0.0;
        m.shear_modulus[l] = mu;
        m.bulk_modulus[l] = per_shear * mu + constant;
        m.shear_rate[l] = 0.0;
        m.bulk_rate[l] = 0.0;
    }
}

/// Tets of any growth. @param F  of each tet, or null where normals stay those of the reference
inline void general_material(const Tissue& tissue, const std::size_t (&tet)[lane_count], double t, const Mat3* F,
                             BlockMaterial& m)
{
    for (int l = 0; l < lane_count; ++l)
    {
        const MaterialPoint point = tissue.point(tet[l], t);
        m.growth[l] = point.growth;
        m.radial_growth[l] = point.radial_growth;
        m.growth_rate[l] = point.growth_rate;
        m.radial_growth_rate[l] = point.radial_growth_rate;
        m.shear_modulus[l] = point.shear_modulus;
        m.bulk_modulus[l] = point.bulk_modulus;
        m.shear_rate[l] = point.shear_rate;
        m.bulk_rate[l] = point.bulk_rate;
        const bool follows = F != nullptr && determinant(F[l]) > 0.0; // an inverted tet has no current normal
        const Vec3 n = follows ? tissue.growth_normal(tet[l], F[l]) : tissue.normal[tet[l]];
        m.normal[0][l] = n.x;
        m.normal[1][l] = n.y;
        m.normal[2][l] = n.z;
    }
}

CORTICLE_INLINE void block_volumes(const TetBlock& block, const LaneValues* edge, const BlockMaterial& m,
                                   BlockVolumes& out)
{
#pragma omp simd
    for (int l = 0; l < lane_count; ++l)
    {
        const double across_x = edge[4][l] * edge[8][l] - edge[5][l] * edge[7][l];
        const double across_y = edge[5][l] * edge[6][l] - edge[3][l] * edge[8][l];
        const double across_z = edge[3][l] * edge[7][l] - edge[4][l] * edge[6][l];
        out.current[l] = (edge[0][l] * across_x + edge[1][l] * across_y + edge[2][l] * across_z) / 6.0;
        out.grown[l] = m.growth[l] * m.growth[l] * m.radial_growth[l] * block.volume[l];
        out.bulk[l] = m.bulk_modulus[l] * out.grown[l];
    }
}

/// Forces, energy and growth power of the tets where nothing is extrapolated. See docs/theory/fem.md.
CORTICLE_INLINE void respond(const TetBlock& block, const LaneValues* e, const BlockMaterial& m,
                             const BlockNodal& nodal, BlockResponse& out)
{
    const auto& B = block.inverse_edges;
#pragma omp simd
    for (int l = 0; l < lane_count; ++l)
    {
        const double V = block.volume[l];
        // F = sum_a e_a B_a^T, row by row
        const double F00 = e[0][l] * B[0][l] + e[3][l] * B[3][l] + e[6][l] * B[6][l];
        const double F01 = e[0][l] * B[1][l] + e[3][l] * B[4][l] + e[6][l] * B[7][l];
        const double F02 = e[0][l] * B[2][l] + e[3][l] * B[5][l] + e[6][l] * B[8][l];
        const double F10 = e[1][l] * B[0][l] + e[4][l] * B[3][l] + e[7][l] * B[6][l];
        const double F11 = e[1][l] * B[1][l] + e[4][l] * B[4][l] + e[7][l] * B[7][l];
        const double F12 = e[1][l] * B[2][l] + e[4][l] * B[5][l] + e[7][l] * B[8][l];
        const double F20 = e[2][l] * B[0][l] + e[5][l] * B[3][l] + e[8][l] * B[6][l];
        const double F21 = e[2][l] * B[1][l] + e[5][l] * B[4][l] + e[8][l] * B[7][l];
        const double F22 = e[2][l] * B[2][l] + e[5][l] * B[5][l] + e[8][l] * B[8][l];
        const double n0 = m.normal[0][l];
        const double n1 = m.normal[1][l];
        const double n2 = m.normal[2][l];
        const double Fn0 = F00 * n0 + F01 * n1 + F02 * n2;
        const double Fn1 = F10 * n0 + F11 * n1 + F12 * n2;
        const double Fn2 = F20 * n0 + F21 * n1 + F22 * n2;

        // Twice the areas of the faces opposite to the corners 1, 2, 3, inwards: 6 times the gradient of the volume.
        const double a10 = e[4][l] * e[8][l] - e[5][l] * e[7][l];
        const double a11 = e[5][l] * e[6][l] - e[3][l] * e[8][l];
        const double a12 = e[3][l] * e[7][l] - e[4][l] * e[6][l];
        const double a20 = e[7][l] * e[2][l] - e[8][l] * e[1][l];
        const double a21 = e[8][l] * e[0][l] - e[6][l] * e[2][l];
        const double a22 = e[6][l] * e[1][l] - e[7][l] * e[0][l];
        const double a30 = e[1][l] * e[5][l] - e[2][l] * e[4][l];
        const double a31 = e[2][l] * e[3][l] - e[0][l] * e[5][l];
        const double a32 = e[0][l] * e[4][l] - e[1][l] * e[3][l];
        const double six_v = e[0][l] * a10 + e[1][l] * a11 + e[2][l] * a12;
        const double J = six_v / (6.0 * V);

        // Invariants of F_e = F G^-1 from |F|² and |F n|².
        const double g = m.growth[l];
        const double g_r = m.radial_growth[l];
        const double J_g = g * g * g_r;
        const double per_g = 1.0 / (g * g);
        const double per_g_r = 1.0 / (g_r * g_r);
        const double along = Fn0 * Fn0 + Fn1 * Fn1 + Fn2 * Fn2;
        const double squares =
            F00 * F00 + F01 * F01 + F02 * F02 + F10 * F10 + F11 * F11 + F12 * F12 + F20 * F20 + F21 * F21 + F22 * F22;
        const double radial = along * per_g_r;
        const double tangential = (squares - along) * per_g;
        const double trace_C = radial + tangential;
        const double J_e = J / J_g;
        const double r = inverse_cube_root(J_e);
        const double mu = m.shear_modulus[l];
        const double mu_r = mu * r * r;
        const double density = 0.5 * (mu_r * trace_C - 3.0 * mu);

        // V P = V J_g mu r² F G^-2 + q V cof F
        const double in_plane = V * J_g * mu_r * per_g;
        const double on_normal = V * J_g * mu_r * (per_g_r - per_g);
        const double third = (1.0 / 3.0) * mu_r * trace_C;
        const double q = (1.0 / 6.0) * (0.25 * nodal.pressure[l] - third / J_e);
        const auto force = [&](int a, double a0, double a1, double a2)
        {
            const double B0 = B[3 * a][l];
            const double B1 = B[3 * a + 1][l];
            const double B2 = B[3 * a + 2][l];
            const double nB = on_normal * (n0 * B0 + n1 * B1 + n2 * B2);
            out.force[3 * a][l] = -(in_plane * (F00 * B0 + F01 * B1 + F02 * B2) + nB * Fn0 + q * a0);
            out.force[3 * a + 1][l] = -(in_plane * (F10 * B0 + F11 * B1 + F12 * B2) + nB * Fn1 + q * a1);
            out.force[3 * a + 2][l] = -(in_plane * (F20 * B0 + F21 * B1 + F22 * B2) + nB * Fn2 + q * a2);
        };
        force(0, a10, a11, a12);
        force(1, a20, a21, a22);
        force(2, a30, a31, a32);

        const double growth = m.growth_rate[l] / g;
        const double radial_growth = m.radial_growth_rate[l] / g_r;
        const double swelling = 2.0 * growth + radial_growth; // dJ_g/dt / J_g
        out.power[l] =
            V * J_g *
            (swelling * (density + third) - growth * mu_r * tangential - radial_growth * mu_r * radial +
             density * m.shear_rate[l] / mu +
             0.25 * ((swelling * m.bulk_modulus[l] + m.bulk_rate[l]) * nodal.density[l] - swelling * nodal.work[l]));
        out.energy[l] = V * J_g * density;
        out.J[l] = J;
        out.flatness[l] = 2.0 * J_e / trace_C; // s_3 = J_e / (s_1 s_2), and s_1 s_2 <= (s_1² + s_2²) / 2

        // Largest eigenvalue of sum a a^T over the four corners by the mean and deviation of the three
        // (Wolkowicz & Styan 1980).
        const double a00 = a10 + a20 + a30;
        const double a01 = a11 + a21 + a31;
        const double a02 = a12 + a22 + a32;
        const double T00 = a00 * a00 + a10 * a10 + a20 * a20 + a30 * a30;
        const double T11 = a01 * a01 + a11 * a11 + a21 * a21 + a31 * a31;
        const double T22 = a02 * a02 + a12 * a12 + a22 * a22 + a32 * a32;
        const double T01 = a00 * a01 + a10 * a11 + a20 * a21 + a30 * a31;
        const double T02 = a00 * a02 + a10 * a12 + a20 * a22 + a30 * a32;
        const double T12 = a01 * a02 + a11 * a12 + a21 * a22 + a31 * a32;
        const double mean = (1.0 / 3.0) * (T00 + T11 + T22);
        const double variance =
            (1.0 / 3.0) * (T00 * T00 + T11 * T11 + T22 * T22 + 2.0 * (T01 * T01 + T02 * T02 + T12 * T12)) - mean * mean;
        const double largest = mean + std::sqrt(2.0 * std::max(0.0, variance));
        out.stiffness[l] = V * J_g * (m.bulk_modulus[l] + (4.0 / 3.0) * mu) * largest / (six_v * six_v);
    }
}

} // namespace corticle
