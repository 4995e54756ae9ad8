// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/sweep/sweep_table.hpp"
#include "corticle/view/pictures.hpp"
#include "corticle/view/run_pictures.hpp"
#include "corticle/view/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace corticle::sweep
{

namespace
{

constexpr const char* surfaces_file = "surfaces.png";
constexpr std::size_t most_curves = 7; // as many colours as a plot has
constexpr std::size_t most_tiles = 60;
constexpr std::size_t most_columns = 6;
constexpr std::size_t short_row = 4; // surfaces of a sweep with one axis

std::string plot_file(const std::string& name)
{
    return "plots/" + name + ".png";
}

/// Where the places of an axis stand in a plot.
struct Scale
{
    std::string label;
    std::vector<double> x;                             ///< of each place
    std::vector<std::pair<double, std::string>> ticks; ///< where the numbers of x do not say it
    bool is_number = true;                             ///< x is the value of a key, or its logarithm
    bool is_log = false;
};

std::optional<double> number_of(const config::Value& value)
{
    const auto* integer = std::get_if<std::int64_t>(&value);
    const auto* real = std::get_if<double>(&value);
    return integer != nullptr ? std::optional(static_cast<double>(*integer))
           : real != nullptr  ? std::optional(*real)
                              : std::nullopt;
}

/// The values of a key, if they are numbers that differ.
std::optional<std::vector<double>> numbers_of(const SweepAxis& axis, std::size_t key)
{
    std::vector<double> numbers;
    for (const std::vector<config::Value>& values : axis.values)
    {
        if (const std::optional<double> number = number_of(values[key]))
        {
            numbers.push_back(*number);
        }
    }
    const bool differ = std::set<double>(numbers.begin(), numbers.end()).size() == axis.size();
    return differ ? std::optional(numbers) : std::nullopt;
}

/// A key of a case in words, with its unit.
std::string axis_label(const std::string& key)
{
    const config::Parameter* const parameter = config::find_parameter(key);
    return parameter == nullptr ? view::label_of(key) : view::titled(parameter->name(), parameter->unit);
}

/// A measure in words, with its unit and the time it is taken at.
std::string measure_label(const SweepMeasure& measure)
{
    const auto columns = metrics::measure_columns();
    const auto column = std::ranges::find(columns, measure.key, &metrics::MeasureColumn::key);
    const std::string label = view::titled(measure.key, column == columns.end() ? "" : column->unit);
    return measure.t ? fmt::format("{} at t = {:.4g}", label, *measure.t) : label;
}

/// The first key whose values are numbers that differ decides; where there is none, or names are given, the names.
Scale scale_of(const SweepAxis& axis)
{
    for (std::size_t k = 0; k < axis.keys.size() && !axis.has_given_names; ++k)
    {
        if (const auto numbers = numbers_of(axis, k))
        {
            Scale scale{axis_label(axis.keys[k]), *numbers, {}, true, axis.is_log};
            for (double& x : scale.x)
            {
                if (axis.is_log)
                {
                    scale.ticks.emplace_back(std::log10(x), fmt::format("{:.4g}", x));
                    x = scale.ticks.back().first;
                }
            }
            return scale;
        }
    }
    Scale scale{axis_label(axis.keys.front()), {}, {}, false, false};
    for (std::size_t i = 0; i < axis.size(); ++i)
    {
        scale.x.push_back(static_cast<double>(i));
        scale.ticks.emplace_back(scale.x.back(), axis.labels[i]);
    }
    return scale;
}

/// The names of the places of a run on all axes but one.
std::string other_places(const SweepTable& table, const SweepRow& row, std::size_t axis)
{
    std::string name;
    for (std::size_t i = 0; i < table.sweep.axes.size(); ++i)
    {
        if (i != axis)
        {
            name += (name.empty() ? "" : " ") + table.sweep.axes[i].names[table.runs[row.run].at[i]];
        }
    }
    return name;
}

/// One curve of points for all of them, where there are more than colours.
void gather_if_many(std::vector<view::Curve>& curves)
{
    if (curves.size() <= most_curves)
    {
        return;
    }
    view::Curve all{"", {}, {}, true};
    for (const view::Curve& curve : curves)
    {
        all.x.insert(all.x.end(), curve.x.begin(), curve.x.end());
        all.y.insert(all.y.end(), curve.y.begin(), curve.y.end());
    }
    curves = {all};
}

bool is_completed(const SweepRow& row)
{
    return row.state.status == "completed";
}

/// A quantity against an axis: a curve for each combination of the other axes, and marks on the runs that failed among
/// others that did not.
template <class Quantity>
view::Panel panel_of(const SweepTable& table, std::size_t axis, const Scale& scale, std::string label,
                     Quantity&& quantity)
{
    const bool is_marked = std::ranges::any_of(table.rows, is_completed);
    std::vector<view::Curve> curves;
    view::Curve failed{"did not complete", {}, {}, true};
    for (const SweepRow& row : table.rows)
    {
        const std::string name = other_places(table, row, axis);
        auto curve = std::ranges::find(curves, name, &view::Curve::label);
        if (curve == curves.end())
        {
            curve = curves.insert(curves.end(), view::Curve{name, {}, {}, false, true});
        }
        for (view::Curve* chosen : {&*curve, is_marked && !is_completed(row) ? &failed : nullptr})
        {
            if (chosen != nullptr && std::isfinite(quantity(row)))
            {
                chosen->x.push_back(scale.x[table.runs[row.run].at[axis]]);
                chosen->y.push_back(quantity(row));
            }
        }
    }
    gather_if_many(curves);
    for (view::Curve& curve : curves)
    {
        curve.is_points = curve.is_points || curve.x.size() == 1;
        curve.label = curve.label.empty() ? "runs" : curve.label;
    }
    if (!failed.x.empty())
    {
        curves.push_back(std::move(failed));
    }
    return {scale.label, std::move(label), std::move(curves), scale.ticks};
}

/// The lines of theory that belong to a measure and an axis.
void add_lines(const SweepTable& table, const SweepAxis& axis, const std::string& measure, const Scale& scale,
               view::Panel& panel)
{
    constexpr int pieces = 32; // a straight line is bent on a logarithmic axis
    const auto [low, high] = std::ranges::minmax(scale.x);
    for (const SweepLine& line : table.sweep.lines)
    {
        const bool is_here = std::ranges::find(axis.keys, line.axis) != axis.keys.end();
        if (line.measure != measure || !is_here || !scale.is_number)
        {
            continue;
        }
        view::Curve curve{line.label, {}, {}};
        for (int i = 0; i <= pieces; ++i)
        {
            curve.x.push_back(low + (high - low) * i / pieces);
            const double value = scale.is_log ? std::pow(10.0, curve.x.back()) : curve.x.back();
            curve.y.push_back(line.intercept + line.slope * value);
        }
        panel.curves.push_back(std::move(curve));
    }
}

std::vector<view::Panel> measure_panels(const SweepTable& table, std::size_t axis, const Scale& scale)
{
    std::vector<view::Panel> panels;
    for (std::size_t i = 0; i < table.sweep.measures.size(); ++i)
    {
        const std::string& text = table.sweep.measures[i].text;
        if (std::ranges::find(table.sweep.plots, text) != table.sweep.plots.end())
        {
            panels.push_back(panel_of(table, axis, scale, measure_label(table.sweep.measures[i]),
                                      [i](const SweepRow& row) { return row.measures[i]; }));
            add_lines(table, table.sweep.axes[axis], text, scale, panels.back());
        }
    }
    return panels;
}

std::vector<view::Panel> time_panels(const SweepTable& table, std::size_t axis, const Scale& scale)
{
    return {panel_of(table, axis, scale, "duration [s]", [](const SweepRow& row) { return row.number("wall_s"); }),
            panel_of(table, axis, scale, "duration of a step [s]", [](const SweepRow& row) { return row.step_s(); }),
            panel_of(table, axis, scale, "growth time reached", [](const SweepRow& row) { return row.number("t"); })};
}

/// The last frame of a run; none where there is no output time, or it cannot be read.
std::optional<record::Frame> last_frame(const SweepTable& table, const SweepRow& row)
{
    try
    {
        return record::read_frame(record::list_frames(table.out / row.folder).back());
    }
    catch (const InputError&)
    {
        return std::nullopt;
    }
}

/// A scale for the surfaces of all runs that completed, or of all runs where none did.
view::ColorScale common_scale(const SweepTable& table, std::span<const SweepRow> rows)
{
    view::ColorScale common{view::titled("J", ""), 1e300, -1e300};
    const bool any = std::ranges::any_of(rows, is_completed);
    for (const SweepRow& row : rows)
    {
        const std::optional<record::Frame> frame = !any || is_completed(row) ? last_frame(table, row) : std::nullopt;
        if (frame)
        {
            const view::ColorScale own = view::scalar_scale("J", frame->surface_J);
            common.low = std::min(common.low, own.low);
            common.high = std::max(common.high, own.high);
        }
    }
    return common;
}

/// Of several axes the last one goes from left to right; a single one is broken into rows.
std::size_t column_count(const SweepTable& table, std::size_t tiles)
{
    if (table.sweep.axes.size() > 1)
    {
        return std::clamp<std::size_t>(table.sweep.axes.back().size(), 1, most_columns);
    }
    const std::size_t rows = (tiles + short_row - 1) / short_row;
    return (tiles + rows - 1) / rows;
}

/// surfaces.png; false where no run has a surface.
bool draw_surfaces(const SweepTable& table)
{
    const std::span<const SweepRow> rows(table.rows.data(), std::min(table.rows.size(), most_tiles));
    const view::ColorScale scale = common_scale(table, rows);
    if (!(scale.low < scale.high))
    {
        return false;
    }
    const auto tile = [&](std::size_t i) -> view::SurfaceTile
    {
        const SweepRow& row = rows[i];
        const std::string& name = table.runs[row.run].name;
        std::optional<record::Frame> frame = last_frame(table, row);
        if (!frame)
        {
            return {name + "\n" + row.state.status, {}, {}, {}};
        }
        return {fmt::format("{}\nt = {:.4g}{}", name, frame->t, is_completed(row) ? "" : ", " + row.state.status),
                std::move(frame->surface), std::move(frame->triangles), std::move(frame->surface_J)};
    };
    view::render_surface_grid(table.out / surfaces_file, rows.size(), column_count(table, rows.size()), tile, scale,
                              table.sweep.title + ": surfaces at the last output time, from above");
    return true;
}

} // namespace

std::vector<std::string> sweep_pictures(const SweepTable& table)
{
    std::vector<std::string> files;
    for (const SweepAxis& axis : table.sweep.axes)
    {
        files.push_back(plot_file(axis.keys.front()));
        files.push_back(plot_file(axis.keys.front() + "_time"));
    }
    files.emplace_back(surfaces_file);
    return files;
}

study::Pictures draw_sweep(const SweepTable& table, record::ResultFolder& folder)
{
    study::Pictures pictures;
    if (!table.sweep.has_pictures || !view::can_render(pictures.reason))
    {
        return pictures;
    }
    folder.claim(sweep_pictures(table));
    const auto draw = [&](const std::string& name, std::span<const view::Panel> panels)
    {
        if (!panels.empty())
        {
            view::render_plot(table.out / plot_file(name), panels, table.sweep.title);
            pictures.files.push_back(plot_file(name));
        }
    };
    for (std::size_t axis = 0; axis < table.sweep.axes.size(); ++axis)
    {
        const std::string& key = table.sweep.axes[axis].keys.front();
        const Scale scale = scale_of(table.sweep.axes[axis]);
        draw(key, measure_panels(table, axis, scale));
        draw(key + "_time", time_panels(table, axis, scale));
    }
    if (draw_surfaces(table))
    {
        pictures.files.emplace_back(surfaces_file);
    }
    return pictures;
}

} // namespace corticle::sweep
