// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue.hpp"

#include "corticle/material/layer.hpp"

namespace corticle::material
{

bool layer_moves(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size)
{
    return fields.given_theta.empty() && (options.thickness_rate_mm != 0.0 || size.law != LengthLaw::none);
}

void set_layer(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t,
               const Share& share, TissueState& state)
{
    const double scale = size.scale(t);
    const double scale_rate = size.scale_rate(t);
    const bool moves = options.layer == Layer::smooth && (options.thickness_rate_mm != 0.0 || scale_rate != 0.0);
    state.theta.resize(fields.depth.size());
    state.theta_rate.resize(moves ? fields.depth.size() : 0);
    const bool is_smooth = options.layer == Layer::smooth;
    (is_smooth ? share : Share(std::ssize(fields.depth)))
        .each(
            [&](std::int64_t i)
            {
                const auto k = static_cast<std::size_t>(i);
                const double depth = fields.depth[k];
                const double H = thickness_at(fields, options, k, t) / scale;
                double& theta = state.theta[k];
                theta = is_smooth ? smooth_layer(depth, H) : H - depth;
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

PerTissue<double> tissue_volumes(const TissueFields& fields, std::span<const double> theta)
{
    PerTissue<double> volumes{};
    for (std::size_t i = 0; i < fields.volume.size(); ++i)
    {
        const TissueKind kind = fields.kind.empty() ? TissueKind::white : fields.kind[i];
        volumes[static_cast<std::size_t>(TissueKind::cortex)] += theta[i] * fields.volume[i];
        volumes[static_cast<std::size_t>(kind)] += (1.0 - theta[i]) * fields.volume[i];
    }
    return volumes;
}

Moduli moduli_of(const TissueOptions& options, TissueKind kind)
{
    const PerTissue<double> shear{options.mu_cortex, options.mu_white, options.mu_deep, options.mu_ventricle,
                                  options.mu_still};
    const auto k = static_cast<std::size_t>(kind);
    if (options.bulk_ratio[k])
    {
        return {shear[k], *options.bulk_ratio[k] * shear[k]};
    }
    // The fluid in ventricles yields to shear, not to pressure: it is as hard to compress as what surrounds it.
    const double carrier = kind == TissueKind::ventricle ? options.mu_white : shear[k];
    return {shear[k], options.bulk == BulkRule::per_tissue ? options.bulk_modulus * carrier : options.bulk_modulus};
}

namespace
{

/// Growth of a tissue by the keys.
TissueGrowthAt growth_by_keys(const TissueOptions& options, const GrowthCourse& course, TissueKind kind, double t)
{
    const bool is_cortex = kind == TissueKind::cortex;
    const double still = kind == TissueKind::still ? 0.0 : 1.0;
    const double tangential = still * (is_cortex ? options.alpha_t : options.alpha_white);
    const double radial = still * (is_cortex ? options.alpha_r : options.alpha_white);
    const double f = course.value(t);
    const double slope = course.slope(t);
    return {1.0 + tangential * f, 1.0 + radial * f, tangential * slope, radial * slope};
}

} // namespace

MaterialPoint Tissue::labelled_point(std::size_t i, double t) const
{
    const TissueKind kind = fields.kind[i];
    const GrowthCourse course = course_of(i);
    const auto growth_of = [&](TissueKind of)
    { return fields.growth ? fields.growth->at(of, t) : growth_by_keys(options, course, of, t); };
    const TissueGrowthAt cortex = growth_of(TissueKind::cortex);
    const TissueGrowthAt other = growth_of(kind);
    const Moduli cortex_moduli = moduli_of(options, TissueKind::cortex);
    const Moduli other_moduli = moduli_of(options, kind);
    const double theta = state.theta[i];
    const auto [m, m_rate] = regional_rate(i, t);
    const auto mixed = [&](double a, double b) { return theta * a + (1.0 - theta) * b; };
    MaterialPoint point{1.0 + m * (mixed(cortex.tangential, other.tangential) - 1.0),
                        1.0 + m * (mixed(cortex.radial, other.radial) - 1.0),
                        m * mixed(cortex.tangential_rate, other.tangential_rate),
                        m * mixed(cortex.radial_rate, other.radial_rate),
                        mixed(cortex_moduli.shear, other_moduli.shear),
                        mixed(cortex_moduli.bulk, other_moduli.bulk)};
    point.growth_rate += m_rate * (mixed(cortex.tangential, other.tangential) - 1.0);
    point.radial_growth_rate += m_rate * (mixed(cortex.radial, other.radial) - 1.0);
    if (!state.theta_rate.empty())
    {
        const double rate = state.theta_rate[i];
        point.growth_rate += m * rate * (cortex.tangential - other.tangential);
        point.radial_growth_rate += m * rate * (cortex.radial - other.radial);
        point.shear_rate = rate * (cortex_moduli.shear - other_moduli.shear);
        point.bulk_rate = rate * (cortex_moduli.bulk - other_moduli.bulk);
    }
    return point;
}

bool Tissue::has_plain_points() const
{
    return !is_by_tissue() && options.alpha_r == 0.0 && options.alpha_white == 0.0 &&
           options.growth_law == GrowthLaw::linear && options.growth_onset == 0.0 && options.growth_rate == 1.0 &&
           options.normal == NormalFrame::reference && fields.growth_onset.empty() && fields.growth_rate.empty() &&
           fields.growth_maps.times.empty() && state.theta_rate.empty() && state.past.empty() && state.by_law.empty();
}

double wave_speed(const TissueOptions& options)
{
    MaterialPoint white = material_point(options, 0.0, 1.0, 0.0);
    white.bulk_modulus = moduli_of(options, TissueKind::white).bulk;
    return std::sqrt(longitudinal_modulus(white));
}

} // namespace corticle::material
