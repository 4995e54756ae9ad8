// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/material/layer.hpp"

namespace corticle::material
{

bool layer_moves(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size)
{
    return fields.given_theta.empty() && (options.thickness_rate_mm != 0.0 || size.law != LengthLaw::none);
}

void set_layer(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t,
               TissueState& state)
{
    const double scale = size.scale(t);
    const double scale_rate = size.scale_rate(t);
    const bool moves = options.layer == Layer::smooth && (options.thickness_rate_mm != 0.0 || scale_rate != 0.0);
    state.theta.resize(fields.depth.size());
    state.theta_rate.resize(moves ? fields.depth.size() : 0);
    parallel_for(std::ssize(fields.depth),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     const double depth = fields.depth[k];
                     const double H = thickness_at(fields, options, k, t) / scale;
                     double& theta = state.theta[k];
                     theta = options.layer == Layer::smooth ? smooth_layer(depth, H) : H - depth;
                     if (moves)
                     {
                         const double H_rate = (options.thickness_rate_mm - H * scale_rate) / scale;
                         state.theta_rate[k] = theta * (1.0 - theta) * 10.0 * depth / (H * H) * H_rate;
                     }
                 });
    if (options.layer == Layer::binary)
    {
        state.theta = sharp_layer(state.theta, fields.volume, volume_inside(state.theta, fields.volume));
    }
}

TissueState start_tissue(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t)
{
    TissueState state;
    if (fields.given_theta.empty())
    {
        set_layer(fields, options, size, t, state);
    }
    else
    {
        state.theta = fields.given_theta;
    }
    const Tissue tissue{options, fields, state};
    std::vector<PastGrowth> grown(state.theta.size());
    bool any = false;
    for (std::size_t i = 0; i < grown.size(); ++i)
    {
        const MaterialPoint now = tissue.point(i, t);
        grown[i] = {now.growth, now.radial_growth};
        any = any || now.growth != 1.0 || now.radial_growth != 1.0;
    }
    if (any)
    {
        state.past = std::move(grown);
    }
    return state;
}

bool Tissue::grows_plainly() const
{
    return options.alpha_r == 0.0 && options.alpha_white == 0.0 && options.growth_law == GrowthLaw::linear &&
           options.growth_onset == 0.0 && options.growth_rate == 1.0 && options.normal == NormalFrame::reference &&
           fields.growth_onset.empty() && fields.growth_rate.empty() && state.theta_rate.empty() && state.past.empty();
}

double wave_speed(const TissueOptions& options)
{
    return std::sqrt(longitudinal_modulus(material_point(options, 0.0, 1.0, 0.0)));
}

} // namespace corticle::material
