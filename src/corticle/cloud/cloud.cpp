// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/cloud.hpp"

namespace corticle
{

std::vector<double> surface_values(const Cloud& cloud, std::span<const double> values)
{
    std::vector<double> result;
    result.reserve(cloud.surface_particles.size());
    for (const std::int32_t particle : cloud.surface_particles)
    {
        result.push_back(values[static_cast<std::size_t>(particle)]);
    }
    return result;
}

} // namespace corticle
