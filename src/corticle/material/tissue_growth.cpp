// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/tissue_growth.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::material
{

namespace
{

constexpr int intervals = 512; ///< in which g is linear in t: within 1e-5 of the rows

/// Rows of one tissue by week. @throws InputError
std::vector<GrowthRow> rows_of(std::span<const GrowthRow> rows, TissueKind tissue, double start_week, double end_week)
{
    std::vector<GrowthRow> own;
    std::ranges::copy_if(rows, std::back_inserter(own), [&](const GrowthRow& row) { return row.tissue == tissue; });
    std::ranges::sort(own, {}, &GrowthRow::week);
    for (std::size_t k = 0; k < own.size(); ++k)
    {
        if (k > 0 && own[k].week == own[k - 1].week)
        {
            throw InputError(
                fmt::format("growth of {}: got two rows of week {:g}, expected one", name_of(tissue), own[k].week));
        }
        if (!(own[k].tangential > 0.0 && own[k].radial > 0.0 && std::isfinite(own[k].tangential * own[k].radial)))
        {
            throw InputError(fmt::format("growth of {} at week {:g}: got {:g} and {:g}, expected numbers above 0",
                                         name_of(tissue), own[k].week, own[k].tangential, own[k].radial));
        }
    }
    if (!own.empty() && !(own.front().week <= start_week && own.back().week >= end_week))
    {
        throw InputError(fmt::format("growth of {}: got rows of weeks {:g} to {:g}, expected them to cover the run, "
                                     "{:g} to {:g}",
                                     name_of(tissue), own.front().week, own.back().week, start_week, end_week));
    }
    return own;
}

/// Linear in the week.
double value_at(std::span<const GrowthRow> rows, double week, double GrowthRow::*member)
{
    const auto after = std::ranges::upper_bound(rows, week, {}, &GrowthRow::week);
    const auto high = after == rows.end() ? rows.end() - 1 : std::max(after, rows.begin() + 1);
    const auto low = rows.size() == 1 ? high : high - 1;
    const double part = low == high ? 0.0 : (week - low->week) / (high->week - low->week);
    return (1.0 - part) * std::log((*low).*member) + part * std::log((*high).*member);
}

} // namespace

TissueGrowth::TissueGrowth(std::span<const GrowthRow> rows, GestationalClock clock, double start_week, double end_week)
    : start_(growth_time(clock, start_week)), step_((growth_time(clock, end_week) - start_) / intervals)
{
    std::vector<double> weeks;
    for (int k = 0; k <= intervals; ++k)
    {
        weeks.push_back(k == 0 ? start_week : k == intervals ? end_week : gestational_week(clock, start_ + k * step_));
    }
    for (std::size_t kind = 0; kind < tissue_count; ++kind)
    {
        const std::vector<GrowthRow> own = rows_of(rows, static_cast<TissueKind>(kind), start_week, end_week);
        for (std::size_t k = 0; k < weeks.size() && !own.empty(); ++k)
        {
            const auto relative = [&](double GrowthRow::*member)
            { return std::exp(value_at(own, weeks[k], member) - value_at(own, start_week, member)); };
            courses_[kind].tangential.push_back(relative(&GrowthRow::tangential));
            courses_[kind].radial.push_back(relative(&GrowthRow::radial));
        }
    }
}

TissueGrowthAt TissueGrowth::at(TissueKind tissue, double t) const
{
    const Course& course = courses_[static_cast<std::size_t>(tissue)];
    if (course.tangential.empty())
    {
        return {};
    }
    const double place = (t - start_) / step_;
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, intervals - 1.0));
    const double part = place - static_cast<double>(k);
    const auto growth = [&](const std::vector<double>& values, double& rate)
    {
        const double rise = values[k + 1] - values[k];
        rate = rise / step_;
        return values[k] + part * rise;
    };
    TissueGrowthAt now;
    now.tangential = growth(course.tangential, now.tangential_rate);
    now.radial = growth(course.radial, now.radial_rate);
    return now;
}

double TissueGrowth::mean_rate(const PerTissue<double>& volumes, double t) const
{
    double grown = 0.0;
    double rate = 0.0;
    for (std::size_t kind = 0; kind < tissue_count; ++kind)
    {
        const TissueGrowthAt g = at(static_cast<TissueKind>(kind), t);
        const double volume = volumes[kind] * g.tangential * g.tangential * g.radial;
        grown += volume;
        rate += volume * (2.0 * g.tangential_rate / g.tangential + g.radial_rate / g.radial);
    }
    return rate / (3.0 * grown);
}

} // namespace corticle::material
