// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/body_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/io/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace corticle
{

namespace
{

std::vector<std::int64_t> widened(std::span<const std::int32_t> values)
{
    return {values.begin(), values.end()};
}

std::vector<std::int64_t> flattened(std::span<const Triangle> triangles)
{
    std::vector<std::int64_t> result;
    result.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
    {
        result.insert(result.end(), triangle.begin(), triangle.end());
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

std::vector<Triangle> triangles_of(std::span<const std::int64_t> corners)
{
    std::vector<Triangle> triangles(corners.size() / 3);
    for (std::size_t k = 0; k < 3 * triangles.size(); ++k)
    {
        triangles[k / 3][k % 3] = static_cast<std::int32_t>(corners[k]);
    }
    return triangles;
}

} // namespace

void write_body(const std::filesystem::path& file, const Body& body, const Options& options)
{
    Checkpoint image;
    image.program_version = CORTICLE_VERSION;
    image.case_text = to_toml(options);
    image.vectors["body.position"] = body.cloud.positions;
    image.vectors["body.normal"] = body.tissue.normal;
    image.vectors["body.surface_vertex"] = body.surface.vertices;
    image.scalars["body.volume"] = body.cloud.volumes;
    image.scalars["body.depth"] = body.tissue.depth;
    image.scalars["body.regional_rate"] = body.tissue.regional_rate;
    image.scalars["body.growth_onset"] = body.tissue.growth_onset;
    image.scalars["body.growth_rate"] = body.tissue.growth_rate;
    image.scalars["body.thickness"] = body.tissue.thickness;
    image.scalars["body.spacing"] = {body.cloud.spacing};
    image.scalars["body.remesh"] = {body.report.remesh.area_change, body.report.remesh.volume_change,
                                    body.report.remesh.largest_distance_mm};
    image.integers["body.input_vertices"] = {body.report.input_vertices};
    image.integers["body.surface_particle"] = widened(body.cloud.surface_particles);
    image.integers["body.surface_triangle"] = flattened(body.cloud.surface_triangles);
    write_checkpoint(file, image);
}

Body read_body(const std::filesystem::path& file, const Options& options)
{
    const Checkpoint image = read_checkpoint(file);
    const auto vectors = [&](const std::string& name) { return array_of(image.vectors, "body." + name, file); };
    const auto scalars = [&](const std::string& name) { return array_of(image.scalars, "body." + name, file); };
    const auto integers = [&](const std::string& name) { return array_of(image.integers, "body." + name, file); };
    Body body;
    body.cloud.positions = vectors("position");
    body.cloud.volumes = scalars("volume");
    body.cloud.spacing = scalars("spacing").at(0);
    const std::vector<std::int64_t> surface_particles = integers("surface_particle");
    body.cloud.surface_particles.assign(surface_particles.begin(), surface_particles.end());
    body.cloud.surface_triangles = triangles_of(integers("surface_triangle"));
    body.surface = {vectors("surface_vertex"), body.cloud.surface_triangles};
    body.tissue.normal = vectors("normal");
    body.tissue.depth = scalars("depth");
    body.tissue.regional_rate = scalars("regional_rate");
    body.tissue.growth_onset = scalars("growth_onset");
    body.tissue.growth_rate = scalars("growth_rate");
    body.tissue.thickness = scalars("thickness");
    const std::vector<double> remesh = scalars("remesh");
    body.report.remesh = {remesh.at(0), remesh.at(1), remesh.at(2)};
    body.report.input_vertices = integers("input_vertices").at(0);
    const std::vector<std::string> differences = differing_body_keys(image.case_text, to_toml(options));
    if (!differences.empty())
    {
        throw InputError(
            fmt::format("{}: this body was made from another case: {}; expected the same [geometry] and [map]",
                        file.string(), fmt::join(differences, ", ")));
    }
    body.report.source = "body file";
    body.report.notes = {"read from " + file.string()};
    return body;
}

} // namespace corticle
