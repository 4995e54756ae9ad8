// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/response.hpp"

// The law of a material point with a history: a branch of its shear modulus that has flowed, growth by stress, fibres.
// See docs/theory/relaxation.md and docs/theory/fibres.md. Forces hold history constant; it goes on from step to step.

namespace corticle::material
{

/// History of one material point.
template <RealLike Real>
struct BasicPointHistory
{
    BasicMat3<Real> strain; ///< C_v of the branch that flows: symmetric, positive, det C_v = 1 [-]
    Real growth;            ///< theta_s: volume grown by stress over that without it [-]
    Real fibre_length;      ///< l: rest length of the fibres over that at the start [-]
};

/// What all points have in common in a step.
struct RemodellingStep
{
    double elapsed = 0.0;          ///< of the clock; 0: history stays as it is
    double relaxation_share = 0.0; ///< r [-]
    double relaxation = 0.0;       ///< elapsed / tau [-]
    double growth = 0.0;           ///< G_s elapsed [-]
    double growth_ratio = 1.0;     ///< J_0 [-]
    bool shrinks = true;
    bool has_fibres = false;
    double fibre_stiffness = 0.0; ///< k [mu]
    double tension_before = 0.0;  ///< T at the beginning of the step [mu]
    double tension = 0.0;         ///< T at its end [mu]
    double fibre_growth = 0.0;    ///< rate · elapsed [-]
    double fibre_stretch = 1.0;   ///< elastic stretch above which fibres grow [-]
};

/// Fibres at a material point.
template <RealLike Real>
struct BasicFibre
{
    BasicVec3<Real> direction; ///< a, unit, reference
    Real share;                ///< of the tissue that they run through [-]
};

/// The law with a given history: W = mu/2 (J_e^-2/3 tr(F_e A F_e^T) - 3) + K U(J_e) + w_f, where
/// A = (1 - r) I + r C_v^-1 (one Maxwell branch beside a spring), w_f = share mu (k/2 <s/l - 1>² + T (s - 1)) and
/// s = |F_e a|. With A = L L^T the first part is the law of the matrix at F_e L.
template <RealLike Real>
struct BasicRemodelled
{
    NeoHookean matrix;
    bool relaxes;
    bool has_fibres;
    BasicMat3<Real> branch; ///< L
    Real branch_size;       ///< (det L)^2/3, at least 1
    BasicFibre<Real> fibre;
    Real fibre_length;      ///< l
    double fibre_stiffness; ///< k [mu]
    double fibre_tension;   ///< T [mu]
    double barrier_J;       ///< of the matrix

    CORTICLE_INLINE DeviatoricResponse<Real> respond_to_shape(const Real& shear_modulus, const BasicMat3<Real>& F_e,
                                                              const BasicMat3<Real>& cofactor_e, const Real& J_e) const
    {
        DeviatoricResponse<Real> all = relaxes ? branched(shear_modulus, F_e, cofactor_e, J_e)
                                               : matrix.respond_to_shape(shear_modulus, F_e, cofactor_e, J_e);
        if (has_fibres)
        {
            const DeviatoricResponse<Real> fibres = respond_of_fibres(shear_modulus, F_e);
            all.energy += fibres.energy;
            all.stress += fibres.stress;
        }
        return all;
    }

    CORTICLE_INLINE VolumetricResponse<Real> respond_to_volume(const Real& bulk_modulus, const Real& J_e) const
    {
        return matrix.respond_to_volume(bulk_modulus, J_e);
    }

    CORTICLE_INLINE DeviatoricResponse<Real> respond_of_fibres(const Real& shear_modulus,
                                                               const BasicMat3<Real>& F_e) const
    {
        using Scalar = ScalarOf<Real>;
        constexpr Scalar one(1.0);
        const BasicVec3<Real> image = F_e * fibre.direction;
        const Real stretch = square_root<Real>(dot(image, image));
        const Real modulus = fibre.share * shear_modulus;
        const Real strain = larger<Real>(stretch / fibre_length - one, Real{});
        const Real pull = static_cast<Scalar>(fibre_stiffness) * strain;
        const auto tension = static_cast<Scalar>(fibre_tension);
        return {modulus * (Scalar(0.5) * pull * strain + tension * (stretch - one)),
                (modulus * (pull / fibre_length + tension) / stretch) * outer(image, fibre.direction)};
    }

    /// What fibres add to the stiffness of pressure waves at the most [mu_w].
    CORTICLE_INLINE Real added_stiffness(const Real& shear_modulus) const
    {
        using Scalar = ScalarOf<Real>;
        return fibre.share * shear_modulus *
               (static_cast<Scalar>(fibre_stiffness) / (fibre_length * fibre_length) +
                static_cast<Scalar>(fibre_tension));
    }

    /// What the branch stores where the matrix at F_e L stores nothing.
    CORTICLE_INLINE Real stored_by_flow(const Real& shear_modulus) const
    {
        return ScalarOf<Real>(1.5) * shear_modulus * (branch_size - ScalarOf<Real>(1.0));
    }

