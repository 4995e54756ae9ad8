// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::material
{

namespace
{

/// What tissues have grown by, in logarithms, against week 23 (docs/theory/growth-law.md).
struct Grown
{
    double week;
    double cortex;        ///< volume of cortex
    double white;         ///< volume of white matter
    double deep;          ///< volume of deep grey matter and ventricles
    double excess;        ///< ln q: of the cortex along the surface
    double radial_excess; ///< ln p: of the white matter across it
    double carried;       ///< part of ln q that a brain of this week carries as stress
};

constexpr std::array knots{
    Grown{20.0, -0.572, -0.504, -0.418, -0.098, -0.060, 0.000}, Grown{23.0, 0.000, 0.000, 0.000, 0.000, 0.000, 0.000},
    Grown{25.0, 0.359, 0.309, 0.246, 0.065, 0.040, 0.050},      Grown{27.0, 0.677, 0.571, 0.436, 0.120, 0.067, 0.100},
    Grown{29.0, 0.958, 0.795, 0.583, 0.172, 0.087, 0.105},      Grown{31.0, 1.185, 0.991, 0.704, 0.195, 0.100, 0.090},
    Grown{34.0, 1.480, 1.253, 0.864, 0.205, 0.120, 0.065},      Grown{36.0, 1.692, 1.445, 0.979, 0.220, 0.140, 0.055},
    Grown{38.0, 1.770, 1.573, 1.116, 0.227, 0.200, 0.045},      Grown{40.0, 1.848, 1.706, 1.270, 0.235, 0.260, 0.040},
};

/// What the excess does to volumes at K / mu = 10, over ln q: it compresses the cortex and stretches the white matter.
/// Growth takes both back.
constexpr double cortex_compression = 0.35;
constexpr double white_stretch = 0.1;

/// In which the excess that a brain as imaged carries as stress comes back.
constexpr double weeks_to_come_back = 4.0;

/// Linear between knots.
Grown grown_at(double week)
{
    const auto* const after = std::ranges::upper_bound(knots, week, {}, &Grown::week);
    const auto* const high = std::clamp(after, knots.begin() + 1, knots.end() - 1);
    const auto* const low = high - 1;
    const double part = (week - low->week) / (high->week - low->week);
    const auto between = [&](double Grown::*member) { return (1.0 - part) * low->*member + part * high->*member; };
    return {week,
            between(&Grown::cortex),
            between(&Grown::white),
            between(&Grown::deep),
            between(&Grown::excess),
            between(&Grown::radial_excess),
            between(&Grown::carried)};
}

GrowthRow row_of(const Grown& grown, TissueKind tissue)
{
    switch (tissue)
    {
    case TissueKind::cortex:
    {
        const double length = (grown.cortex + cortex_compression * grown.excess) / 3.0;
        return {grown.week, tissue, std::exp(length + grown.excess), std::exp(length - 2.0 * grown.excess)};
    }
    case TissueKind::white:
    {
        const double length = (grown.white - white_stretch * grown.excess) / 3.0;
        return {grown.week, tissue, std::exp(length - grown.radial_excess),
                std::exp(length + 2.0 * grown.radial_excess)};
    }
    default:
        return {grown.week, tissue, std::exp(grown.deep / 3.0), std::exp(grown.deep / 3.0)};
    }
}

} // namespace

std::vector<GrowthRow> fetal_growth(double start_week)
{
    const double carried = grown_at(start_week).carried;
    std::vector<GrowthRow> rows;
    for (double week = knots.front().week; week <= knots.back().week; week += 0.5)
    {
        Grown grown = grown_at(week);
        grown.excess += carried * (1.0 - std::exp(-std::max(0.0, week - start_week) / weeks_to_come_back));
        for (const TissueKind tissue : {TissueKind::cortex, TissueKind::white, TissueKind::deep, TissueKind::ventricle})
        {
            rows.push_back(row_of(grown, tissue));
        }
    }
    return rows;
}

} // namespace corticle::material
