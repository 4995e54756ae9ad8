// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/region_areas.hpp"

#include "corticle/mesh/sizes.hpp"

#include <cmath>
#include <vector>

namespace corticle::metrics
{

std::map<std::int64_t, double> region_areas(const SurfaceView& surface, std::span<const double> labels)
{
    require_triangles(surface.vertices, surface.triangles);
    require_size("labels of the vertices", labels.size(), surface.vertices.size());
    const std::vector<double> areas = vertex_areas(surface.vertices, surface.triangles);
    std::map<std::int64_t, double> result;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
        result[std::llround(labels[v])] += areas[v];
    }
    return result;
}

} // namespace corticle::metrics
