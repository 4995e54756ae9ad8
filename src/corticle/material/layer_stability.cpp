// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/layer_stability.hpp"

#include "corticle/material/tissue.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace corticle::material
{

namespace
{

constexpr double largest_growth = 3.0;
constexpr double growth_step = 0.02;
constexpr double growth_precision = 1e-6;
constexpr double longest_wave = 40.0; ///< in thicknesses
constexpr double shortest_wave = 1.5;
constexpr double wave_ratio = 0.96;
constexpr int layer_steps = 16; ///< of the Runge-Kutta integration through the layer

/// Incremental moduli A_piqj of the layer about its compressed state: x in its plane, z across it.
struct LayerModuli
{
    double thickness; ///< over that before it grew
    double xxxx, zzzz, xxzz, xzxz, zxzx, xzzx;
};

/// Amplitudes of a wave cos(kx), sin(kx): displacements in the plane and across, and tractions on planes z = const.
struct Wave
{
    double u, w, shear, normal;
};

Wave operator+(const Wave& a, const Wave& b)
{
    return {a.u + b.u, a.w + b.w, a.shear + b.shear, a.normal + b.normal};
}

Wave operator*(double f, const Wave& a)
{
    return {f * a.u, f * a.w, f * a.shear, f * a.normal};
}

/// Stretch across a layer that is compressed by 1/g in its plane and free across it (Newton's method).
double free_stretch(double in_plane, double mu, double K)
{
    double s = 1.0;
    for (int round = 0; round < 50; ++round)
    {
        const double J = in_plane * in_plane * s;
        const double r = std::pow(J, -2.0 / 3.0);
        const double squares = 2.0 * in_plane * in_plane + s * s;
        const double force = mu * r * (s * s - squares / 3.0) + K * (J - 1.0) * J; // times s
        const double slope = mu * r * (5.0 / 9.0 * squares - s * s / 3.0) + K * J * J - force;
        s -= s * force / slope;
    }
    return s;
}

/// Derivatives of W in principal stretches l_i: A_iijj = l_i l_j W_ij / J, A_ijij - A_jiji = (l_i W_i - l_j W_j) / J,
/// A_ijji = A_ijij - l_i W_i / J (Ogden 1984).
LayerModuli layer_moduli(double growth, double mu, double K)
{
    const double a = 1.0 / growth;
    const double s = free_stretch(a, mu, K);
    const double J = a * a * s;
    const double scaled = mu * std::pow(J, -2.0 / 3.0);
    const double squares = 2.0 * a * a + s * s;
    const auto own = [&](double l) { return (scaled * (5.0 / 9.0 * squares - l * l / 3.0) + K * J * J) / J; };
    LayerModuli moduli{};
    moduli.thickness = s;
    moduli.xxxx = own(a);
    moduli.zzzz = own(s);
    moduli.xxzz = (scaled * (2.0 / 9.0 * squares - 2.0 / 3.0 * (a * a + s * s)) + K * J * (2.0 * J - 1.0)) / J;
    moduli.xzxz = scaled * a * a / J;
    moduli.zxzx = scaled * s * s / J;
    moduli.xzzx = moduli.xzxz - (scaled * (a * a - squares / 3.0) + K * (J - 1.0) * J) / J;
    return moduli;
}

/// d/dz of a wave of wavenumber k in equilibrium.
Wave slope(const LayerModuli& A, double k, const Wave& wave)
{
    const double du = (wave.shear + A.xzzx * k * wave.w) / A.zxzx;
    const double dw = (wave.normal - A.xxzz * k * wave.u) / A.zzzz;
    return {du, dw, k * (A.xxxx * k * wave.u + A.xxzz * dw), k * (A.xzxz * k * wave.w - A.xzzx * du)};
}

/// The wave at the surface that has these amplitudes at the white matter.
Wave at_surface(const LayerModuli& A, double k, Wave wave)
{
    const double h = A.thickness / layer_steps;
    for (int step = 0; step < layer_steps; ++step)
    {
        const Wave first = slope(A, k, wave);
        const Wave second = slope(A, k, wave + 0.5 * h * first);
        const Wave third = slope(A, k, wave + 0.5 * h * second);
        const Wave fourth = slope(A, k, wave + h * third);
        wave = wave + h / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
    }
    return wave;
}

/// Determinant of the surface tractions of the two waves that decay into the white matter (isotropic half-space, of
/// potentials cos(kx) exp(kz)); 0 where some combination of them leaves the surface free.
/// @param k  wavenumber [1 / thickness]
double surface_determinant(const LayerModuli& A, double k, const MaterialPoint& white)
{
    const double mu = white.shear_modulus;
    const double K = white.bulk_modulus;
    const double nu = (3.0 * K - 2.0 * mu) / (2.0 * (3.0 * K + mu));
    const Wave first = at_surface(A, k, {-1.0, 1.0, -2.0 * mu * k, 2.0 * mu * k});
    const Wave second = at_surface(A, k, {0.0, 3.0 - 4.0 * nu, -mu * k * (2.0 - 4.0 * nu), 4.0 * mu * k * (1.0 - nu)});
    return first.shear * second.normal - first.normal * second.shear;
}

/// The wavelength that is unstable at a growth; 0: none. @param wavelength  in thicknesses
double unstable_wavelength(double growth, const MaterialPoint& cortex, const MaterialPoint& white)
{
    const LayerModuli flat = layer_moduli(1.0, cortex.shear_modulus, cortex.bulk_modulus);
    const LayerModuli grown = layer_moduli(growth, cortex.shear_modulus, cortex.bulk_modulus);
    for (double wavelength = longest_wave; wavelength > shortest_wave; wavelength *= wave_ratio)
    {
        const double k = 2.0 * std::numbers::pi / wavelength;
        if (surface_determinant(flat, k, white) * surface_determinant(grown, k, white) < 0.0)
        {
            return wavelength;
        }
    }
    return 0.0;
}

} // namespace

CriticalLayer critical_layer(const TissueOptions& options)
{
    const MaterialPoint cortex = material_point(options, 1.0, 1.0, 0.0);
    const MaterialPoint white = material_point(options, 0.0, 1.0, 0.0);
    double stable = 1.0;
    while (unstable_wavelength(stable + growth_step, cortex, white) == 0.0)
    {
        stable += growth_step;
        if (stable > largest_growth)
        {
            return {std::numeric_limits<double>::infinity(), 0.0};
        }
    }
    double unstable = stable + growth_step;
    while (unstable - stable > growth_precision)
    {
        const double middle = 0.5 * (stable + unstable);
        (unstable_wavelength(middle, cortex, white) == 0.0 ? stable : unstable) = middle;
    }
    return {unstable, unstable_wavelength(unstable, cortex, white)};
}

} // namespace corticle::material
