// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/tissue/tissue.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/tissue/layer.hpp"

namespace corticle
{

void Tissue::set_layer(double t)
{
    const double thickness = options.thickness_mm + options.thickness_rate_mm * t;
    const bool smooth = options.layer == Layer::smooth;
    theta.resize(depth.size());
    parallel_for(std::ssize(depth),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     theta[k] =
                         smooth ? smooth_layer(depth[k], thickness) : binary_layer(thickness - depth[k], cell_width[k]);
                 });
}

std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> cell_width,
                                    const std::array<double, 3>& semi_axes, double lambda)
{
    std::vector<double> theta;
    theta.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        const Vec3 X = positions[i];
        const Vec3 q{X.x / semi_axes[0], X.y / semi_axes[1], X.z / semi_axes[2]};
        const Vec3 slope{q.x / semi_axes[0], q.y / semi_axes[1], q.z / semi_axes[2]}; // gradient of |q|²/2
        const double radius = norm(q);
        // To first order the distance to the level |q| = sqrt(lambda) is the difference of levels over |grad |q||.
        const double distance = radius > 0.0 ? (radius - std::sqrt(lambda)) * radius / norm(slope) : -cell_width[i];
        theta.push_back(binary_layer(distance, cell_width[i]));
    }
    return theta;
}

double wave_speed(const TissueOptions& options)
{
    const MaterialPoint white = material_point(options, 0.0, 1.0, 0.0);
    return std::sqrt(white.bulk_modulus + 4.0 / 3.0 * white.shear_modulus);
}

} // namespace corticle
