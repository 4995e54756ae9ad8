// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace corticle
{

/// a^(-1/3) for a > 0 to round-off: a guess from the exponent bits, then Newton steps r <- r (4 - a r³) / 3.
/// Inlines into vector code, which std::cbrt does not.
inline double inverse_cube_root(double a)
{
    double r = std::bit_cast<double>(std::int64_t{0x553ef0ff289dd796} - std::bit_cast<std::int64_t>(a) / 3);
    for (int step = 0; step < 4; ++step)
    {
        r *= (4.0 - a * r * r * r) * (1.0 / 3.0);
    }
    return r;
}

/// Energy density and first Piola-Kirchhoff stress of an elastic deformation.
struct ElasticResponse
{
    double deviatoric_energy = 0.0; ///< [mu_w]
    double volumetric_energy = 0.0; ///< barrier included [mu_w]
    Mat3 stress;                    ///< dW/dF_e [mu_w]
};

/// Compressible neo-Hookean solid (thesis eq. 18):
/// W = mu/2 (tr(F_e F_e^T) J_e^-2/3 - 3) + K/2 (J_e - 1)².
/// W alone stays finite as J_e -> 0, so a crushed point does not push back; below J_e = barrier_J the term
/// K/2 ln²(J_e / barrier_J) is added, which is C1 at barrier_J and grows without bound. barrier_J = 0 leaves it out.
struct NeoHookean
{
    double shear_modulus; ///< mu [mu_w]
    double bulk_modulus;  ///< K [mu_w]
    double barrier_J;     ///< [-]

    /// @param F_e  elastic deformation gradient, det F_e > 0
    ElasticResponse respond(const Mat3& F_e) const
    {
        const Mat3 cofactor_e = cofactor(F_e);
        const double J_e = dot(F_e.column[0], cofactor_e.column[0]);
        const double r = inverse_cube_root(J_e);
        const double scale = shear_modulus * r * r;
        const double trace_C = contract(F_e, F_e);
        double pressure = bulk_modulus * (J_e - 1.0); // dW/dJ_e of the volumetric part
        double volumetric = 0.5 * pressure * (J_e - 1.0);
        if (J_e < barrier_J)
        {
            const double depth = std::log(J_e / barrier_J);
            volumetric += 0.5 * bulk_modulus * depth * depth;
            pressure += bulk_modulus * depth / J_e;
        }
        return {0.5 * (scale * trace_C - 3.0 * shear_modulus), volumetric,
                scale * F_e + (pressure - scale * trace_C / (3.0 * J_e)) * cofactor_e};
    }
};

/// Cauchy stress J_e^-1 P F_e^T [mu_w].
inline Mat3 cauchy_stress(const Mat3& elastic_stress, const Mat3& F_e)
{
    return (1.0 / determinant(F_e)) * (elastic_stress * transpose(F_e));
}

} // namespace corticle
