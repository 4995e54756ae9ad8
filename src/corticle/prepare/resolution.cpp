// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/cloud/from_tets.hpp"
#include "corticle/geometry/tetrahedralize.hpp"
#include "corticle/prepare/prepare.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle::prepare
{

double estimated_memory(model::Method method, double particles, double neighbors)
{
    constexpr double bytes_per_pair = 6.0;
    constexpr double bytes_per_particle = 960.0; // at an output time, when it takes the most
    constexpr double bytes_per_tet = 240.0;
    constexpr double tets_per_node = 6.0;
    constexpr double base = 360e6; // the program and its picture library
    const double links = method == model::Method::fem ? tets_per_node * bytes_per_tet : neighbors * bytes_per_pair;
    return base + particles * (bytes_per_particle + links);
}

Resolution resolve_resolution(const PreparationOptions& options, double volume_mm3, double area_mm2,
                              const cloud::DepthProfile* profile, const cloud::Grading& grading)
{
    const GeometryOptions& geometry = options.geometry;
    const double count = geometry.spacing_mm ? (profile != nullptr ? profile->count(*geometry.spacing_mm, grading)
                                                                   : volume_mm3 / std::pow(*geometry.spacing_mm, 3))
                         : options.elements  ? static_cast<double>(geometry::nodes_for_tets(
                                                   *options.elements, volume_mm3, area_mm2, cloud::edge_per_spacing))
                                             : static_cast<double>(geometry.particles.value_or(default_particles));
    const double spacing = profile != nullptr ? profile->spacing_for(count, grading) : std::cbrt(volume_mm3 / count);
    const std::string asked =
        geometry.spacing_mm ? fmt::format("geometry.spacing_mm = {:g}", *geometry.spacing_mm)
        : options.elements  ? fmt::format("solver.elements = {}", *options.elements)
                            : fmt::format("geometry.particles = {}", geometry.particles.value_or(default_particles));
    if (!(count >= static_cast<double>(fewest_particles) && count <= static_cast<double>(most_particles)))
    {
        throw InputError(fmt::format(
            "{}: gives {:.0f} particles in {:.4g} mm³; expected {} to {} (spacing {:.4g} to {:.4g} mm)", asked, count,
            volume_mm3, fewest_particles, most_particles, std::cbrt(volume_mm3 / static_cast<double>(most_particles)),
            std::cbrt(volume_mm3 / static_cast<double>(fewest_particles))));
    }
    const double memory = estimated_memory(options.method, count,
                                           4.0 / 3.0 * std::numbers::pi *
                                               std::pow(tlsph::support_mm(options.tlsph, spacing) / spacing, 3));
    const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    if (memory > available)
    {
        throw InputError(fmt::format(
            "{}: gives {:.3g} particles, which need {:.1f} GiB; expected at most the {:.1f} GiB of this machine", asked,
            count, memory / 0x1p30, available / 0x1p30));
    }
    return {spacing, std::llround(count)};
}

} // namespace corticle::prepare
