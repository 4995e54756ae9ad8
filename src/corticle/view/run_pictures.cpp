// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/run_pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/view/robust_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace corticle::view
{

namespace
{

constexpr double same_time = 1e-9;

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
    const std::string title =
        (std::isnan(frame.week) ? "" : fmt::format("week {:.3g}, ", frame.week)) + fmt::format("t = {:.3g}", frame.t);
    const auto picture = [&](const std::string& kind, std::span<const double> values, const ColorScale& scale) {
        return SurfacePicture{folder / record::surface_picture(kind, frame.name), values, scale};
    };
    ColorScale curvature = robust_scale("mean curvature [1/mm]", frame.mean_curvature, ColorMap::coolwarm);
    curvature.high = std::max(curvature.high, -curvature.low); // 0 in the middle
    curvature.low = -curvature.high;
    const std::array surfaces{
        picture("J", frame.surface_J, robust_scale("volume ratio J", frame.surface_J, ColorMap::viridis)),
        picture("growth", frame.surface_growth, robust_scale("growth g", frame.surface_growth, ColorMap::viridis)),
        picture("sulcal_depth", frame.sulcal_depth,
                robust_scale("sulcal depth [mm]", frame.sulcal_depth, ColorMap::viridis)),
        picture("mean_curvature", frame.mean_curvature, curvature)};
    render_surface(frame.surface, frame.triangles, surfaces, title);
    render_cut(folder / record::cut_picture(frame.name), middle_cut(frame, frame.particle_growth),
               robust_scale("growth g", frame.particle_growth, ColorMap::viridis), title);
}

void render_measures(const std::filesystem::path& folder, std::span<const metrics::Measures> rows)
{
    using metrics::Measures;
    const bool has_weeks = std::ranges::none_of(rows, [](const Measures& row) { return std::isnan(row.week); });
    const std::string axis = has_weeks ? "gestational week" : "growth time t";
    const auto curve = [&](std::string label, double Measures::*value)
    {
        Curve c{std::move(label), {}, {}};
        for (const Measures& row : rows)
        {
            c.x.push_back(has_weeks ? row.week : row.t);
            c.y.push_back(row.*value);
        }
        return c;
    };
    const std::array panels{
        Panel{axis,
              "over initial value",
              {curve("area", &Measures::area_ratio), curve("volume", &Measures::volume_ratio)}},
        Panel{axis,
              "gyrification index",
              {curve("over hull", &Measures::gi_hull), curve("over sphere", &Measures::gi_sphere)}},
        Panel{axis,
              "volume ratio J",
              {curve("least", &Measures::J_min), curve("mean", &Measures::J_mean), curve("largest", &Measures::J_max)}},
        Panel{axis,
              "energy [mu_w mm³]",
              {curve("elastic", &Measures::energy_elastic), curve("zero-energy control", &Measures::energy_zero_mode)}},
        Panel{axis,
              "energy [mu_w mm³]",
              {curve("kinetic", &Measures::energy_kinetic), curve("contact", &Measures::energy_contact)}},
        Panel{axis, "share of area that overlaps", {curve("overlap", &Measures::overlap_area_share)}},
    };
    render_plot(folder / record::measures_picture, panels, "Measures against " + axis);
}

void render_run(const std::filesystem::path& folder)
{
    const std::vector<record::FrameFiles> frames = record::list_frames(folder);
    const std::vector<metrics::Measures> rows = metrics::parse_measures_csv(
        formats::read_whole_file(folder / "measures.csv"), (folder / "measures.csv").string());
    std::string reason;
    if (!can_render(reason))
    {
        throw RunError("pictures cannot be made: " + reason);
    }
    const record::ResultFolder claimed = claim_pictures(folder, frames);
    for (const record::FrameFiles& files : frames)
    {
        record::Frame frame = record::read_frame(files);
        const auto row = std::ranges::find_if(rows, [&](const metrics::Measures& known)
                                              { return std::abs(known.t - files.t) < same_time; });
        frame.week = row == rows.end() ? frame.week : row->week;
        render_frame(folder, frame);
    }
    render_measures(folder, rows);
}

} // namespace corticle::view
