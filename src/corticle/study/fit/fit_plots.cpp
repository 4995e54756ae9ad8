// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/fit_result.hpp"
#include "corticle/study/fit/svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace corticle::fit
{

namespace
{

using Kind = SvgMarks::Kind;

constexpr const char* observed_colour = "#c0392b";
constexpr const char* best_colour = "#222222";
constexpr const char* band_colour = "#1f5fa8";
constexpr int histogram_bars = 30;
constexpr std::size_t most_drawn = 1500;

std::string label(const FreeParameter& parameter)
{
    return parameter.name() + (parameter.unit.empty() ? "" : " [" + parameter.unit + "]");
}

/// The misfit of each run, and the best so far.
std::string objective_plot(const FitFile& fit, const FitResult& result)
{
    SvgPanel panel{"Misfit of each run", "run", "misfit", true, {}, {}};
    SvgMarks runs{Kind::points, {}, {}, {}, {}, band_colour, 0.7};
    SvgMarks least{Kind::line, {}, {}, {}, {}, best_colour, 1.0};
    double best = INFINITY;
    for (std::size_t i = 0; i < result.evaluations.size(); ++i)
    {
        const double value = misfit(fit, result.evaluations[i]);
        runs.x.push_back(static_cast<double>(i + 1));
        runs.y.push_back(value);
        best = std::isnan(value) ? best : std::min(best, value);
        least.x.push_back(static_cast<double>(i + 1));
        least.y.push_back(best);
    }
    panel.marks = {runs, least};
    return svg_plot({panel}, 1);
}

SvgMarks histogram(const std::vector<double>& values, double low, double high)
{
    SvgMarks bars{Kind::bars, {}, {}, {}, {}, band_colour, 0.6};
    const double step = (high - low) / histogram_bars;
    for (int i = 0; i < histogram_bars; ++i)
    {
        const double from = low + i * step;
        const auto count =
            std::ranges::count_if(values, [&](double value) { return value >= from && value < from + step; });
        bars.x.push_back(from);
        bars.x_high.push_back(from + step);
        bars.y.push_back(static_cast<double>(count) / static_cast<double>(values.size()) / step);
    }
    return bars;
}

/// Values of a parameter in the draws, not more than can be drawn.
std::vector<double> drawn_values(const FitFile& fit, const FitResult& result, std::size_t k, std::size_t most)
{
    const std::vector<Point>& points = result.knowledge->draws.points;
    const std::size_t stride = std::max<std::size_t>(1, points.size() / most);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); i += stride)
    {
        values.push_back(fit.space.parameters[k].value(points[i][k]));
    }
    return values;
}

/// Where the runs were, and what is known of each parameter.
std::string parameters_plot(const FitFile& fit, const FitResult& result)
{
    std::vector<SvgPanel> panels;
    for (std::size_t k = 0; k < fit.space.size(); ++k)
    {
        const FreeParameter& one = fit.space.parameters[k];
        SvgPanel panel{one.name() + ": misfit of runs", label(one), "misfit", true, {}, {}};
        SvgMarks runs{Kind::points, {}, {}, {}, {}, band_colour, 0.6};
        for (const Evaluation& evaluation : result.evaluations)
        {
            runs.x.push_back(evaluation.values[k]);
            runs.y.push_back(misfit(fit, evaluation));
        }
        panel.marks = {runs};
        panels.push_back(panel);
        if (result.knowledge)
        {
            const std::vector<double> values = drawn_values(fit, result, k, result.knowledge->draws.points.size());
            SvgPanel density{one.name() + ": posterior", label(one), "density", false, {}, {}};
            density.marks = {histogram(values, one.low, one.high)};
            panels.push_back(density);
        }
    }
    return svg_plot(panels, 2);
}

/// Draws of each pair of parameters: what trades off against what.
std::string pairs_plot(const FitFile& fit, const FitResult& result)
{
    std::vector<SvgPanel> panels;
    for (std::size_t j = 1; j < fit.space.size(); ++j)
    {
        for (std::size_t i = 0; i < j; ++i)
        {
            const double r = result.knowledge->correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            char text[40];
            std::snprintf(text, sizeof text, "correlation %.2f", r);
            SvgPanel panel{text, label(fit.space.parameters[i]), label(fit.space.parameters[j]), false, {}, {}};
            panel.marks = {{Kind::points,
                            drawn_values(fit, result, i, most_drawn),
                            drawn_values(fit, result, j, most_drawn),
                            {},
                            {},
                            band_colour,
                            0.25}};
            panels.push_back(panel);
        }
    }
    return svg_plot(panels, 3);
}

/// A panel for each measure over its times.
std::string predicted_plot(const FitFile& fit, const FitResult& result)
{
    const std::vector<Quantity> quantities = fit.quantities();
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t q = 0; q < quantities.size(); ++q)
    {
        const Quantity& one = quantities[q];
        groups[(one.file.empty() ? "" : one.file.filename().string() + ": ") + one.measure].push_back(q);
    }
    std::vector<SvgPanel> panels;
    for (auto& [name, members] : groups)
    {
        std::ranges::stable_sort(members, {}, [&](std::size_t q) { return quantities[q].at; });
        const Quantity& first = quantities[members.front()];
        SvgPanel panel{name, first.place == Quantity::Place::week ? "week" : "t", name, false, {}, {}};
        SvgMarks band{Kind::band, {}, {}, {}, {}, band_colour, 0.25};
        SvgMarks bars{Kind::whiskers, {}, {}, {}, {}, band_colour, 0.5};
        SvgMarks best{Kind::points, {}, {}, {}, {}, best_colour, 1.0};
        SvgMarks observed{Kind::whiskers, {}, {}, {}, {}, observed_colour, 1.0};
        for (const std::size_t q : members)
        {
            best.x.push_back(quantities[q].at);
            best.y.push_back(result.evaluations[result.best].predicted[q]);
            if (result.knowledge)
            {
                band.x.push_back(quantities[q].at);
                band.y.push_back(result.knowledge->expected[q].low);
                band.y_high.push_back(result.knowledge->expected[q].high);
            }
            if (quantities[q].value)
            {
                observed.x.push_back(quantities[q].at);
                observed.y.push_back(*quantities[q].value - quantities[q].sd);
                observed.y_high.push_back(*quantities[q].value + quantities[q].sd);
            }
        }
        bars.x = band.x;
        bars.y = band.y;
        bars.y_high = band.y_high;
        panel.marks = {band, bars, observed, best};
        panels.push_back(panel);
    }
    return svg_plot(panels, 3);
}

} // namespace

std::vector<std::pair<std::string, std::string>> fit_plots(const FitFile& fit, const FitResult& result)
{
    std::vector<std::pair<std::string, std::string>> plots{{"plots/objective.svg", objective_plot(fit, result)},
                                                           {"plots/parameters.svg", parameters_plot(fit, result)},
                                                           {"plots/predicted.svg", predicted_plot(fit, result)}};
    if (result.knowledge && fit.space.size() > 1)
    {
        plots.emplace_back("plots/pairs.svg", pairs_plot(fit, result));
    }
    return plots;
}

} // namespace corticle::fit
