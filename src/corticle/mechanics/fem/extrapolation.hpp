// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/dual.hpp"
#include "corticle/material/wide_remodelling.hpp"

#include <algorithm>
#include <optional>

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

/// Deviatoric part of a law where F_e is a diagonal matrix of stretches.
template <RealLike Real, material::Material<Real> Law>
material::DeviatoricResponse<Real> respond_to_stretches(const Law& law, double shear_modulus,
                                                        const BasicVec3<Real>& stretch)
{
    BasicMat3<Real> F_e;
    BasicMat3<Real> cofactor_e;
    for (int i = 0; i < 3; ++i)
    {
        F_e(i, i) = stretch[i];
        cofactor_e(i, i) = stretch[(i + 1) % 3] * stretch[(i + 2) % 3];
    }
    return law.respond_to_shape(Real(shear_modulus), F_e, cofactor_e, stretch[0] * cofactor_e(0, 0));
}

/// Deviatoric part W of a law, continued below a principal stretch of 0.1, so that flat and inverted elements keep a
/// finite energy and a force that opens them (Tallinen et al. 2016, in their published code): with
/// c_i = max(stretch_i, 0.1) and d_i = stretch_i - c_i, W = W(c) + sum_i W_i(c) d_i + K/2 sum_i d_i².
/// @return the parts of the energy with mu and with K, as if they were a law's deviatoric and volumetric energy
template <material::Material Law>
material::ElasticResponse extrapolated_deviatoric(const Law& law, const SingularValues& elastic, double shear_modulus,
                                                  double bulk_modulus)
{
    Vec3 c;
    Vec3 d;
    for (int i = 0; i < 3; ++i)
    {
        c[i] = std::max(elastic.stretch[i], extrapolated_stretch);
        d[i] = elastic.stretch[i] - c[i];
    }
    const material::DeviatoricResponse<double> at_c = respond_to_stretches(law, shear_modulus, c);
    material::ElasticResponse result;
    result.deviatoric_energy = at_c.energy;
    Vec3 slope; // dW / dstretch
    for (int i = 0; i < 3; ++i)
    {
        result.deviatoric_energy += at_c.stress(i, i) * d[i];
        result.volumetric_energy += 0.5 * bulk_modulus * d[i] * d[i];
        slope[i] = at_c.stress(i, i) + bulk_modulus * d[i];
        if (d[i] == 0.0) // W_j(c) moves with the stretches that are not held at 0.1
        {
            BasicVec3<Dual> moved{c.x, c.y, c.z};
            moved[i].slope = 1.0;
            const BasicMat3<Dual> stress = respond_to_stretches(law, shear_modulus, moved).stress;
            slope[i] += d.x * stress(0, 0).slope + d.y * stress(1, 1).slope + d.z * stress(2, 2).slope;
        }
    }
    Mat3 turned = elastic.U;
    for (int i = 0; i < 3; ++i)
    {
        turned.column[i] *= slope[i];
    }
    result.stress = turned * transpose(elastic.V);
    return result;
}

/// The deviatoric part of a law where it is extrapolated; nothing where it is not.
template <material::Material Law>
std::optional<material::ElasticResponse> extrapolated_where_flat(const Law& law, const Mat3& F_e, double shear_modulus,
                                                                 double bulk_modulus)
{
    const SingularValues elastic = singular_values(F_e);
    if (!(elastic.stretch.z < extrapolated_stretch))
    {
        return std::nullopt;
    }
    return extrapolated_deviatoric(law, elastic, shear_modulus, bulk_modulus);
}

/// The matrix is extrapolated at what it sees; fibres need not be.
inline std::optional<material::ElasticResponse> extrapolated_where_flat(const material::BasicRemodelled<double>& law,
                                                                        const Mat3& F_e, double shear_modulus,
                                                                        double bulk_modulus)
{
    std::optional<material::ElasticResponse> all =
        extrapolated_where_flat(law.matrix, F_e * law.branch, shear_modulus * law.branch_size, bulk_modulus);
    if (all)
    {
        all->stress = all->stress * transpose(law.branch);
        all->deviatoric_energy += law.stored_by_flow(shear_modulus);
        if (law.has_fibres)
        {
            const auto fibres = law.respond_of_fibres(shear_modulus, F_e);
            all->deviatoric_energy += fibres.energy;
            all->stress += fibres.stress;
        }
    }
    return all;
}

/// The law in one lane of eight.
template <class Law>
const Law& law_in_lane(const Law& law, int /*lane*/)
{
    return law;
}
inline material::BasicRemodelled<double> law_in_lane(const material::WideRemodelled& law, int lane)
{
    const auto number = [&](const WideLanes& values) { return values[lane]; };
    const auto vector = [&](const WideVec3& v) { return Vec3{number(v.x), number(v.y), number(v.z)}; };
    return {law.matrix,
            law.relaxes,
            law.has_fibres,
            {{vector(law.branch.column[0]), vector(law.branch.column[1]), vector(law.branch.column[2])}},
            number(law.branch_size),
            {vector(law.fibre.direction), number(law.fibre.share)},
            number(law.fibre_length),
            law.fibre_stiffness,
            law.fibre_tension,
            law.barrier_J};
}

} // namespace corticle::fem
