// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis_choices.hpp"

#include "corticle/prepare/body_source.hpp"
#include "corticle/prepare/thesis/division_normals.hpp"
#include "corticle/prepare/thesis/ellipsoid.hpp"
#include "corticle/prepare/thesis/neighbor_count_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace corticle::prepare
{

void apply_thesis_volumes(const PreparationOptions& options, Cloud& cloud)
{
    if (options.geometry.volumes == VolumeRule::neighbour_count)
    {
        const double total = std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0);
        cloud.volumes = neighbor_count_volumes(cloud.positions, tlsph::support_mm(options.tlsph, cloud.spacing), total);
        cloud.centroids = cloud.positions;
    }
}

void apply_thesis_normals(const PreparationOptions& options, model::Model& model)
{
    const GeometryOptions& geometry = options.geometry;
    if (geometry.normals == NormalRule::divisions)
    {
        const std::vector<Vec3>& X = model.cloud.positions;
        model.tissue.normal = division_normals(X, triangle_normal_lines(model.surface),
                                               static_cast<std::int32_t>(geometry.normal_divisions), extents_centre(X));
    }
}

bool has_layer_by_lambda(const PreparationOptions& options)
{
    return options.tissue.layer == material::Layer::binary && options.tissue.lambda > 0.0;
}

std::vector<double> layer_by_lambda(const PreparationOptions& options, std::span<const Vec3> nodes,
                                    std::span<const Vec3> places, std::span<const double> volumes)
{
    const double lambda = options.tissue.lambda;
    if (options.geometry.shape == Shape::file || options.geometry.volumes == VolumeRule::neighbour_count)
    {
        // Volumes by neighbour counts are not those of the cells, so they say nothing about the volume of the layer.
        return ellipsoid_layer_by_centres(places, fitted_semi_axes(nodes), lambda, extents_centre(nodes));
    }
    return ellipsoid_layer(places, volumes, semi_axes(options.geometry), lambda);
}

double thickness_by_lambda(const PreparationOptions& options, const model::Model& model)
{
    const auto axes =
        options.geometry.shape == Shape::file ? fitted_semi_axes(model.cloud.positions) : semi_axes(options.geometry);
    return (1.0 - std::sqrt(options.tissue.lambda)) * *std::min_element(axes.begin(), axes.end());
}

} // namespace corticle::prepare
