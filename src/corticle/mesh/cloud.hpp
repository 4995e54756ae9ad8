// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle
{

/// Particles on and inside a closed surface, in the reference configuration, ordered along a space-filling curve.
struct Cloud
{
    std::vector<Vec3> positions;                 ///< X [mm], one per particle
    std::vector<double> volumes;                 ///< V [mm³], one per particle; their sum is the enclosed volume
    std::vector<Vec3> centroids;                 ///< of the cells that the volumes are of [mm], one per particle
    std::vector<std::int32_t> surface_particles; ///< particle that sits on each vertex of the surface
    std::vector<Triangle> surface_triangles;     ///< vertices of each triangle, indices into surface_particles
    double spacing = 0.0;                        ///< mean distance between adjacent particles, at the surface [mm]
    std::vector<double> local_spacing;           ///< about every particle [mm]; empty: everywhere that of the surface

    /// Spacing about a particle [mm].
    double spacing_at(std::size_t particle) const { return local_spacing.empty() ? spacing : local_spacing[particle]; }
    /// The largest of them [mm].
    double largest_spacing() const;
};

/// The values of the particles on the surface, `components` each, in the order of its vertices.
std::vector<double> surface_values(const Cloud& cloud, std::span<const double> values, std::size_t components = 1);

} // namespace corticle
