// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/body.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/config/parameters.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/io/surface_reader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <numbers>

namespace corticle
{

namespace
{

/// Surface edges over the spacing: makes the cell of a surface particle about half of an inner one.
constexpr double edge_per_spacing = 1.05;

std::array<double, 3> semi_axes(const GeometryOptions& geometry)
{
    return geometry.shape == "sphere" ? std::array{geometry.radius_mm, geometry.radius_mm, geometry.radius_mm}
                                      : geometry.semi_axes_mm;
}

TriangleMesh read_input_surface(const GeometryOptions& geometry)
{
    TriangleMesh surface = read_surface(geometry.file, millimetres_per(geometry.unit));
    require_valid_surface(surface, geometry.file);
    return surface;
}

double ellipsoid_volume(const std::array<double, 3>& axes)
{
    return 4.0 / 3.0 * std::numbers::pi * axes[0] * axes[1] * axes[2];
}

/// Depth and normal of every particle from the closest point of the surface; exact on the surface itself.
void set_tissue(const Options& options, const SurfaceTree& tree, Body& body)
{
    const std::size_t count = body.cloud.positions.size();
    Tissue& tissue = body.tissue;
    tissue.options = options.tissue;
    tissue.depth.resize(count);
    tissue.normal.resize(count);
    tissue.regional_rate.assign(count, 1.0);
    tissue.volume = body.cloud.volumes;
    parallel_for(static_cast<std::int64_t>(count),
                 [&](std::int64_t signed_i)
                 {
                     const auto i = static_cast<std::size_t>(signed_i);
                     const SurfacePoint nearest = tree.closest(body.cloud.positions[i]);
                     tissue.depth[i] = std::sqrt(nearest.squared_distance);
                     tissue.normal[i] = tree.interpolated_normal(nearest);
                 });
    for (const std::int32_t particle : body.cloud.surface_particles)
    {
        tissue.depth[static_cast<std::size_t>(particle)] = 0.0;
    }
    if (options.tissue.layer == Layer::binary && options.tissue.lambda > 0.0)
    {
        tissue.theta =
            ellipsoid_layer(body.cloud.positions, tissue.volume, semi_axes(options.geometry), options.tissue.lambda);
    }
    else
    {
        tissue.set_layer(0.0);
        tissue.theta_is_fixed = options.tissue.thickness_rate_mm == 0.0;
    }
}

/// Thickness of the cortex at t = 0 [mm]; where eq. 24 defines it, along the shortest semi-axis.
double cortex_thickness(const Options& options)
{
    if (options.tissue.layer == Layer::binary && options.tissue.lambda > 0.0)
    {
        const auto axes = semi_axes(options.geometry);
        return (1.0 - std::sqrt(options.tissue.lambda)) * *std::min_element(axes.begin(), axes.end());
    }
    return options.tissue.thickness_mm;
}

} // namespace

double estimated_memory(double particles, double neighbors)
{
    constexpr double bytes_per_pair = 8.0;
    constexpr double bytes_per_particle = 650.0;
    constexpr double base = 360e6; // the program and its picture library
    return base + particles * (bytes_per_particle + 2.0 * neighbors * bytes_per_pair);
}

Resolution resolve_resolution(const Options& options, double volume_mm3)
{
    const GeometryOptions& geometry = options.geometry;
    const double count = geometry.spacing_mm ? volume_mm3 / std::pow(*geometry.spacing_mm, 3)
                                             : static_cast<double>(geometry.particles.value_or(default_particles));
    const double spacing = std::cbrt(volume_mm3 / count);
    const std::string asked =
        geometry.spacing_mm ? fmt::format("geometry.spacing_mm = {:g}", *geometry.spacing_mm)
                            : fmt::format("geometry.particles = {}", geometry.particles.value_or(default_particles));
    if (!(count >= static_cast<double>(fewest_particles) && count <= static_cast<double>(most_particles)))
    {
        throw InputError(fmt::format(
            "{}: gives {:.0f} particles in {:.4g} mm³; expected {} to {} (spacing {:.4g} to {:.4g} mm)", asked, count,
            volume_mm3, fewest_particles, most_particles, std::cbrt(volume_mm3 / static_cast<double>(most_particles)),
            std::cbrt(volume_mm3 / static_cast<double>(fewest_particles))));
    }
    const double memory = estimated_memory(count, 4.0 / 3.0 * std::numbers::pi * std::pow(options.tlsph.support, 3));
    const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    if (memory > available)
    {
        throw InputError(fmt::format(
            "{}: gives {:.3g} particles, which need {:.1f} GiB; expected at most the {:.1f} GiB of this machine", asked,
            count, memory / 0x1p30, available / 0x1p30));
    }
    return {spacing, std::llround(count)};
}

Body prepare_body(const Options& options)
{
    Body body;
    TriangleMesh input;
    double volume = 0.0;
    if (options.geometry.shape == "file")
    {
        input = read_input_surface(options.geometry);
        body.report.input_vertices = std::ssize(input.vertices);
        volume = enclosed_volume(input.vertices, input.triangles);
    }
    else
    {
        volume = ellipsoid_volume(semi_axes(options.geometry));
    }
    const double spacing = resolve_resolution(options, volume).spacing_mm;
    body.surface = options.geometry.shape == "file"
                       ? remesh_isotropic(input, edge_per_spacing * spacing, &body.report.remesh)
                       : make_ellipsoid(semi_axes(options.geometry), edge_per_spacing * spacing);
    body.cloud = fill_surface(body.surface, {spacing, static_cast<std::uint64_t>(options.geometry.seed)});
    const SurfaceTree tree(body.surface.vertices, body.surface.triangles);
    set_tissue(options, tree, body);

    Neighbors pairs =
        find_neighbors(body.cloud, tree, options.tlsph.support * body.cloud.spacing, &body.report.visibility);
    body.report.neighbors_mean =
        static_cast<double>(pairs.index.size()) / static_cast<double>(body.cloud.positions.size());
    body.particles = make_particles(body.cloud, std::move(pairs), options.tlsph);
    const double thickness = cortex_thickness(options);
    if (thickness < 2.0 * body.cloud.spacing)
    {
        body.report.warnings.push_back(
            fmt::format("the cortex of {:.4g} mm is thinner than two spacings of {:.4g} mm and will fold at the wrong "
                        "wavelength; geometry.spacing_mm of at most {:.4g} is needed",
                        thickness, body.cloud.spacing, thickness / 2.0));
    }
    return body;
}

} // namespace corticle
