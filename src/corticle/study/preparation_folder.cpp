// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/preparation_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/gather.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/version.hpp"
#include "corticle/cloud/quality.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/record/body_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/summary.hpp"
#include "corticle/study/preparation_comparison.hpp"
#include "corticle/view/body_pictures.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array files{"body.h5", "case.toml", "particles.vtu", "surface.vtp", "preparation.json"};

/// Where a picture lies in the folder.
std::string picture(std::string_view name)
{
    return fmt::format("pictures/{}", name);
}

/// All that a preparation writes.
std::vector<std::string> written_files(const PrepareRequest& request, bool with_pictures)
{
    std::vector<std::string> all(files.begin(), files.end());
    if (with_pictures)
    {
        std::ranges::transform(view::body_pictures, std::back_inserter(all), picture);
    }
    if (with_pictures && request.compare_thesis)
    {
        std::ranges::transform(thesis_pictures, std::back_inserter(all), picture);
    }
    return all;
}

void require_free_folder(const record::ResultFolder& folder, const PrepareRequest& request)
{
    if (folder.is_used() && !request.overwrite)
    {
        throw InputError(fmt::format(
            "{}: holds a prepared body already; expected another folder, or --overwrite to replace it", folder.name()));
    }
    folder.require_free(written_files(request, request.options.output.pictures == config::PictureRule::on));
}

/// Edges of the box along the axes [mm].
std::array<double, 3> extent(std::span<const Vec3> points)
{
    std::array<double, 3> result{};
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
        result[static_cast<std::size_t>(axis)] = (*high)[axis] - (*low)[axis];
    }
    return result;
}

/// Number of handles of a closed surface in one piece, from its Euler characteristic.
std::int64_t genus(const TriangleMesh& surface)
{
    return (2 - std::ssize(surface.vertices) + std::ssize(surface.triangles) / 2) / 2;
}

/// Files of the body that ParaView opens.
void write_views(const fs::path& out, const model::Model& model, std::span<const double> theta,
                 const view::BodyQuality& quality)
{
    const material::TissueFields& tissue = model.tissue;
    const std::vector<double> normal = flattened(tissue.normal);
    std::vector<std::int32_t> ids(model.cloud.positions.size());
    std::iota(ids.begin(), ids.end(), 0);
    std::vector fields{formats::Field{"theta", 1, theta},
                       formats::Field{"depth", 1, tissue.depth},
                       formats::Field{"normal", 3, normal},
                       formats::Field{"volume", 1, model.cloud.volumes},
                       formats::Field{"regional_growth", 1, tissue.regional_rate},
                       formats::Field{"nearest_distance", 1, quality.nearest_distance},
                       formats::Field{"volume_over_mean", 1, quality.volume_over_mean},
                       formats::Field{"condition_number", 1, quality.condition_number}};
    for (const auto& [name, values] :
         {std::pair{"thickness", &tissue.thickness}, std::pair{"growth_onset", &tissue.growth_onset},
          std::pair{"growth_rate", &tissue.growth_rate}})
    {
        if (!values->empty())
        {
            fields.push_back(formats::Field{name, 1, *values});
        }
    }
    formats::write_particles_vtu(out / "particles.vtu", model.cloud.positions, ids, fields);

    const std::vector<double> growth = surface_values(model.cloud, tissue.regional_rate);
    const std::vector<double> thickness =
        tissue.thickness.empty() ? std::vector<double>{} : surface_values(model.cloud, tissue.thickness);
    std::vector surface_fields{formats::Field{"regional_growth", 1, growth}};
    if (!thickness.empty())
    {
        surface_fields.push_back(formats::Field{"thickness", 1, thickness});
    }
    formats::write_surface_vtp(out / "surface.vtp", model.surface.vertices, model.surface.triangles, surface_fields);
}

