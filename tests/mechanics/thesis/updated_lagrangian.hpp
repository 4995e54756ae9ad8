// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/neighbors.hpp"

#include <numbers>

// The updated-Lagrangian SPH of thesis section 2.1.2 for an elastic solid in the plane: density by eq. 5, acceleration
// by eq. 6, viscosity by eq. 7, gradients by eq. 2, and what the thesis leaves open as Gray, Monaghan & Swift (2001)
// have it: p = c² (rho - rho_0) and the Jaumann rate of the deviatoric stress. A reference to compare the printed pair
// equations with; the thesis goes on with the total-Lagrangian ones because of the tensile instability of these.

namespace corticle::updated_lagrangian
{

/// How the pairs enter eq. 6.
enum class PairForm
{
    printed,  ///< p_i/rho_i² - p_j/rho_j² + S_j/rho_j² - S_i/rho_i² + Pi_ij
    symmetric ///< -(p_i/rho_i² + p_j/rho_j²) + S_i/rho_i² + S_j/rho_j² - Pi_ij
};

struct Material
{
    PairForm form = PairForm::symmetric;
    double density = 1.0; ///< rho_0
    double sound_speed = 1.0;
    double shear_modulus = 0.5;
    double alpha = 0.04; ///< of the viscosity
    double beta = 0.08;
    double support = 0.26; ///< of the Wendland C2 kernel
};

struct State
{
    std::vector<Vec3> x; ///< in the plane z = 0
    std::vector<Vec3> v;
    std::vector<double> density;
    std::vector<Mat3> S; ///< deviatoric stress
};

struct Rates
{
    std::vector<Vec3> v;
    std::vector<double> density;
    std::vector<Mat3> S;
};

/// Gradient of the kernel in the plane at r = x_i - x_j: W = 7 / (pi s²) (1 - q)^4 (1 + 4 q), q = |r| / s < 1.
inline Vec3 kernel_gradient(const Vec3& r, double s)
{
    const double p = 1.0 - norm(r) / s;
    return (-140.0 / (std::numbers::pi * s * s * s * s) * p * p * p) * r;
}

/// Pi_ij of thesis eq. 7; h is the support.
inline double viscosity(const Material& material, const Vec3& x_ij, const Vec3& v_ij, double mean_density)
{
    const double h = material.support;
    const double phi = h * dot(v_ij, x_ij) / (squared_norm(x_ij) + 0.01 * h * h);
    return phi < 0.0 ? (-material.alpha * material.sound_speed * phi + material.beta * phi * phi) / mean_density : 0.0;
}

inline double pressure(const Material& material, double density)
{
    return material.sound_speed * material.sound_speed * (density - material.density);
}

/// The bracket of eq. 6, as a matrix.
inline Mat3 pair_stress(const Material& material, const State& state, std::size_t i, std::size_t j, double Pi)
{
    const auto over_squared_density = [&](std::size_t k)
    {
        return (1.0 / (state.density[k] * state.density[k])) *
               (state.S[k] - pressure(material, state.density[k]) * Mat3::identity());
    };
    return material.form == PairForm::symmetric
               ? over_squared_density(i) + over_squared_density(j) - Pi * Mat3::identity()
               : over_squared_density(j) - over_squared_density(i) + Pi * Mat3::identity();
}

/// Rates of change; every particle has mass `mass`.
inline Rates rates(const Material& material, const State& state, double mass)
{
    const Neighbors pairs = cloud::find_pairs_within(state.x, material.support);
    const std::size_t count = state.x.size();
    Rates out{std::vector<Vec3>(count), std::vector<double>(count), std::vector<Mat3>(count)};
    parallel_for(std::ssize(state.x),
                 [&](std::int64_t signed_i)
                 {
                     const auto i = static_cast<std::size_t>(signed_i);
                     Mat3 velocity_gradient;
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         const auto j = static_cast<std::size_t>(pairs.index[k]);
                         const Vec3 x_ij = state.x[i] - state.x[j];
                         const Vec3 v_ij = state.v[i] - state.v[j];
                         const Vec3 gradient = kernel_gradient(x_ij, material.support);
                         const double Pi = viscosity(material, x_ij, v_ij, 0.5 * (state.density[i] + state.density[j]));
                         out.density[i] += mass * dot(v_ij, gradient);
                         out.v[i] += mass * (pair_stress(material, state, i, j, Pi) * gradient);
                         velocity_gradient += (-mass / state.density[j]) * outer(v_ij, gradient);
                     }
                     const Mat3 strain_rate = 0.5 * (velocity_gradient + transpose(velocity_gradient));
                     const Mat3 spin = 0.5 * (velocity_gradient - transpose(velocity_gradient));
                     const Mat3 deviator = strain_rate - (trace(strain_rate) / 3.0) * Mat3::identity();
                     out.S[i] = 2.0 * material.shear_modulus * deviator + spin * state.S[i] - state.S[i] * spin;
                 });
    return out;
}

/// state + dt times the rates taken elsewhere; positions move with `v`.
inline State moved(const State& state, const Rates& rates, const std::vector<Vec3>& v, double dt)
{
    State to = state;
    for (std::size_t i = 0; i < state.x.size(); ++i)
    {
        to.x[i] += dt * v[i];
        to.v[i] += dt * rates.v[i];
        to.density[i] += dt * rates.density[i];
        to.S[i] += dt * rates.S[i];
    }
    return to;
}

/// One step of the midpoint rule.
inline void step(const Material& material, State& state, double mass, double dt)
{
    const State middle = moved(state, rates(material, state, mass), state.v, 0.5 * dt);
    state = moved(state, rates(material, middle, mass), middle.v, dt);
}

} // namespace corticle::updated_lagrangian
