// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/material.hpp"

#include <cmath>

namespace corticle::material
{

/// K/2 (J_e - 1)², and below J_e = barrier_J also K/2 ln²(J_e / barrier_J). The first term stays finite as J_e -> 0, so
/// a crushed point would not push back; the second is C1 at barrier_J and grows without bound. barrier_J = 0 leaves it
/// out.
template <RealLike Real>
CORTICLE_INLINE VolumetricResponse<Real> volumetric_response(Real bulk_modulus, Real J_e, double barrier_J)
{
    using Scalar = ScalarOf<Real>;
    const auto start = static_cast<Scalar>(barrier_J);
    Real pressure = bulk_modulus * (J_e - Scalar(1.0));
    Real energy = Scalar(0.5) * pressure * (J_e - Scalar(1.0));
    for_lanes(J_e < start,
              [&](int lane)
              {
                  if (start > Scalar(0.0)) // averages over elements may be negative
                  {
                      using std::log;
                      const auto& K = at_lane(bulk_modulus, lane);
                      const auto& J = at_lane(J_e, lane);
                      const auto depth = log(J / start);
                      at_lane(energy, lane) += Scalar(0.5) * K * depth * depth;
                      at_lane(pressure, lane) += K * depth / J;
                  }
              });
    return {energy, pressure};
}

} // namespace corticle::material
