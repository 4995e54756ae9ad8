// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/cloud.hpp"

#include <algorithm>

namespace corticle
{

double Cloud::largest_spacing() const
{
    return local_spacing.empty() ? spacing : *std::ranges::max_element(local_spacing);
}

std::vector<double> surface_values(const Cloud& cloud, std::span<const double> values, std::size_t components)
{
    std::vector<double> result;
    result.reserve(cloud.surface_particles.size() * components);
    for (const std::int32_t particle : cloud.surface_particles)
    {
        const auto first =
            values.begin() + static_cast<std::ptrdiff_t>(particle) * static_cast<std::ptrdiff_t>(components);
        result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(components));
    }
    return result;
}

} // namespace corticle
