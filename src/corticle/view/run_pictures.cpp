// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/run_pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/record/run_reader.hpp"

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
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share)
    { return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]; };
    double low = std::floor(at(0.02) * 10.0) / 10.0;
    const double high = std::ceil(at(0.98) * 10.0) / 10.0;
    low = high - low < 0.1 ? high - 0.1 : low;
    return {std::move(label), low, high, map};
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
        fmt::format("t = {:.3f}", frame.t) + (std::isnan(frame.week) ? "" : fmt::format(", week {:.1f}", frame.week));
    const auto picture = [&](const std::string& kind, std::span<const double> values, const ColorScale& scale) {
        return SurfacePicture{folder / record::surface_picture(kind, frame.name), values, scale};
    };
    ColorScale curvature = robust_scale("mean curvature [1/mm]", frame.mean_curvature, ColorMap::coolwarm);
    curvature.high = std::max(curvature.high, -curvature.low); // 0 in the middle
    curvature.low = -curvature.high;
    const std::array surfaces{
        picture("J", frame.surface_J, robust_scale("J = det F", frame.surface_J, ColorMap::viridis)),
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
    const auto curve = [&](std::string label, double metrics::Measures::*value)
    {
        Curve c{std::move(label), {}, {}};
        for (const metrics::Measures& row : rows)
        {
            c.x.push_back(row.t);
            c.y.push_back(row.*value);
        }
        return c;
    };
    const std::array panels{
        Panel{"t",
              "ratio to t = 0",
              {curve("area", &metrics::Measures::area_ratio), curve("volume", &metrics::Measures::volume_ratio)}},
        Panel{"t",
              "gyrification index",
              {curve("hull", &metrics::Measures::gi_hull), curve("sphere", &metrics::Measures::gi_sphere)}},
        Panel{"t",
              "J",
              {curve("least", &metrics::Measures::J_min), curve("mean", &metrics::Measures::J_mean),
               curve("largest", &metrics::Measures::J_max)}},
        Panel{"t",
              "energy [mu_w mm³]",
              {curve("elastic", &metrics::Measures::energy_elastic),
               curve("zero-energy control", &metrics::Measures::energy_zero_mode)}},
        Panel{"t",
              "energy [mu_w mm³]",
              {curve("kinetic", &metrics::Measures::energy_kinetic),
               curve("contact", &metrics::Measures::energy_contact)}},
        Panel{"t", "overlapping area share", {curve("overlap", &metrics::Measures::overlap_area_share)}},
    };
    render_plot(folder / record::measures_picture, panels, "Measures against growth time");
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
