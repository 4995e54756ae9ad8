// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/run_comparison.hpp"

#include "corticle/view/run_pictures.hpp"
#include "corticle/view/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::study
{

namespace
{

constexpr const char* measures_plot = "measures.png";

/// A panel of a measure against t, each run at its own output times; no curves where neither has it.
view::Panel measure_panel(const RunComparison& comparison, std::string_view key)
{
    view::Panel panel{"growth time t", {}, {}};
    for (std::size_t run = 0; run < 2; ++run)
    {
        const formats::NumberTable& table = comparison.runs[run].measures;
        const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                         [&](const formats::NumberColumn& c) { return measure_key(c) == key; });
        if (column != table.columns.end())
        {
            panel.y_label = view::titled(key, column->unit);
            panel.curves.push_back({comparison.names[run], table.find("t")->values, column->values});
        }
    }
    return panel;
}

template <class Value>
view::Curve frame_curve(const RunComparison& comparison, std::string label, Value&& value)
{
    view::Curve curve{std::move(label), {}, {}};
    for (const FramePair& pair : comparison.frames)
    {
        curve.x.push_back(pair.files[0].t);
        curve.y.push_back(value(pair));
    }
    return curve;
}

std::vector<view::Panel> panels_of(const RunComparison& comparison)
{
    std::vector<view::Panel> panels;
    for (const char* key : {"area_ratio", "volume_ratio", "gi_hull", "gi_sphere", "J_mean", "energy_elastic"})
    {
        panels.push_back(measure_panel(comparison, key));
    }
    const auto curve = [&](std::string label, auto value) { return frame_curve(comparison, std::move(label), value); };
    const auto of_J = [&](std::string label, double metrics::FieldDifference::*value)
    { return curve(std::move(label), [value](const FramePair& pair) { return pair.J.*value; }); };
    const auto of_surface = [&](std::string label, double metrics::SurfaceDistance::*value)
    { return curve(std::move(label), [value](const FramePair& pair) { return pair.surface.*value; }); };
    view::Panel J{"growth time t", "difference of J", {of_J("mean (eq. 27)", &metrics::FieldDifference::mean)}};
    if (std::any_of(comparison.frames.begin(), comparison.frames.end(),
                    [](const FramePair& pair) { return pair.J.is_interpolated; }))
    {
        J.curves.push_back(of_J("error of interpolation", &metrics::FieldDifference::interpolation_error));
    }
    panels.push_back(std::move(J));
    panels.push_back({"growth time t",
                      "distance of the surfaces [mm]",
                      {of_surface("mean", &metrics::SurfaceDistance::mean),
                       of_surface("95 %", &metrics::SurfaceDistance::percentile_95),
                       of_surface("Hausdorff", &metrics::SurfaceDistance::hausdorff)}});
    panels.push_back(measure_panel(comparison, "overlap_area_share"));
    std::erase_if(panels, [](const view::Panel& panel) { return panel.curves.empty(); });
    return panels;
}

std::vector<double> together(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> both = a;
    both.insert(both.end(), b.begin(), b.end());
    return both;
}

/// Names of the pictures of one time: surface and cut.
std::array<std::string, 2> picture_files(const FramePair& pair)
{
    const std::string name = pair.files[0].name();
    return {fmt::format("surface_J_{}.png", name), fmt::format("cut_J_{}.png", name)};
}

/// Surface and cut by J of one time.
void draw_frame(const std::filesystem::path& folder, const RunComparison& comparison, const FramePair& pair)
{
    const std::array frames{record::read_frame(pair.files[0]), record::read_frame(pair.files[1])};
    const std::array J{volume_ratios(frames[0]), volume_ratios(frames[1])};
    const std::array<std::string, 2> files = picture_files(pair);
    std::array<std::string, 2> captions;
    std::array<view::SurfaceInput, 2> surfaces;
    for (std::size_t run = 0; run < 2; ++run)
    {
        captions[run] = fmt::format("{}, t = {:.3g}", comparison.names[run], frames[run].t);
        surfaces[run] = {captions[run], frames[run].surface, frames[run].triangles, frames[run].surface_J};
    }
    view::render_surface_pair(folder / files[0], surfaces,
                              view::scalar_scale("J", together(frames[0].surface_J, frames[1].surface_J)),
                              "Surfaces by volume ratio J");
    std::array cuts{view::middle_cut(frames[0], J[0]), view::middle_cut(frames[1], J[1])};
    const double middle = 0.5 * (cuts[0].coordinate + cuts[1].coordinate);
    cuts[0].coordinate = middle; // the same plane through both
    cuts[1].coordinate = middle;
    view::render_cut_pair(folder / files[1], cuts, captions, view::scalar_scale("J", together(J[0], J[1])),
                          "Cuts by volume ratio J");
}

} // namespace

std::vector<std::string> comparison_pictures(const RunComparison& comparison)
{
    std::vector<std::string> files{measures_plot};
    for (const std::size_t k : comparison.pictured)
    {
        const auto pictures = picture_files(comparison.frames[k]);
        files.insert(files.end(), pictures.begin(), pictures.end());
    }
    return files;
}

void draw_comparison(const std::filesystem::path& folder, const RunComparison& comparison)
{
    view::render_plot(folder / measures_plot, panels_of(comparison), "Measures against growth time");
    for (const std::size_t k : comparison.pictured)
    {
        draw_frame(folder, comparison, comparison.frames[k]);
    }
}

} // namespace corticle::study
