// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/fixed_array.hpp"
#include "corticle/base/mat3.hpp"

// What a particle makes of its neighbours: the fit of least squares x_ij = sum_k a_k p_k(X_ij) over them, with weights
// w_ij. F is its gradient, the zero-energy control holds on to what it leaves, and the forces are the derivatives of
// both. See docs/theory/tlsph.md.
//
// Three functions p are the coordinates of X_ij; nine are these and their products xx, xy, xz, yy, yz, zz.

namespace corticle::tlsph
{

inline constexpr int linear_functions = 3;
inline constexpr int quadratic_functions = 9;

template <RealLike Real, int functions>
struct Fit
{
    using Vectors = FixedArray<BasicVec3<Real>, functions>;

    /// (sum_j w_ij p p^T + R)^-1: the upper triangle by rows, symmetric
    FixedArray<Real, functions*(functions + 1) / 2> inverse;
    FixedArray<Real, functions> sums; ///< sum_j w_ij p(X_ij)
    BasicVec3<Real> at;               ///< where the gradient is that of the fit, from the particle [mm]
    Vectors moments;                  ///< sum_j w_ij p_k(X_ij) x_ij
    BasicVec3<Real> weighted_sum;     ///< sum_j w_ij x_ij
    Real squared_lengths;             ///< sum_j w_ij |x_ij|²

    /// Where the inverse holds row k, column l.
    static constexpr int place(int k, int l) { return k <= l ? k * functions - k * (k + 1) / 2 + l : place(l, k); }
    CORTICLE_INLINE Vectors solve(const Vectors& v) const
    {
        Vectors result;
        for (int k = 0; k < functions; ++k)
        {
            result[k] = inverse[place(k, 0)] * v[0];
            for (int l = 1; l < functions; ++l)
            {
                result[k] += inverse[place(k, l)] * v[l];
            }
        }
        return result;
    }
    /// a_k
    CORTICLE_INLINE Vectors coefficients() const { return solve(moments); }
    /// sum_j w_ij |x_ij - sum_k a_k p_k(X_ij)|², and what R adds
    CORTICLE_INLINE Real residual(const Vectors& coefficients) const
    {
        Real result = squared_lengths;
        for (int k = 0; k < functions; ++k)
        {
            result -= dot(moments[k], coefficients[k]);
        }
        return result;
    }
    /// The gradient of the fit: of sum_k a_k p_k(X) by X.
    CORTICLE_INLINE BasicMat3<Real> gradient(const Vectors& a) const
    {
        BasicMat3<Real> F{{a[0], a[1], a[2]}};
        if constexpr (functions == quadratic_functions)
        {
            const auto& [x, y, z, lane] = at;
            constexpr ScalarOf<Real> two(2.0);
            F.column[0] += two * x * a[3] + y * a[4] + z * a[5];
            F.column[1] += x * a[4] + two * y * a[6] + z * a[7];
            F.column[2] += x * a[5] + y * a[7] + two * z * a[8];
        }
        return F;
    }
    /// What a stress does on each coefficient: the derivative of stress : gradient(a) by a_k.
    CORTICLE_INLINE Vectors loads(const BasicMat3<Real>& stress) const
    {
        const auto& [s_x, s_y, s_z] = stress.column;
        if constexpr (functions == quadratic_functions)
        {
            const auto& [x, y, z, lane] = at;
            constexpr ScalarOf<Real> two(2.0);
            return {s_x,
                    s_y,
                    s_z,
                    two * x * s_x,
                    y * s_x + x * s_y,
                    z * s_x + x * s_z,
                    two * y * s_y,
                    z * s_y + y * s_z,
                    two * z * s_z};
        }
        else
        {
            return {s_x, s_y, s_z};
        }
    }
    /// Z_k: pair ij pulls at i with w_ij (sum_k Z_k p_k(X_ij) + zeta x_ij).
    /// @param stress  V_i P_i   @param zeta  zeta_i
    CORTICLE_INLINE Vectors pulls(const BasicMat3<Real>& stress, const Real& zeta) const
    {
        Vectors v = loads(stress);
        for (int k = 0; k < functions; ++k)
        {
            v[k] -= zeta * moments[k];
        }
        return solve(v);
    }
    /// The sum of these pulls over all neighbours.
    CORTICLE_INLINE BasicVec3<Real> own_force(const Vectors& Z, const Real& zeta) const
    {
        BasicVec3<Real> force = zeta * weighted_sum;
        for (int k = 0; k < functions; ++k)
        {
            force += sums[k] * Z[k];
        }
        return force;
    }
};

} // namespace corticle::tlsph
