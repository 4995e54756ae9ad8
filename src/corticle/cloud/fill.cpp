// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/fill.hpp"

#include "corticle/base/error.hpp"
#include "corticle/cloud/cells.hpp"
#include "corticle/cloud/depth_profile.hpp"
#include "corticle/cloud/interior.hpp"
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::cloud
{

double spacing_for_particles(double volume, std::int64_t count)
{
    require_positive("volume to fill [mm³]", volume);
    require_positive("particles", static_cast<double>(count));
    return std::cbrt(volume / static_cast<double>(count));
}

Cloud fill_surface(const TriangleMesh& surface, const CloudOptions& options)
{
    require_triangles(surface);
    require_positive("spacing of the particles [mm]", options.spacing);
    const double volume = enclosed_volume(surface.vertices, surface.triangles);
    require_positive("volume of the surface to fill [mm³]", volume);
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    const double wanted = options.grading.is_uniform() ? volume / std::pow(options.spacing, 3.0)
                                                       : DepthProfile(tree).count(options.spacing, options.grading);
    constexpr double most = 1e9; // particle indices have 32 bits
    if (wanted > most)
    {
        throw InputError(fmt::format("spacing {} mm means {:.3g} particles; expected at most {:.3g}", options.spacing,
                                     wanted, most));
    }
    const auto surface_count = static_cast<std::int64_t>(surface.vertices.size());
    const std::int64_t inside_count = std::max<std::int64_t>(std::llround(wanted) - surface_count, 0);

    std::vector<Vec3> points = surface.vertices;
    const std::vector<Vec3> inside = scatter_inside(tree, inside_count, options);
    points.insert(points.end(), inside.begin(), inside.end());
    relax_inside(tree, options, points);
    const double largest = options.grading.is_uniform() ? options.spacing : options.grading.ratio * options.spacing;
    Cloud cloud =
        ordered_cloud(points, cells_of(surface, points, options.spacing, usual_lines_per_spacing, largest), surface);
    if (!options.grading.is_uniform())
    {
        cloud.spacing = options.spacing;
        cloud.local_spacing = local_spacings(tree, options, cloud.positions);
    }
    return cloud;
}

} // namespace corticle::cloud
