// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/preparation_comparison.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/cloud/cells.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/cloud/thinning.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/material/layer.hpp"
#include "corticle/mesh/point_tree.hpp"
#include "corticle/prepare/thesis/division_normals.hpp"
#include "corticle/prepare/thesis/ellipsoid.hpp"
#include "corticle/prepare/thesis/neighbor_count_volumes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace corticle::study
{

namespace
{

/// The answers that the choices are measured against, one per particle.
struct Exact
{
    std::string reference;
    std::vector<double> depth;  ///< [mm]
    std::vector<Vec3> normal;   ///< unit
    std::vector<double> volume; ///< [mm³]
    std::vector<double> theta;  ///< 1 where the particle itself is in the cortex, else 0
    double total_volume = 0.0;  ///< [mm³]
    double cortex_volume = 0.0; ///< [mm³]
};

double sum(std::span<const double> values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::span<const Vec3> positions_of(const model::Model& model)
{
    return model.cloud.positions;
}

bool is_sphere_by_lambda(const config::Options& options)
{
    return options.geometry.shape == prepare::Shape::sphere && options.tissue.lambda > 0.0 &&
           options.tissue.layer == material::Layer::binary;
}

/// Thickness of the exact cortex at each particle: on the sphere that of eq. 24 where the case has a lambda [mm].
std::vector<double> exact_thickness(const model::Model& model, const config::Options& options)
{
    if (!model.tissue.thickness.empty())
    {
        return model.tissue.thickness;
    }
    const double everywhere = is_sphere_by_lambda(options)
                                  ? (1.0 - std::sqrt(options.tissue.lambda)) * options.geometry.radius_mm
                                  : options.tissue.thickness_mm;
    return std::vector<double>(model.cloud.positions.size(), everywhere);
}

/// Depths and normals of the sphere itself.
void set_sphere(const model::Model& model, double radius, Exact& exact)
{
    exact.reference = "sphere";
    for (const Vec3& X : positions_of(model))
    {
        exact.depth.push_back(std::max(radius - norm(X), 0.0));
        exact.normal.push_back(normalized(X));
    }
}

/// Depths of the triangulated surface, and their gradient as normals; on the surface itself the vertex normals.
void set_surface(const model::Model& model, const geometry::SurfaceTree& tree, Exact& exact)
{
    exact.reference = "triangulated surface";
    const std::int64_t count = std::ssize(positions_of(model));
    exact.depth.resize(count);
    exact.normal.resize(count);
    parallel_for(count,
                 [&](std::int64_t i)
                 {
                     const Vec3& X = model.cloud.positions[i];
                     const geometry::SurfacePoint foot = tree.closest(X);
                     const double depth = std::sqrt(foot.squared_distance);
                     const bool on_it = depth < 1e-6 * model.cloud.spacing;
                     exact.depth[i] = depth;
                     exact.normal[i] = on_it ? tree.interpolated_normal(foot) : (foot.position - X) / depth;
                 });
}

Exact exact_answers(const model::Model& model, const config::Options& options, const geometry::SurfaceTree& tree)
{
    constexpr double fine_lines = 24.0; // per spacing
    Exact exact;
    const bool sphere = options.geometry.shape == prepare::Shape::sphere;
    if (sphere)
    {
        set_sphere(model, options.geometry.radius_mm, exact);
    }
    else
    {
        set_surface(model, tree, exact);
    }
    exact.volume = cloud::cells_of(model.surface, model.cloud.positions, model.cloud.spacing, fine_lines).volumes;
    exact.total_volume = enclosed_volume(model.surface.vertices, model.surface.triangles);
    const std::vector<double> thickness = exact_thickness(model, options);
    std::vector<double> inside;
    for (std::size_t i = 0; i < thickness.size(); ++i)
    {
        inside.push_back(thickness[i] - exact.depth[i]);
        exact.theta.push_back(inside[i] >= 0.0 ? 1.0 : 0.0);
    }
    exact.cortex_volume =
        sphere && model.tissue.thickness.empty()
            ? exact.total_volume * (1.0 - std::pow(1.0 - thickness[0] / options.geometry.radius_mm, 3))
            : material::volume_inside(inside, exact.volume);
    return exact;
}

std::vector<double> angles(std::span<const Vec3> normals, std::span<const Vec3> exact)
{
    std::vector<double> degrees;
    degrees.reserve(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        // From the chord, which is accurate for small angles too.
        const double half_chord = std::min(0.5 * norm(normals[i] - exact[i]), 1.0);
        degrees.push_back(360.0 / std::numbers::pi * std::asin(half_chord));
    }
    return degrees;
}

NormalErrors normal_errors(std::string choice, std::span<const double> degrees, const Exact& exact)
{
    std::vector<double> sorted(degrees.begin(), degrees.end());
    std::sort(sorted.begin(), sorted.end());
    NormalErrors errors{std::move(choice)};
    errors.mean = sum(sorted) / static_cast<double>(sorted.size());
    errors.percentile_95 = sorted[static_cast<std::size_t>(0.95 * static_cast<double>(sorted.size() - 1))];
    errors.largest = sorted.back();
    const double in_cortex = std::inner_product(degrees.begin(), degrees.end(), exact.theta.begin(), 0.0);
    errors.mean_in_cortex = in_cortex / std::max(sum(exact.theta), 1.0);
    return errors;
}

VolumeErrors volume_errors(std::string choice, std::span<const double> volumes, const model::Model& model,
                           const Exact& exact, double kernel_radius)
{
    enum Place
    {
        surface,
        below,
        deep
    };
    std::vector<Place> place;
    for (const double depth : exact.depth)
    {
        place.push_back(depth < kernel_radius ? below : deep);
    }
    for (const std::int32_t particle : model.cloud.surface_particles)
    {
        place[particle] = surface;
    }
    std::array<double, 3> found{};
    std::array<double, 3> expected{};
    double squares = 0.0;
    VolumeErrors errors{std::move(choice)};
    for (std::size_t i = 0; i < volumes.size(); ++i)
    {
        const double error = volumes[i] / exact.volume[i] - 1.0;
        squares += error * error;
        errors.largest = std::max(errors.largest, std::abs(error));
        found[place[i]] += volumes[i];
        expected[place[i]] += exact.volume[i];
    }
    const auto ratio = [&](Place p) { return expected[p] > 0.0 ? found[p] / expected[p] : 0.0; };
    errors.sum = sum(volumes) / exact.total_volume - 1.0;
    errors.rms = std::sqrt(squares / static_cast<double>(volumes.size()));
    errors.surface_ratio = ratio(surface);
    errors.below_ratio = ratio(below);
    errors.deep_ratio = ratio(deep);
    return errors;
}

/// Distances to the nearest particle on the surface (thesis section 2.3).
std::vector<double> distances_to_surface_particles(const model::Model& model)
{
    const PointTree tree(model.surface.vertices);
    std::vector<double> distances(model.cloud.positions.size());
    parallel_for(std::ssize(distances), [&](std::int64_t i)
                 { distances[i] = std::sqrt(tree.nearest_squared<1>(model.cloud.positions[i])[0]); });
    return distances;
}

DepthErrors depth_errors(std::string choice, std::span<const double> depths, const Exact& exact)
{
    DepthErrors errors{std::move(choice)};
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
        const double error = std::abs(depths[i] - exact.depth[i]);
        errors.mean += error / static_cast<double>(depths.size());
        errors.largest = std::max(errors.largest, error);
    }
    return errors;
}

LayerErrors layer_errors(std::string choice, std::span<const double> theta, std::span<const double> volumes,
                         const Exact& exact)
{
    LayerErrors errors{std::move(choice)};
    for (std::size_t i = 0; i < theta.size(); ++i)
    {
        errors.cortex_share += theta[i] * volumes[i] / exact.total_volume;
        errors.misassigned_share += std::abs(theta[i] - exact.theta[i]) * exact.volume[i] / exact.total_volume;
    }
    return errors;
}

/// The tissue as it would be at t = 0.
struct OurTissue : material::TissueFields
{
    std::vector<double> theta; ///< of a sharp layer
};

/// What we do, whatever the case of the body chooses.
OurTissue our_tissue(const model::Model& model, const config::Options& options, const geometry::SurfaceTree& tree)
{
    OurTissue ours;
    ours.thickness = model.tissue.thickness;
    ours.volume = cloud::cells_of(model.surface, model.cloud.positions, model.cloud.spacing).volumes;
    ours.depth.resize(model.cloud.positions.size());
    ours.normal.resize(model.cloud.positions.size());
    parallel_for(std::ssize(ours.depth),
                 [&](std::int64_t i)
                 {
                     const geometry::SurfacePoint foot = tree.closest(model.cloud.positions[i]);
                     ours.depth[i] = std::sqrt(foot.squared_distance);
                     ours.normal[i] = tree.interpolated_normal(foot);
                 });
    if (is_sphere_by_lambda(options))
    {
        const double radius = options.geometry.radius_mm;
        ours.theta = prepare::ellipsoid_layer(model.cloud.positions, ours.volume, {radius, radius, radius},
                                              options.tissue.lambda);
    }
    else
    {
        material::TissueOptions sharp = options.tissue;
        sharp.layer = material::Layer::binary; // what the exact cortex is compared with
        material::TissueState state;
        material::set_layer(ours, sharp, {}, 0.0, state);
        ours.theta = std::move(state.theta);
    }
    return ours;
}

void compare_normals(const model::Model& model, const OurTissue& ours, const Exact& exact,
                     PreparationComparison& result)
{
    result.normals.push_back(normal_errors("ours: closest point", angles(ours.normal, exact.normal), exact));
    const prepare::NormalLines lines = prepare::triangle_normal_lines(model.surface);
    const Vec3 centre = prepare::extents_centre(model.cloud.positions);
    const std::vector<std::int32_t>& divisions = result.thesis.divisions;
    for (std::size_t k = 0; k < divisions.size(); ++k)
    {
        const std::vector<Vec3> normals = prepare::division_normals(model.cloud.positions, lines, divisions[k], centre);
        std::vector<double> degrees = angles(normals, exact.normal);
        result.normals.push_back(
            normal_errors(fmt::format("thesis: nearest line, {} divisions", divisions[k]), degrees, exact));
        if (k == divisions.size() / 2)
        {
            result.normal_error = std::move(degrees);
        }
    }
}

std::vector<double> compare_volumes(const model::Model& model, const OurTissue& ours, const Exact& exact,
                                    PreparationComparison& result)
{
    const double radius = result.thesis.kernel_radius_mm;
    std::vector<double> volumes = prepare::neighbor_count_volumes(model.cloud.positions, radius, exact.total_volume);
    result.volumes.push_back(
        volume_errors("ours: Voronoi cells cut at the surface", ours.volume, model, exact, radius));
    result.volumes.push_back(
        volume_errors(fmt::format("thesis: neighbour counts within {:g} mm", radius), volumes, model, exact, radius));
    for (std::size_t i = 0; i < volumes.size(); ++i)
    {
        result.volume_ratio.push_back(volumes[i] / exact.volume[i]);
    }
    return volumes;
}

void compare_layers(const model::Model& model, const OurTissue& ours, const Exact& exact,
                    std::span<const double> thesis_volumes, PreparationComparison& result)
{
    const std::span<const Vec3> positions = positions_of(model);
    const double lambda = result.thesis.lambda;
    const Vec3 centre = prepare::extents_centre(positions);
    const std::array<double, 3> semi_axes = prepare::fitted_semi_axes(positions);
    result.thesis_theta = prepare::ellipsoid_layer_by_centres(positions, semi_axes, lambda, centre);
    std::vector<double> levels;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        levels.push_back(prepare::ellipsoid_level(positions[i], semi_axes, centre));
        result.layer_disagreement.push_back(result.thesis_theta[i] - exact.theta[i]);
    }
    result.exact_cortex_share = exact.cortex_volume / exact.total_volume;
    result.layers.push_back(layer_errors("ours: depth, volume kept", ours.theta, ours.volume, exact));
    result.layers.push_back(layer_errors(fmt::format("thesis: eq. 24 with lambda = {:g}, exact volumes", lambda),
                                         result.thesis_theta, exact.volume, exact));
    result.layers.push_back(
        layer_errors(fmt::format("thesis: eq. 24 with lambda = {:g}, volumes of eqs. 25-26", lambda),
                     result.thesis_theta, thesis_volumes, exact));
    result.layers.push_back(layer_errors("eq. 24 with lambda fitted to the exact volume of the cortex",
                                         material::sharp_layer(levels, exact.volume, exact.cortex_volume), exact.volume,
                                         exact));
}

std::vector<Vec3> chosen(std::span<const Vec3> points, std::span<const std::int32_t> kept)
{
    std::vector<Vec3> subset;
    subset.reserve(kept.size());
    for (const std::int32_t i : kept)
    {
        subset.push_back(points[i]);
    }
    return subset;
}

void compare_regularity(const model::Model& model, const config::Options& options, const geometry::SurfaceTree& tree,
                        PreparationComparison& result)
{
    const double spacing = model.cloud.spacing;
    const double support = options.tlsph.support * spacing;
    const auto add = [&](std::string choice, std::span<const Vec3> points)
    {
        std::vector<double> depths(points.size());
        parallel_for(std::ssize(points),
                     [&](std::int64_t i) { depths[i] = std::sqrt(tree.closest(points[i]).squared_distance); });
        result.clouds.push_back({std::move(choice), measure_regularity(points, depths, spacing, support)});
    };
    const prepare::Arrangement arrangement = options.geometry.arrangement;
    add(arrangement == prepare::Arrangement::body_fitted ? "ours: repulsion"
                                                         : std::string("this body: ") + prepare::name_of(arrangement),
        model.cloud.positions);

    constexpr double edge_per_spacing = 1.05;
    const double dense_spacing = spacing / std::cbrt(result.thesis.dense_ratio);
    const TriangleMesh surface = geometry::remesh_isotropic(model.surface, edge_per_spacing * dense_spacing);
    const std::vector<Vec3> dense = cloud::fill_surface(surface, {dense_spacing, result.thesis.seed}).positions;
    const std::int64_t count = std::min(result.particles, std::ssize(dense));
    add("thesis: random thinning", chosen(dense, cloud::thin_random(dense, count, result.thesis.seed)));
    add("sample elimination", chosen(dense, cloud::thin_uniform(dense, count, result.thesis.seed)));
}

} // namespace

PreparationComparison compare_preparation(const model::Model& model, const config::Options& options,
                                          const ThesisPreparation& thesis)
{
    PreparationComparison result;
    result.thesis = thesis;
    result.particles = std::ssize(model.cloud.positions);
    result.spacing_mm = model.cloud.spacing;
    const geometry::SurfaceTree tree(model.surface.vertices, model.surface.triangles);
    const Exact exact = exact_answers(model, options, tree);
    const OurTissue ours = our_tissue(model, options, tree);
    result.reference = exact.reference;
    compare_normals(model, ours, exact, result);
    const std::vector<double> thesis_volumes = compare_volumes(model, ours, exact, result);
    result.depths.push_back(depth_errors("ours: closest point of the triangles", ours.depth, exact));
    result.depths.push_back(
        depth_errors("thesis: nearest particle on the surface", distances_to_surface_particles(model), exact));
    compare_layers(model, ours, exact, thesis_volumes, result);
    compare_regularity(model, options, tree, result);
    return result;
}

} // namespace corticle::study