Json report_json(const prepare::Preparation& made, std::span<const double> theta, const config::Options& options,
                 const view::BodyQuality& quality, double seconds)
{
    const model::Model& model = made.model;
    const cloud::CloudQuality cloud = cloud::measure_quality(model.cloud);
    Json j;
    j["source"] = made.report.source;
    j["particles"] = model.cloud.positions.size();
    j["surface_particles"] = model.cloud.surface_particles.size();
    j["spacing_mm"] = model.cloud.spacing;
    j["elements"] = model.fem ? model.fem->elements.tets.size() : 0;
    j["neighbours_mean"] = made.report.neighbors_mean;
    j["dropped_pairs"] = made.report.visibility.dropped_pairs;
    j["area_mm2"] = surface_area(model.surface.vertices, model.surface.triangles);
    j["volume_mm3"] = enclosed_volume(model.surface.vertices, model.surface.triangles);
    j["particle_volume_sum_mm3"] = std::accumulate(model.cloud.volumes.begin(), model.cloud.volumes.end(), 0.0);
    j["extent_mm"] = extent(model.surface.vertices);
    j["genus"] = genus(model.surface);
    if (made.report.input_vertices > 0)
    {
        j["input_vertices"] = made.report.input_vertices;
        j["remesh_area_change"] = made.report.remesh.area_change;
        j["remesh_volume_change"] = made.report.remesh.volume_change;
        j["remesh_largest_distance_mm"] = made.report.remesh.largest_distance_mm;
    }
    j["closest_pair_spacings"] = cloud.closest_pair_spacings;
    j["volume_over_mean"] = {cloud.smallest_volume / cloud.mean_volume, cloud.largest_volume / cloud.mean_volume};
    j["worst_condition_number"] = *std::max_element(quality.condition_number.begin(), quality.condition_number.end());
    j["cortex_volume_share"] = view::cortex_share(model, theta);
    j.update(Json::parse(prepare::reports_json(made.report.inputs)));
    j["notes"] = made.report.notes;
    j["warnings"] = made.report.warnings;
    j["seconds"] = seconds;
    j["peak_memory_mb"] = record::peak_memory_mb();
    j["inputs"] = Json::parse(record::inputs_json(options));
    j["version"] = program_version();
    return j;
}

std::string report_text(const Json& j)
{
    std::string text;
    for (const auto& note : j["notes"])
    {
        text += note.get<std::string>() + "\n";
    }
    for (const auto& warning : j["warnings"])
    {
        text += "warning: " + warning.get<std::string>() + "\n";
    }
    const auto number = [&](const char* key) { return j[key].get<double>(); };
    text += fmt::format("volume        {:.6g} mm3, area {:.6g} mm2, extent {:.4g} x {:.4g} x {:.4g} mm, genus {}\n",
                        number("volume_mm3"), number("area_mm2"), j["extent_mm"][0].get<double>(),
                        j["extent_mm"][1].get<double>(), j["extent_mm"][2].get<double>(), j["genus"].get<int>());
    text += fmt::format("particles     {} ({} on the surface), spacing {:.4g} mm, {:.1f} neighbours\n",
                        j["particles"].get<std::int64_t>(), j["surface_particles"].get<std::int64_t>(),
                        number("spacing_mm"), number("neighbours_mean"));
    text +=
        fmt::format("quality       closest pair {:.3f} spacings, volumes {:.3f} to {:.3f} of the mean, worst condition "
                    "number {:.2f}\n",
                    number("closest_pair_spacings"), j["volume_over_mean"][0].get<double>(),
                    j["volume_over_mean"][1].get<double>(), number("worst_condition_number"));
    return text + fmt::format("took          {:.1f} s, {:.0f} MB\n", number("seconds"), number("peak_memory_mb"));
}

} // namespace

std::string prepare(const PrepareRequest& request)
{
    const auto start = std::chrono::steady_clock::now();
    set_thread_count(request.threads);
    record::ResultFolder folder(request.out, "prepared body");
    require_free_folder(folder, request);
    prepare::Preparation made = prepare::arrange_body(request.options);
    prepare::connect_body(request.options, made);
    const model::Model& model = made.model;
    const std::vector<double> theta =
        material::start_tissue(model.tissue, request.options.tissue, model::cortex_size(request.options),
                               request.options.time.start)
            .theta;
    const view::BodyQuality quality = view::measure_body_quality(model);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    Json report = report_json(made, theta, request.options, quality, seconds);
    std::optional<PreparationComparison> comparison;
    if (request.compare_thesis)
    {
        comparison = compare_preparation(model, request.options);
        report["thesis_comparison"] = Json::parse(comparison_json(*comparison));
    }

    folder.make();
    require_free_folder(folder, request); // again: the body may have taken a while
    folder.remove_written();
    std::string reason;
    const bool draws = request.options.output.pictures == config::PictureRule::on && view::can_render(reason);
    folder.claim(written_files(request, draws));
    record::write_body(request.out / "body.h5", made, request.options);
    formats::write_text_atomically(request.out / "case.toml", config::to_toml(request.options));
    write_views(request.out, model, theta, quality);
    if (draws)
    {
        view::render_body(request.out / "pictures", model, theta, quality);
    }
    if (draws && comparison)
    {
        write_comparison_pictures(request.out / "pictures", model, *comparison);
    }
    formats::write_text_atomically(request.out / "preparation.json", report.dump(2) + "\n");
    std::string text = report_text(report);
    if (comparison)
    {
        text += fmt::format("\n{}", comparison_text(*comparison));
    }
    if (!reason.empty())
    {
        text += fmt::format("warning: no pictures: {}\n", reason);
    }
    return text;
}

} // namespace corticle::study
