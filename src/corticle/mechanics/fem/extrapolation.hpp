// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/material.hpp"

namespace corticle::fem
{

/// Principal stretch below which the deviatoric law is extrapolated [-].
inline constexpr double extrapolated_stretch = 0.1;

/// F = U diag(stretch) V^T with rotations U and V. Stretches fall in size; the last is negative where det F < 0.
struct SingularValues
{
    Mat3 U;
    Mat3 V;
    Vec3 stretch;
};
SingularValues singular_values(const Mat3& F);

/// Deviatoric part of the neo-Hookean law, W = mu/2 (tr(F_e F_e^T) J_e^-2/3 - 3), continued below a principal stretch
/// of 0.1, so that flat and inverted elements keep a finite energy and a force that opens them (Tallinen et al. 2016,
/// in their published code): with c_i = max(stretch_i, 0.1) and d_i = stretch_i - c_i,
/// W = W(c) + sum_i W_i(c) d_i + K/2 sum_i d_i².
/// @return the parts of the energy with mu and with K, as if they were a law's deviatoric and volumetric energy
material::ElasticResponse extrapolated_deviatoric(const SingularValues& elastic, double shear_modulus,
                                                  double bulk_modulus);

} // namespace corticle::fem
