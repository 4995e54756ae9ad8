// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/ordered_cloud.hpp"

#include "corticle/mesh/sizes.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::cloud
{

Cloud ordered_cloud(std::span<const Vec3> points, const Cells& cells, const TriangleMesh& surface,
                    std::vector<std::int32_t>* particle_of)
{
    require_size("volumes of the points", cells.volumes.size(), points.size());
    require_size("centroids of the cells", cells.centroids.size(), points.size());
    require_finite("points", points);
    require_triangles(points.first(std::min(points.size(), surface.vertices.size())), surface.triangles);
    Cloud cloud;
    const std::vector<std::int32_t> order = hilbert_order(points);
    cloud.surface_particles.resize(surface.vertices.size());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
        cloud.positions.push_back(points[order[k]]);
        cloud.volumes.push_back(cells.volumes[order[k]]);
        cloud.centroids.push_back(cells.centroids[order[k]]);
        if (static_cast<std::size_t>(order[k]) < surface.vertices.size())
        {
            cloud.surface_particles[order[k]] = static_cast<std::int32_t>(k);
        }
    }
    if (particle_of != nullptr)
    {
        particle_of->resize(order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
        {
            (*particle_of)[order[k]] = static_cast<std::int32_t>(k);
        }
    }
    cloud.surface_triangles = surface.triangles;
    const double volume = enclosed_volume(surface.vertices, surface.triangles);
    cloud.spacing = std::cbrt(volume / static_cast<double>(points.size()));
    return cloud;
}

} // namespace corticle::cloud
