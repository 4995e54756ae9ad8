// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/response.hpp"

namespace corticle::thesis
{

/// F G for F (thesis eqs. 22 and 23): P = dW/dF (F G), energy W(F G), neither of which knows that F G is no
/// deformation.
template <material::Material Law>
CORTICLE_INLINE material::Response respond_multiplied(const Law& law, const material::MaterialPoint& point,
                                                      const Vec3& n, const Mat3& F)
{
    const Mat3 across = outer(n, n);
    const Mat3 along = Mat3::identity() - across;
    const Mat3 F_G = F * (point.growth * along + point.radial_growth * across);
    const material::ElasticResponse elastic =
        material::elastic_response(law, point.shear_modulus, point.bulk_modulus, F_G);
    return {1.0,
            elastic.deviatoric_energy + elastic.volumetric_energy,
            contract(elastic.stress, F * (point.growth_rate * along + point.radial_growth_rate * across)),
            material::grown_wave_speed(law, point),
            determinant(F_G),
            elastic.stress};
}

} // namespace corticle::thesis
