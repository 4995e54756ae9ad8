// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/neighbor_count_volumes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::prepare
{

namespace
{

/// Number of other points within the radius, of each point.
std::vector<std::int64_t> neighbor_counts(std::span<const Vec3> positions, double radius)
{
    const CellGrid grid(positions, radius);
    std::vector<std::int64_t> counts(positions.size());
    parallel_for(std::ssize(positions),
                 [&](std::int64_t i)
                 {
                     std::int64_t found = -1; // not itself
                     grid.near(positions[i], [&](std::int32_t, const Vec3& p)
                               { found += squared_norm(p - positions[i]) < radius * radius ? 1 : 0; });
                     counts[i] = found;
                 });
    return counts;
}

} // namespace

std::vector<double> neighbor_count_volumes(std::span<const Vec3> positions, double radius, double total_volume)
{
    if (!(radius > 0.0) || !(total_volume > 0.0))
    {
        throw InputError(
            fmt::format("volumes by neighbour counts: radius {} mm, total volume {} mm³; expected positive numbers",
                        radius, total_volume));
    }
    const std::vector<std::int64_t> counts = neighbor_counts(positions, radius);
    const auto alone = std::find(counts.begin(), counts.end(), 0);
    if (alone != counts.end())
    {
        const Vec3& X = positions[alone - counts.begin()];
        throw InputError(fmt::format("volumes by neighbour counts: particle {} at ({:.4g}, {:.4g}, {:.4g}) mm has no "
                                     "neighbour within {} mm; expected at least one: use a larger radius",
                                     alone - counts.begin(), X.x, X.y, X.z, radius));
    }
    const double inverse_sum =
        parallel_sum(std::ssize(counts), [&](std::int64_t i) { return 1.0 / static_cast<double>(counts[i]); });
    std::vector<double> volumes;
    volumes.reserve(counts.size());
    for (const std::int64_t count : counts)
    {
        volumes.push_back(total_volume / inverse_sum / static_cast<double>(count));
    }
    return volumes;
}

} // namespace corticle::prepare
