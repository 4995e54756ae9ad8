// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface_rows.hpp"

#include "corticle/metrics/surface_measures.hpp"

namespace corticle
{

std::vector<SurfaceRow> surface_rows(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    const SurfaceMeasures m = measure_surface(vertices, triangles);
    return {{"area_mm2", "mm2", m.area_mm2},
            {"volume_mm3", "mm3", m.volume_mm3},
            {"area_per_volume", "1/mm", m.area_per_volume},
            {"hull_area_mm2", "mm2", m.hull_area_mm2},
            {"gi_hull", "-", m.gi_hull},
            {"gi_sphere", "-", m.gi_sphere}};
}

} // namespace corticle
