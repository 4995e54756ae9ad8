// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/growth.hpp"
#include "corticle/material/material_point.hpp"
#include "corticle/material/size.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace corticle
{

/// Growth that the body as imaged has behind it.
struct PastGrowth
{
    double tangential; ///< g_t at the start [-]
    double radial;     ///< g_r at the start [-]
};

/// What the tissue is at every material point; depends on t only through theta, when the cortex thickens.
/// Arrays that are empty cost nothing: the one value of the options holds everywhere.
struct Tissue
{
    TissueOptions options;
    ReferenceSize size;                ///< s, by which the cortex thins; without a law it does not
    std::vector<double> volume;        ///< reference volume [mm³]
    std::vector<double> depth;         ///< y, reference distance to the surface [mm]
    std::vector<Vec3> normal;          ///< n, unit, reference
    std::vector<double> mapped_rate;   ///< m as maps give it [-]
    std::vector<double> regional_rate; ///< m, the imperfection included [-]
    std::vector<double> growth_onset;  ///< [t], or empty
    std::vector<double> growth_rate;   ///< [1/t], or empty
    std::vector<double> thickness;     ///< H_i of the closest surface point [mm], or empty
    std::vector<double> theta;         ///< cortex share at the current t [-]
    std::vector<double> theta_rate;    ///< dtheta/dt of a smooth layer that moves, or empty
    std::vector<PastGrowth> past;      ///< or empty: none
    bool theta_is_fixed = true;

    /// H_i + beta t of particle i [mm]: divided by s(t), the thickness in the reference state.
    double thickness_at(std::size_t i, double t) const
    {
        return (thickness.empty() ? options.thickness_mm : thickness[i]) + options.thickness_rate_mm * t;
    }

    /// theta(y, H(t)), H(t) = (H_i + beta t) / s(t), with s the scale of the reference state (thesis eqs. 11 and 14;
    /// s = 1 without a length law), and its rate where H moves a smooth layer.
    void set_layer(double t);

    /// Makes the body as it is the stress-free one at t: growth is then relative to the growth at t, G(t') G(t)^-1, so
    /// that a body imaged at t > 0 starts at rest. Call after all arrays and theta are set.
    void start_growth(double t);

    /// Whether growth is g = 1 + alpha_t theta m t in the reference planes and nothing else: what point() and
    /// growth_normal() then give needs no more than material_point and `normal`.
    bool grows_plainly() const;

    /// Moduli and growth of particle i at t.
    MaterialPoint point(std::size_t i, double t) const
    {
        const GrowthCourse course{options.growth_law, growth_onset.empty() ? options.growth_onset : growth_onset[i],
                                  growth_rate.empty() ? options.growth_rate : growth_rate[i]};
        MaterialPoint point = material_point(options, theta[i], regional_rate[i], course.value(t));
        const double slope = course.slope(t);
        point.growth_rate *= slope;
        point.radial_growth_rate *= slope;
        if (!theta_rate.empty())
        {
            const double per_theta = theta_rate[i] * regional_rate[i] * course.value(t);
            point.growth_rate += per_theta * (options.alpha_t - options.alpha_white);
            point.radial_growth_rate += per_theta * (options.alpha_r - options.alpha_white);
            point.shear_rate = theta_rate[i] * (options.mu_cortex - options.mu_white);
            point.bulk_rate = options.bulk == BulkRule::per_tissue ? options.bulk_modulus * point.shear_rate : 0.0;
        }
        if (!past.empty())
        {
            point.growth /= past[i].tangential;
            point.growth_rate /= past[i].tangential;
            point.radial_growth /= past[i].radial;
            point.radial_growth_rate /= past[i].radial;
        }
        return point;
    }

    /// The unit normal that growth of particle i is tangential to, in the reference frame.
    /// @param F  deformation gradient of the particle
    Vec3 growth_normal(std::size_t i, const Mat3& F) const
    {
        return options.normal == NormalFrame::reference ? normal[i] : current_normal(F, normal[i]);
    }
};

/// Binary cortex of an ellipsoid (thesis eq. 24), sum_k ((X_k - c_k) / r_k)² >= lambda, with the volume it has there.
/// @param volume     [mm³], one per particle
/// @param semi_axes  r [mm], those of the shape or those fitted to the particles (see ellipsoid.hpp)
/// @param centre     c [mm]
std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> volume,
                                    const std::array<double, 3>& semi_axes, double lambda, const Vec3& centre = {});

/// Pressure-wave speed of the white matter at density 1: sqrt(K + 4 mu / 3).
double wave_speed(const TissueOptions& options);

} // namespace corticle
