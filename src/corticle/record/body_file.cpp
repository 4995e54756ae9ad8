// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/body_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/version.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/prepare/thesis/ellipsoid.hpp"
#include "corticle/record/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace corticle::record
{

namespace
{

std::vector<std::int64_t> widened(std::span<const std::int32_t> values)
{
    return {values.begin(), values.end()};
}

template <std::size_t size>
std::vector<std::int64_t> flattened(const std::vector<std::array<std::int32_t, size>>& polygons)
{
    std::vector<std::int64_t> result;
    result.reserve(size * polygons.size());
    for (const auto& polygon : polygons)
    {
        result.insert(result.end(), polygon.begin(), polygon.end());
    }
    return result;
}

/// An array of a body file; refuses a file that lacks it.
template <class Map>
const typename Map::mapped_type& array_of(const Map& map, const std::string& name, const std::filesystem::path& file)
{
    const auto found = map.find(name);
    if (found == map.end())
    {
        throw InputError(
            fmt::format("{}: holds no {}; expected a body file made by corticle prepare", file.string(), name));
    }
    return found->second;
}

template <std::size_t size>
std::vector<std::array<std::int32_t, size>> polygons_of(std::span<const std::int64_t> corners)
{
    std::vector<std::array<std::int32_t, size>> polygons(corners.size() / size);
    for (std::size_t k = 0; k < size * polygons.size(); ++k)
    {
        polygons[k / size][k % size] = static_cast<std::int32_t>(corners[k]);
    }
    return polygons;
}

/// @param prefix  "body." for the nodes, "body.tet_" for the elements
void store_tissue(const material::TissueFields& tissue, const std::string& prefix, Checkpoint& image)
{
    image.vectors[prefix + "normal"] = tissue.normal;
    image.scalars[prefix + "depth"] = tissue.depth;
    image.scalars[prefix + "regional_rate"] = tissue.mapped_rate;
    image.scalars[prefix + "growth_onset"] = tissue.growth_onset;
    image.scalars[prefix + "growth_rate"] = tissue.growth_rate;
    image.scalars[prefix + "thickness"] = tissue.thickness;
    for (std::size_t k = 0; k < tissue.growth_maps.values.size(); ++k)
    {
        image.scalars[fmt::format("{}growth_map_{}", prefix, k)] = tissue.growth_maps.values[k];
    }
    if (!tissue.region.empty())
    {
        image.scalars[prefix + "region"] = tissue.region;
    }
    if (!tissue.cortex_inside.empty())
    {
        image.scalars[prefix + "cortex_inside"] = tissue.cortex_inside;
        std::vector<std::int64_t>& kinds = image.integers[prefix + "tissue"];
        std::ranges::transform(tissue.kind, std::back_inserter(kinds),
                               [](material::TissueKind kind) { return static_cast<std::int64_t>(kind); });
    }
}

material::TissueFields stored_tissue(const Checkpoint& image, const std::string& prefix,
                                     const std::filesystem::path& file)
{
    material::TissueFields tissue;
    tissue.normal = array_of(image.vectors, prefix + "normal", file);
    tissue.depth = array_of(image.scalars, prefix + "depth", file);
    tissue.mapped_rate = array_of(image.scalars, prefix + "regional_rate", file);
    tissue.growth_onset = array_of(image.scalars, prefix + "growth_onset", file);
    tissue.growth_rate = array_of(image.scalars, prefix + "growth_rate", file);
    tissue.thickness = array_of(image.scalars, prefix + "thickness", file);
    const auto map_name = [&](std::size_t k) { return fmt::format("{}growth_map_{}", prefix, k); };
    for (std::size_t k = 0; image.scalars.contains(map_name(k)); ++k)
    {
        tissue.growth_maps.values.push_back(image.scalars.at(map_name(k)));
    }
    if (image.scalars.contains(prefix + "region"))
    {
        tissue.region = image.scalars.at(prefix + "region");
    }
    if (image.scalars.contains(prefix + "cortex_inside"))
    {
        tissue.cortex_inside = array_of(image.scalars, prefix + "cortex_inside", file);
        std::ranges::transform(array_of(image.integers, prefix + "tissue", file), std::back_inserter(tissue.kind),
                               [](std::int64_t kind) { return static_cast<material::TissueKind>(kind); });
    }
    return tissue;
}

/// Thickness of the cortex that the spacing is graded for [mm]; of a map or of labels, which go by their checksums, 0.
double graded_thickness(const config::Options& options, const model::Model& model)
{
    return options.map.thickness_file.empty() && !prepare::has_labelled_cortex(options)
               ? prepare::grading_of(options, {}, prepare::fitted_semi_axes(model.surface.vertices)).cortex_mm
               : 0.0;
}

} // namespace

void write_body(const std::filesystem::path& file, const prepare::Preparation& made, const config::Options& options)
{
    const model::Model& model = made.model;
    Checkpoint image;
    image.program_version = program_version();
    image.case_text = config::to_toml(options);
    image.vectors["body.position"] = model.cloud.positions;
    image.vectors["body.centroid"] = model.cloud.centroids;
    store_tissue(model.tissue, "body.", image);
    image.vectors["body.surface_vertex"] = model.surface.vertices;
    image.vectors["body.inner_vertex"] = model.inner_surface.vertices;
    image.integers["body.inner_triangle"] = flattened(model.inner_surface.triangles);
    image.scalars["body.volume"] = model.cloud.volumes;
    image.scalars["body.spacing"] = {model.cloud.spacing};
    image.scalars["body.local_spacing"] = model.cloud.local_spacing;
    image.scalars["body.graded_for"] = {graded_thickness(options, model)};
    image.scalars["body.remesh"] = {made.report.remesh.area_change, made.report.remesh.volume_change,
                                    made.report.remesh.largest_distance_mm};
    image.integers["body.input_vertices"] = {made.report.input_vertices};
    image.integers["body.surface_particle"] = widened(model.cloud.surface_particles);
    image.integers["body.surface_triangle"] = flattened(model.cloud.surface_triangles);
    if (model.fem)
    {
        image.integers["body.tet"] = flattened(model.fem->elements.tets);
        store_tissue(model.fem->tissue, "body.tet_", image);
    }
    write_checkpoint(file, image);
}

prepare::Preparation read_body(const std::filesystem::path& file, const config::Options& options)
{
    const Checkpoint image = read_checkpoint(file);
    const auto vectors = [&](const std::string& name) { return array_of(image.vectors, "body." + name, file); };
    const auto scalars = [&](const std::string& name) { return array_of(image.scalars, "body." + name, file); };
    const auto integers = [&](const std::string& name) { return array_of(image.integers, "body." + name, file); };
    prepare::Preparation made;
    model::Model& model = made.model;
    model.cloud.positions = vectors("position");
    model.cloud.volumes = scalars("volume");
    model.cloud.centroids = vectors("centroid");
    model.cloud.spacing = scalars("spacing").at(0);
    model.cloud.local_spacing = scalars("local_spacing");
    const std::vector<std::int64_t> surface_particles = integers("surface_particle");
    model.cloud.surface_particles.assign(surface_particles.begin(), surface_particles.end());
    model.cloud.surface_triangles = polygons_of<3>(integers("surface_triangle"));
    model.surface = {vectors("surface_vertex"), model.cloud.surface_triangles};
    if (image.vectors.contains("body.inner_vertex"))
    {
        model.inner_surface = {vectors("inner_vertex"), polygons_of<3>(integers("inner_triangle"))};
    }
    model.tissue = stored_tissue(image, "body.", file);
    const std::vector<double> remesh = scalars("remesh");
    made.report.remesh = {remesh.at(0), remesh.at(1), remesh.at(2)};
    made.report.input_vertices = integers("input_vertices").at(0);
    const std::vector<std::string> differences = config::differing_body_keys(image.case_text, config::to_toml(options));
    if (!differences.empty())
    {
        throw InputError(
            fmt::format("{}: this body was made from another case: {}; expected the same [geometry], [map] and method",
                        file.string(), fmt::join(differences, ", ")));
    }
    if (options.method == model::Method::fem)
    {
        model.fem = model::ElementModel{
            fem::make_elements(model.cloud.positions, polygons_of<4>(integers("tet")), model.cloud.spacing),
            stored_tissue(image, "body.tet_", file)};
    }
    if (const double graded = scalars("graded_for").at(0), now = graded_thickness(options, model);
        std::abs(graded - now) > 1e-6 * graded)
    {
        throw InputError(
            fmt::format("{}: the spacing of this body is graded for a cortex of {:.4g} mm: got a case with "
                        "{:.4g} mm, expected the same",
                        file.string(), graded, now));
    }
    made.report.source = "body file";
    made.report.notes = {"read from " + file.string()};
    if (image.program_version != program_version())
    {
        made.report.warnings.push_back(
            fmt::format("{} was made by version {}, this is {}: another body may come of the same case", file.string(),
                        image.program_version, program_version()));
    }
    return made;
}

} // namespace corticle::record