  private:
    CORTICLE_INLINE DeviatoricResponse<Real> branched(const Real& shear_modulus, const BasicMat3<Real>& F_e,
                                                      const BasicMat3<Real>& cofactor_e, const Real& J_e) const
    {
        const Real size = branch(0, 0) * branch(1, 1) * branch(2, 2);
        const DeviatoricResponse<Real> shape = matrix.respond_to_shape(Real{shear_modulus * branch_size}, F_e * branch,
                                                                       cofactor_e * cofactor(branch), Real{J_e * size});
        return {shape.energy + stored_by_flow(shear_modulus), shape.stress * transpose(branch)};
    }
};
static_assert(Material<BasicRemodelled<double>> && Material<BasicRemodelled<float>, float>);

/// L of a symmetric positive matrix L L^T (Cholesky).
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> lower_root(const BasicMat3<Real>& A)
{
    BasicMat3<Real> L{};
    L(0, 0) = square_root<Real>(A(0, 0));
    L(1, 0) = A(1, 0) / L(0, 0);
    L(2, 0) = A(2, 0) / L(0, 0);
    L(1, 1) = square_root<Real>(A(1, 1) - L(1, 0) * L(1, 0));
    L(2, 1) = (A(2, 1) - L(2, 0) * L(1, 0)) / L(1, 1);
    L(2, 2) = square_root<Real>(A(2, 2) - L(2, 0) * L(2, 0) - L(2, 1) * L(2, 1));
    return L;
}

/// The law with a history. @param tension  T [mu]
template <RealLike Real>
CORTICLE_INLINE BasicRemodelled<Real> remodelled(const RemodellingStep& step, double tension, const NeoHookean& matrix,
                                                 const BasicFibre<Real>& fibre, const BasicPointHistory<Real>& history)
{
    using Scalar = ScalarOf<Real>;
    BasicRemodelled<Real> law{matrix,
                              step.relaxation_share > 0.0,
                              step.has_fibres,
                              BasicMat3<Real>::identity(),
                              broadcast<Real>(1.0),
                              fibre,
                              history.fibre_length,
                              step.fibre_stiffness,
                              tension,
                              matrix.barrier_J};
    if (law.relaxes)
    {
        const auto r = static_cast<Scalar>(step.relaxation_share);
        law.branch =
            lower_root((Scalar(1.0) - r) * BasicMat3<Real>::identity() + r * cofactor(history.strain)); // det C_v = 1
        const Real root = Scalar(1.0) / inverse_cube_root(Real{law.branch(0, 0) * law.branch(1, 1) * law.branch(2, 2)});
        law.branch_size = root * root;
    }
    return law;
}

/// A material point whose volume stress has let grow by a factor, in all directions alike.
template <RealLike Real>
CORTICLE_INLINE BasicMaterialPoint<Real> grown_by_stress(BasicMaterialPoint<Real> point, const Real& volume)
{
    const Real length = ScalarOf<Real>(1.0) / inverse_cube_root(volume);
    point.growth *= length;
    point.radial_growth *= length;
    point.growth_rate *= length;
    point.radial_growth_rate *= length;
    return point;
}

/// x after a step of dx/dt = rate (y / x - threshold), by implicit Euler: stable for any rate.
/// @param step  rate times the length of the step   @param both_ways  whether x may fall too
template <RealLike Real>
CORTICLE_INLINE Real followed(const Real& x, const Real& y, const Real& step, double threshold, bool both_ways)
{
    using Scalar = ScalarOf<Real>;
    const auto limit = static_cast<Scalar>(threshold);
    const Real most = limit * x;
    const Real a = both_ways ? step : Real{y > most ? step : Real{}};
    const Real b = x - limit * a;
    return Scalar(0.5) * (b + square_root<Real>(b * b + Scalar(4.0) * a * y));
}

/// C_v after a step of length tau · relaxation: the closed form of implicit Euler, which keeps det C_v = 1
/// (Shutov, Landgraf & Ihlemann 2013).
template <RealLike Real>
CORTICLE_INLINE BasicMat3<Real> flowed(const BasicMat3<Real>& C_v, const BasicMat3<Real>& F_e, const Real& J_e,
                                       double relaxation)
{
    const Real r = inverse_cube_root(J_e);
    const BasicMat3<Real> sum = C_v + (static_cast<ScalarOf<Real>>(relaxation) * r * r) * (transpose(F_e) * F_e);
    return inverse_cube_root(determinant(sum)) * sum;
}

/// theta_s after a step, with J = det F. @param share  of white matter
template <RealLike Real>
CORTICLE_INLINE Real growth_by_stress(const RemodellingStep& step, const BasicMaterialPoint<Real>& point,
                                      const Real& share, const Real& J, const Real& before)
{
    using Scalar = ScalarOf<Real>;
    constexpr Scalar least(0.1); // elastic volume ratio of what is crushed or inverted
    const Real unstressed = growth_volume(point);
    const Real ratio = larger<Real>(J / unstressed, least * before);
    return followed(before, ratio, static_cast<Scalar>(step.growth) * share, step.growth_ratio, step.shrinks);
}

/// The rest of the history after a step. @param history  as the step found it, with theta_s as it leaves it
/// @param e  the elastic deformation with that growth
template <RealLike Real>
CORTICLE_INLINE BasicPointHistory<Real> advanced(const RemodellingStep& step, const BasicFibre<Real>& fibre,
                                                 const ElasticDeformation<Real>& e, BasicPointHistory<Real> history)
{
    using Scalar = ScalarOf<Real>;
    constexpr Scalar least(0.1); // as above
    if (step.relaxation > 0.0)
    {
        history.strain = flowed(history.strain, e.F_e, larger<Real>(e.J_e, broadcast<Real>(least)), step.relaxation);
    }
    if (step.fibre_growth > 0.0)
    {
        const BasicVec3<Real> image = e.F_e * fibre.direction;
        history.fibre_length = followed(history.fibre_length, square_root<Real>(dot(image, image)),
                                        broadcast<Real>(step.fibre_growth), step.fibre_stretch, false);
    }
    return history;
}

} // namespace corticle::material
