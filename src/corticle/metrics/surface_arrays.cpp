// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface_arrays.hpp"

#include "corticle/metrics/cortical_thickness.hpp"
#include "corticle/metrics/surface/spectrum.hpp"
#include "corticle/metrics/surface/spherical_harmonics.hpp"

namespace corticle::metrics
{

namespace
{

constexpr int largest_degree = 30;
constexpr double roundness = 0.01;              ///< largest deviation of a sphere's radius, over the radius
constexpr double least_wave_per_spacing = 0.01; ///< amplitude below which a surface counts as flat

/// Where theta is 1/2 below each surface vertex, in the reference configuration [mm]: at the depth H(t)/s(t) along the
/// normal, or on the similar ellipsoid of eq. 24.
std::vector<Vec3> cortex_boundary(const model::Simulation& simulation)
{
    const model::Model& model = simulation.model();
    const material::TissueOptions& tissue = simulation.options().tissue;
    const double t = simulation.state().t;
    const bool similar = !model.tissue.given_theta.empty() && model.tissue.cortex_inside.empty();
    const double scale = model::cortex_size(simulation.options()).scale(t);
    std::vector<Vec3> boundary;
    boundary.reserve(model.surface.vertices.size());
    for (std::size_t v = 0; v < model.surface.vertices.size(); ++v)
    {
        const Vec3 X = model.surface.vertices[v];
        const auto particle = static_cast<std::size_t>(model.cloud.surface_particles[v]);
        const double thickness = material::thickness_at(model.tissue, tissue, particle, t) / scale;
        boundary.push_back(similar ? std::sqrt(tissue.lambda) * X : X - thickness * model.tissue.normal[particle]);
    }
    return boundary;
}

double mean_square_about_mean(std::span<const double> values, std::span<const double> areas)
{
    double area = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t v = 0; v < values.size(); ++v)
    {
        area += areas[v];
        sum += areas[v] * values[v];
        squares += areas[v] * values[v] * values[v];
    }
    return squares / area - (sum / area) * (sum / area);
}

/// Degree of the radial displacement about the middle of a spherical surface; 0 when it is not a sphere.
int dominant_degree_of(std::span<const Vec3> X, std::span<const Vec3> x, std::span<const double> areas)
{
    Vec3 centre;
    double area = 0.0;
    for (std::size_t v = 0; v < X.size(); ++v)
    {
        centre += areas[v] * X[v];
        area += areas[v];
    }
    centre = centre / area;
    const double radius = norm(X[0] - centre);
    std::vector<Vec3> directions;
    std::vector<double> displacement;
    for (std::size_t v = 0; v < X.size(); ++v)
    {
        if (std::abs(norm(X[v] - centre) - radius) > roundness * radius)
        {
            return 0;
        }
        directions.push_back(normalized(X[v] - centre));
        displacement.push_back(dot(x[v] - X[v], directions.back()));
    }
    return dominant_degree(power_by_degree(directions, displacement, areas, largest_degree));
}

} // namespace

FoldOptions fold_options(const model::OutputView& view)
{
    FoldOptions options;
    options.midplane = mid_sagittal_plane(model::scaled(view.model().surface.vertices, view.scale.length));
    return options;
}

SurfaceArrays surface_arrays(const model::OutputView& view)
{
    const Cloud& cloud = view.model().cloud;
    const CarriedCloud carried{cloud.positions, view.state().motion.x, *view.F, cloud.spacing};
    std::vector<Vec3> inner =
        model::scaled(carried_points(carried, cortex_boundary(view.simulation)), view.scale.length);
    const TriangleMesh& labelled = view.model().inner_surface;
    const double inner_area = labelled.vertices.empty()
                                  ? surface_area(inner, view.triangles())
                                  : surface_area(carried_points(carried, labelled.vertices), labelled.triangles) *
                                        std::pow(view.scale.length, 2);
    return {fold_fields(view.surface, view.triangles(), fold_options(view)),
            cortical_thickness(view.surface, inner, view.triangles()), std::move(inner), inner_area};
}

ReferenceFolds reference_folds(const model::OutputView& view)
{
    const model::Model& model = view.model();
    const std::vector<Vec3>& X = model.surface.vertices;
    const std::vector<Vec3>& x = view.as_folded;
    const std::vector<Vec3> normals = vertex_normals(X, model.surface.triangles);
    const std::vector<double> areas = vertex_areas(X, model.surface.triangles);
    std::vector<double> displacement(X.size());
    for (std::size_t v = 0; v < X.size(); ++v)
    {
        displacement[v] = dot(x[v] - X[v], normals[v]);
    }
    const double least = least_wave_per_spacing * model.cloud.spacing;
    if (mean_square_about_mean(displacement, areas) < least * least)
    {
        return {};
    }
    const auto spectrum = laplace_beltrami_spectrum(X, model.surface.triangles, displacement);
    return {dominant_wavelength(spectrum, fold_band(X, model.surface.triangles)),
            static_cast<double>(dominant_degree_of(X, x, areas))};
}

} // namespace corticle::metrics
