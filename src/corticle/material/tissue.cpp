// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/material/layer.hpp"

#include <numeric>

namespace corticle
{

void Tissue::set_layer(double t)
{
    const double scale = size.scale(t);
    const double scale_rate = size.scale_rate(t);
    const bool moves = options.layer == Layer::smooth && (options.thickness_rate_mm != 0.0 || scale_rate != 0.0);
    theta.resize(depth.size());
    theta_rate.resize(moves ? depth.size() : 0);
    parallel_for(std::ssize(depth),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     const double H = thickness_at(k, t) / scale;
                     theta[k] = options.layer == Layer::smooth ? smooth_layer(depth[k], H) : H - depth[k];
                     if (moves)
                     {
                         const double H_rate = (options.thickness_rate_mm - H * scale_rate) / scale;
                         theta_rate[k] = theta[k] * (1.0 - theta[k]) * 10.0 * depth[k] / (H * H) * H_rate;
                     }
                 });
    if (options.layer == Layer::binary)
    {
        theta = sharp_layer(theta, volume, volume_inside(theta, volume));
    }
}

bool Tissue::grows_plainly() const
{
    return options.alpha_r == 0.0 && options.alpha_white == 0.0 && options.growth_law == GrowthLaw::linear &&
           options.growth_onset == 0.0 && options.growth_rate == 1.0 && options.normal == NormalFrame::reference &&
           growth_onset.empty() && growth_rate.empty() && theta_rate.empty() && past.empty();
}

void Tissue::start_growth(double t)
{
    past.clear();
    std::vector<PastGrowth> grown(theta.size());
    bool any = false;
    for (std::size_t i = 0; i < theta.size(); ++i)
    {
        const MaterialPoint now = point(i, t);
        grown[i] = {now.growth, now.radial_growth};
        any = any || now.growth != 1.0 || now.radial_growth != 1.0;
    }
    if (any)
    {
        past = std::move(grown);
    }
}

std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> volume,
                                    const std::array<double, 3>& semi_axes, double lambda, const Vec3& centre)
{
    std::vector<double> inside;
    inside.reserve(positions.size());
    for (const Vec3& position : positions)
    {
        const Vec3 X = position - centre;
        const Vec3 q{X.x / semi_axes[0], X.y / semi_axes[1], X.z / semi_axes[2]};
        const Vec3 slope{q.x / semi_axes[0], q.y / semi_axes[1], q.z / semi_axes[2]}; // gradient of |q|²/2
        const double radius = norm(q);
        // To first order the distance to the level |q| = sqrt(lambda) is the difference of levels over |grad |q||.
        inside.push_back(radius > 0.0 ? (radius - std::sqrt(lambda)) * radius / norm(slope)
                                      : -std::sqrt(lambda) * semi_axes[0]);
    }
    // The white matter is the ellipsoid shrunk by sqrt(lambda).
    const double total = std::accumulate(volume.begin(), volume.end(), 0.0);
    return sharp_layer(inside, volume, (1.0 - std::pow(lambda, 1.5)) * total);
}

double wave_speed(const TissueOptions& options)
{
    return std::sqrt(longitudinal_modulus(material_point(options, 0.0, 1.0, 0.0)));
}

} // namespace corticle
