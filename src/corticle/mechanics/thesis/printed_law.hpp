// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/growth.hpp"
#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/thesis/options.hpp"

namespace corticle
{

/// Stress of a grown material point.
struct GrownResponse
{
    Mat3 P;                      ///< first Piola-Kirchhoff stress [mu_w]
    double energy = 0.0;         ///< per reference volume [mu_w]
    double growth_power = 0.0;   ///< its rate at fixed F, per unit of growth time [mu_w]
    double elastic_volume = 1.0; ///< ratio that the barrier looks at
};

/// F G for F (thesis eqs. 22 and 23): P = dW/dF (F G), energy W(F G), neither of which knows that F G is no
/// deformation.
CORTICLE_INLINE GrownResponse respond_multiplied(const NeoHookean& law, const MaterialPoint& point, const Vec3& n,
                                                 const Mat3& F)
{
    const Mat3 across = outer(n, n);
    const Mat3 along = Mat3::identity() - across;
    const Mat3 F_G = F * (point.growth * along + point.radial_growth * across);
    const ElasticResponse elastic = law.respond(F_G);
    return {elastic.stress, elastic.deviatoric_energy + elastic.volumetric_energy,
            contract(elastic.stress, F * (point.growth_rate * along + point.radial_growth_rate * across)),
            determinant(F_G)};
}

/// F G^-1 and the stress pulled back, as in TlsphSolver.
CORTICLE_INLINE GrownResponse respond_divided(const NeoHookean& law, const MaterialPoint& point, const Vec3& n,
                                              const Mat3& F)
{
    const double g = point.growth;
    const double g_r = point.radial_growth;
    const Mat3 inverse_G = inverse_growth_tensor(g, n, g_r);
    const Mat3 F_e = F * inverse_G;
    const ElasticResponse elastic = law.respond(F_e);
    const double J_g = g * g * g_r;
    const double density = elastic.deviatoric_energy + elastic.volumetric_energy;
    const double radial_work = dot(elastic.stress * n, F_e * n);
    const double tangential_work = contract(elastic.stress, F_e) - radial_work;
    return {J_g * (elastic.stress * inverse_G), J_g * density,
            point.growth_rate * g_r * g * (2.0 * density - tangential_work) +
                point.radial_growth_rate * g * g * (density - radial_work) +
                J_g * (point.shear_rate / point.shear_modulus * elastic.deviatoric_energy +
                       point.bulk_rate / point.bulk_modulus * elastic.volumetric_energy),
            determinant(F_e)};
}

} // namespace corticle
