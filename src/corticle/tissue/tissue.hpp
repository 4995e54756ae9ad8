// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/tissue/growth.hpp"
#include "corticle/tissue/options.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace corticle
{

/// What the tissue is at every material point; depends on t only through theta, when the cortex thickens.
struct Tissue
{
    TissueOptions options;
    std::vector<double> volume;        ///< reference volume [mm³]
    std::vector<double> depth;         ///< y, reference distance to the surface [mm]
    std::vector<Vec3> normal;          ///< n, unit, reference
    std::vector<double> regional_rate; ///< m [-]
    std::vector<double> thickness;     ///< of the cortex at t = 0 [mm]; empty: options.thickness_mm everywhere
    std::vector<double> theta;         ///< cortex share at the current t [-]
    bool theta_is_fixed = true;

    /// theta(y, H(t)), H(t) = H_i + beta t (thesis eqs. 11 and 14).
    void set_layer(double t);
};

/// Moduli and growth of one material point at a time t.
struct MaterialPoint
{
    double growth;        ///< g [-]
    double shear_modulus; ///< [mu_w]
    double bulk_modulus;  ///< [mu_w]
};

/// mu = theta mu_c + (1 - theta) mu_w; K = ratio mu (per tissue) or one constant (uniform).
inline MaterialPoint material_point(const TissueOptions& options, double theta, double regional_rate, double t)
{
    const double mu = theta * options.mu_cortex + (1.0 - theta) * options.mu_white;
    return {growth_ratio(options.alpha_t, theta, regional_rate, t), mu,
            options.bulk == BulkRule::per_tissue ? options.bulk_modulus * mu : options.bulk_modulus};
}

/// Binary cortex of an ellipsoid (thesis eq. 24), sum_k ((X_k - c_k) / r_k)² >= lambda, with the volume it has there.
/// @param volume     [mm³], one per particle
/// @param semi_axes  r [mm], those of the shape or those fitted to the particles (see ellipsoid.hpp)
/// @param centre     c [mm]
std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> volume,
                                    const std::array<double, 3>& semi_axes, double lambda, const Vec3& centre = {});

/// Pressure-wave speed of the white matter at density 1: sqrt(K + 4 mu / 3).
double wave_speed(const TissueOptions& options);

} // namespace corticle
