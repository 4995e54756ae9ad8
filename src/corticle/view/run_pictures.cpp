// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/run_pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/view/robust_range.hpp"
#include "corticle/view/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::view
{

namespace
{

/// A run folder whose pictures may be drawn anew.
record::ResultFolder claim_pictures(const std::filesystem::path& run, std::span<const record::FrameFiles> frames)
{
    record::ResultFolder folder(run, "run", "");
    std::vector<std::string> files{record::measures_picture};
    for (const record::FrameFiles& frame : frames)
    {
        const std::vector<std::string> more = record::frame_pictures(frame.name());
        files.insert(files.end(), more.begin(), more.end());
    }
    folder.claim(files);
    return folder;
}

} // namespace

ColorScale robust_scale(std::string label, std::span<const double> values, ColorMap map)
{
    const Range range = robust_range(values);
    return {std::move(label), range.low, range.high, map};
}

ColorScale scalar_scale(std::string_view key, std::span<const double> values)
{
    const Scalar scalar = scalar_of(key);
    ColorScale scale = robust_scale(titled(key, scalar.unit), values, scalar.map);
    if (scale.map == ColorMap::regions)
    {
        const Range range = full_range(values);
        return {scale.label, range.low, range.high, scale.map};
    }
    if (scale.map == ColorMap::blue_orange)
    {
        scale.high = std::max(std::abs(scale.high), std::abs(scale.low)); // 0 in the middle
        scale.low = -scale.high;
    }
    return scale;
}

std::string time_text(double t, double week)
{
    return std::isnan(week) ? fmt::format("t = {:.3g}", t) : fmt::format("week {:.4g}", week);
}

CutInput middle_cut(const record::Frame& frame, std::span<const double> scalar)
{
    const auto [back, front] = std::minmax_element(frame.surface.begin(), frame.surface.end(),
                                                   [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    return {.positions = frame.particles,
            .origins = frame.origins,
            .F = *frame.F,
            .theta = frame.theta,
            .scalar = scalar,
            .spacing = frame.spacing,
            .surface_points = frame.surface,
            .triangles = frame.triangles,
            .axis = 1,
            .coordinate = 0.5 * (back->y + front->y)};
}

void render_frame(const std::filesystem::path& folder, const record::Frame& frame)
{
    const std::string title = time_text(frame.t, frame.week);
    const auto picture = [&](const std::string& kind, std::span<const double> values) {
        return SurfacePicture{folder / record::surface_picture(kind, frame.name), values, scalar_scale(kind, values)};
    };
    const std::array surfaces{picture("J", frame.surface_J), picture("growth", frame.surface_growth),
                              picture("sulcal_depth", frame.sulcal_depth),
                              picture("mean_curvature", frame.mean_curvature)};
    render_surface(frame.surface, frame.triangles, surfaces, title);
    render_cut(folder / record::cut_picture(frame.name), middle_cut(frame, frame.particle_growth),
               scalar_scale("growth", frame.particle_growth), title);
}

formats::NumberTable number_table(std::span<const metrics::Measures> rows)
{
    formats::NumberTable table;
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        table.columns.push_back({std::string(column.key), std::string(column.unit), {}});
        for (const metrics::Measures& row : rows)
        {
            table.columns.back().values.push_back(column.of(row));
        }
    }
    return table;
}

void render_measures(const std::filesystem::path& file, const formats::NumberTable& measures)
{
    const formats::NumberColumn* const weeks = measures.find("week");
    const bool has_weeks =
        weeks != nullptr && std::ranges::none_of(weeks->values, [](double week) { return std::isnan(week); });
    const std::string axis = has_weeks ? "gestational week" : "growth time t";
    const std::vector<double>& x = has_weeks ? weeks->values : measures.find("t")->values;
    const auto panel = [&](std::string label, std::initializer_list<std::pair<const char*, const char*>> columns)
    {
        Panel made{axis, std::move(label), {}};
        for (const auto& [name, key] : columns)
        {
            if (const formats::NumberColumn* const column = measures.find(key); column != nullptr)
            {
                made.curves.push_back({name, x, column->values});
            }
        }
        return made;
    };
    const std::string energy = "energy [" + unit_text("mu_w mm3") + "]";
    const std::array panels{
        panel("over initial value", {{"area", "area_ratio"}, {"volume", "volume_ratio"}}),
        panel("gyrification index", {{"over hull", "gi_hull"}, {"over sphere", "gi_sphere"}}),
        panel("volume ratio J", {{"least", "J_min"}, {"mean", "J_mean"}, {"largest", "J_max"}}),
        panel(energy, {{"elastic", "energy_elastic"}, {"zero-energy control", "energy_zero_mode"}}),
        panel(energy, {{"kinetic", "energy_kinetic"}, {"contact", "energy_contact"}}),
        panel("share of area that overlaps", {{"overlap", "overlap_area_share"}}),
    };
    render_plot(file, panels, "Measures against " + axis);
}

void render_run(const std::filesystem::path& folder)
{
    const record::RunContents run = record::read_run(folder);
    std::string reason;
    if (!can_render(reason))
    {
        throw RunError("pictures cannot be made: " + reason);
    }
    const record::ResultFolder claimed = claim_pictures(folder, run.frames);
    for (const record::FrameFiles& files : run.frames)
    {
        record::Frame frame = record::read_frame(files);
        frame.week = record::week_at(run.measures, files.t);
        render_frame(folder, frame);
    }
    render_measures(folder / record::measures_picture, run.measures);
}

} // namespace corticle::view
