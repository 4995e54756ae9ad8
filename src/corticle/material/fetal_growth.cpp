// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue_growth.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::material
{

namespace
{

constexpr double first_week = 20.0;
constexpr double last_week = 40.0;
constexpr double first_fitted = 23.0;
constexpr double last_fitted = 38.0;

/// ln V = rate (w - 30) + bend (w - 30)² + twist (w - 30)³ up to a constant, fitted to volumes of labelled tissue
/// (docs/theory/growth-law.md); beyond the weeks of the fit V goes on at its rate there.
struct VolumeCourse
{
    double rate;  ///< [1/week]
    double bend;  ///< [1/week²]
    double twist; ///< [1/week³]

    /// Linear growth of tissue that keeps its shape, against week 30.
    double linear(double week) const
    {
        const double fitted = std::clamp(week, first_fitted, last_fitted);
        const double w = fitted - 30.0;
        const double slope = rate + (2.0 * bend + 3.0 * twist * w) * w;
        return std::exp((((twist * w + bend) * w + rate) * w + slope * (week - fitted)) / 3.0);
    }
};

constexpr VolumeCourse cortex_volume{0.12383, -0.003846, 8.77e-5};
constexpr VolumeCourse white_volume{0.09967, -0.002899, 2.000e-4};
constexpr VolumeCourse deep_volume{0.05988, -0.002538, 2.994e-4};

/// ln q, the tangential excess of the cortex: folding is fastest before week 32.
double log_excess(double week)
{
    constexpr double most = 0.165;
    constexpr double weeks = 6.0;
    return most * (1.0 - std::exp(-(week - first_fitted) / weeks));
}

/// What the excess does to volumes at K / mu = 10, over ln q: it compresses the cortex and stretches the white matter.
/// Growth takes both back.
constexpr double cortex_compression = 0.35;
constexpr double white_stretch = 0.1;

} // namespace

std::vector<GrowthRow> fetal_growth()
{
    std::vector<GrowthRow> rows;
    for (double week = first_week; week <= last_week; week += 0.5)
    {
        const double log_q = log_excess(week);
        const double cortex = cortex_volume.linear(week) * std::exp(cortex_compression / 3.0 * log_q);
        const double white = white_volume.linear(week) * std::exp(-white_stretch / 3.0 * log_q);
        rows.push_back({week, TissueKind::cortex, cortex * std::exp(log_q), cortex * std::exp(-2.0 * log_q)});
        const auto isotropic = [&](TissueKind tissue, double growth) {
            rows.push_back({week, tissue, growth, growth});
        };
        isotropic(TissueKind::white, white);
        isotropic(TissueKind::deep, deep_volume.linear(week));
        isotropic(TissueKind::ventricle, deep_volume.linear(week));
    }
    return rows;
}

} // namespace corticle::material
