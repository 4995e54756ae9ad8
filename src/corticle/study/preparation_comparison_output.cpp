// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/ellipsoid.hpp"
#include "corticle/study/preparation_comparison.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace corticle::study
{

namespace
{

using Json = nlohmann::ordered_json;

/// One row of a table: a choice and its figures, by name.
struct Row
{
    std::string choice;
    std::vector<std::pair<std::string, double>> figures;
};

struct Section
{
    std::string key, heading;
    std::vector<Row> rows;
};

/// Everything as tables of one form, so that JSON and text hold the same.
std::vector<Section> sections(const PreparationComparison& comparison)
{
    std::vector<Section> all;
    Section& normals = all.emplace_back(Section{"normals", "Angle between the normals and the exact ones", {}});
    for (const NormalErrors& e : comparison.normals)
    {
        normals.rows.push_back({e.choice,
                                {{"mean_deg", e.mean},
                                 {"percentile_95_deg", e.percentile_95},
                                 {"largest_deg", e.largest},
                                 {"mean_in_cortex_deg", e.mean_in_cortex}}});
    }
    Section& volumes = all.emplace_back(Section{"volumes", "Volumes of the particles against the exact ones", {}});
    for (const VolumeErrors& e : comparison.volumes)
    {
        volumes.rows.push_back({e.choice,
                                {{"sum_error", e.sum},
                                 {"rms_error", e.rms},
                                 {"largest_error", e.largest},
                                 {"surface_ratio", e.surface_ratio},
                                 {"below_ratio", e.below_ratio},
                                 {"deep_ratio", e.deep_ratio}}});
    }
    Section& depths = all.emplace_back(Section{"depths", "Distance to the surface against the exact one", {}});
    for (const DepthErrors& e : comparison.depths)
    {
        depths.rows.push_back({e.choice, {{"mean_mm", e.mean}, {"largest_mm", e.largest}}});
    }
    Section& layers = all.emplace_back(Section{"layers", "The cortex", {}});
    layers.rows.push_back({"exact", {{"cortex_share", comparison.exact_cortex_share}, {"misassigned_share", 0.0}}});
    for (const LayerErrors& e : comparison.layers)
    {
        layers.rows.push_back(
            {e.choice, {{"cortex_share", e.cortex_share}, {"misassigned_share", e.misassigned_share}}});
    }
    Section& clouds = all.emplace_back(Section{"clouds", "Regularity of the cloud, distances in spacings", {}});
    for (const auto& [choice, e] : comparison.clouds)
    {
        clouds.rows.push_back({choice,
                               {{"particles", static_cast<double>(e.particles)},
                                {"closest_pair", e.closest_pair},
                                {"nearest_mean", e.nearest_mean},
                                {"nearest_variation", e.nearest_variation},
                                {"neighbors_variation", e.neighbors_variation},
                                {"fewest_neighbors", static_cast<double>(e.fewest_neighbors)},
                                {"worst_condition", e.worst_condition},
                                {"ill_conditioned", static_cast<double>(e.ill_conditioned)}}});
    }
    return all;
}

} // namespace

std::string comparison_json(const PreparationComparison& comparison)
{
    Json j;
    j["reference"] = comparison.reference;
    j["particles"] = comparison.particles;
    j["spacing_mm"] = comparison.spacing_mm;
    j["kernel_radius_mm"] = comparison.thesis.kernel_radius_mm;
    j["lambda"] = comparison.thesis.lambda;
    j["dense_ratio"] = comparison.thesis.dense_ratio;
    j["seed"] = comparison.thesis.seed;
    for (const Section& section : sections(comparison))
    {
        Json rows = Json::array();
        for (const Row& row : section.rows)
        {
            Json& entry = rows.emplace_back(Json{{"choice", row.choice}});
            for (const auto& [name, value] : row.figures)
            {
                entry[name] = value; // an infinite condition is written as null
            }
        }
        j[section.key] = std::move(rows);
    }
    return j.dump(2) + "\n";
}

std::string comparison_text(const PreparationComparison& comparison)
{
    std::string text = fmt::format("{} particles, spacing {:.4g} mm; exact: {}\n", comparison.particles,
                                   comparison.spacing_mm, comparison.reference);
    for (const Section& section : sections(comparison))
    {
        text += fmt::format("\n{}\n\n| choice |", section.heading);
        std::string rule = "\n| --- |";
        for (const auto& [name, value] : section.rows.front().figures)
        {
            text += fmt::format(" {} |", name);
            rule += " ---: |";
        }
        text += rule + "\n";
        for (const Row& row : section.rows)
        {
            text += fmt::format("| {} |", row.choice);
            for (const auto& [name, value] : row.figures)
            {
                text += fmt::format(" {:.4g} |", value);
            }
            text += "\n";
        }
    }
    return text;
}

std::vector<formats::Field> comparison_fields(const PreparationComparison& comparison)
{
    return {{"thesis_normal_error_deg", 1, comparison.normal_error},
            {"thesis_volume_ratio", 1, comparison.volume_ratio},
            {"thesis_theta", 1, comparison.thesis_theta},
            {"thesis_layer_disagreement", 1, comparison.layer_disagreement}};
}

void write_comparison_pictures(const std::filesystem::path& folder, const model::Model& model,
                               const PreparationComparison& comparison)
{
    const std::vector<Mat3> undeformed(model.cloud.positions.size(), Mat3::identity());
    const std::int32_t divisions = comparison.thesis.divisions[comparison.thesis.divisions.size() / 2];
    const auto render =
        [&](const char* name, std::span<const double> scalar, const view::ColorScale& scale, const std::string& title)
    {
        const view::CutInput cut{.positions = model.cloud.positions,
                                 .origins = model.cloud.positions,
                                 .F = undeformed,
                                 .theta = comparison.thesis_theta,
                                 .scalar = scalar,
                                 .spacing = model.cloud.spacing,
                                 .surface_points = model.surface.vertices,
                                 .triangles = model.surface.triangles,
                                 .axis = 1,
                                 .coordinate = prepare::extents_centre(model.cloud.positions).y};
        view::render_cut(folder / name, cut, scale, title);
    };
    const double most_degrees = comparison.reference == "sphere" ? 10.0 : 90.0;
    render("thesis_normals.png", comparison.normal_error, {"angle to the exact normal [deg]", 0.0, most_degrees},
           fmt::format("Layer by eq. 24, and normals by the nearest line of {} divisions", divisions));
    render("thesis_volumes.png", comparison.volume_ratio, {"volume / exact volume", 0.0, 4.0},
           fmt::format("Layer by eq. 24, and volumes by counts within {:g} mm", comparison.thesis.kernel_radius_mm));
    render("thesis_layer.png", comparison.layer_disagreement,
           {"cortex less exact cortex", -1.0, 1.0, view::ColorMap::coolwarm},
           fmt::format("Layer by eq. 24 with lambda = {:g}, and where it is wrong", comparison.thesis.lambda));
}

} // namespace corticle::study
