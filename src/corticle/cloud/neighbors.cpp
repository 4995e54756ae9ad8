// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/neighbors.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/cloud/visibility.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>

namespace corticle::cloud
{

namespace
{

/// Keeps the entries of a list whose flag is set, for all rows.
Neighbors kept_entries(const Neighbors& all, std::span<const char> keep)
{
    const auto rows = static_cast<std::int64_t>(all.begin.size()) - 1;
    Neighbors kept;
    kept.begin.assign(all.begin.size(), 0);
    parallel_for(rows, [&](std::int64_t i)
                 { kept.begin[i + 1] = std::count(keep.begin() + all.begin[i], keep.begin() + all.begin[i + 1], 1); });
    for (std::int64_t i = 0; i < rows; ++i)
    {
        kept.begin[i + 1] += kept.begin[i];
    }
    kept.index.resize(static_cast<std::size_t>(kept.begin[rows]));
    parallel_for(rows,
                 [&](std::int64_t i)
                 {
                     std::int64_t to = kept.begin[i];
                     for (std::int64_t k = all.begin[i]; k < all.begin[i + 1]; ++k)
                     {
                         if (keep[k] != 0)
                         {
                             kept.index[to++] = all.index[k];
                         }
                     }
                 });
    return kept;
}

/// Position of neighbour j in the row of i; it must be there.
std::int64_t entry_of(const Neighbors& pairs, std::int64_t i, std::int32_t j)
{
    const auto first = pairs.index.begin() + pairs.begin[i];
    const auto last = pairs.index.begin() + pairs.begin[i + 1];
    return std::lower_bound(first, last, j) - pairs.index.begin();
}

} // namespace

Neighbors find_pairs_within(std::span<const Vec3> positions, double support)
{
    require_positive("support of the neighbours [mm]", support);
    return find_pairs_within(positions, std::vector<double>(positions.size(), support));
}

Neighbors find_pairs_within(std::span<const Vec3> positions, std::span<const double> supports)
{
    require_size("supports", supports.size(), positions.size());
    require_finite("positions", positions);
    Neighbors pairs;
    pairs.begin.assign(positions.size() + 1, 0);
    if (positions.empty())
    {
        return pairs;
    }
    const CellGrid grid(positions, *std::ranges::max_element(supports));
    const auto count = static_cast<std::int64_t>(positions.size());
    const auto each_neighbor = [&](std::int64_t i, auto&& visit)
    {
        const Vec3 x = positions[i];
        grid.near(x,
                  [&](std::int32_t j, const Vec3& p)
                  {
                      const double support = 0.5 * (supports[i] + supports[j]);
                      if (squared_norm(p - x) < support * support && j != i)
                      {
                          visit(j);
                      }
                  });
    };
    parallel_for(count, [&](std::int64_t i) { each_neighbor(i, [&](std::int32_t) { ++pairs.begin[i + 1]; }); });
    for (std::int64_t i = 0; i < count; ++i)
    {
        pairs.begin[i + 1] += pairs.begin[i];
    }
    pairs.index.resize(static_cast<std::size_t>(pairs.begin[count]));
    parallel_for(count,
                 [&](std::int64_t i)
                 {
                     std::int64_t to = pairs.begin[i];
                     each_neighbor(i, [&](std::int32_t j) { pairs.index[to++] = j; });
                     std::sort(pairs.index.begin() + pairs.begin[i], pairs.index.begin() + to);
                 });
    return pairs;
}

Neighbors find_neighbors(const Cloud& cloud, const geometry::SurfaceTree& surface, double support,
                         VisibilityReport* report)
{
    std::vector<double> supports(cloud.positions.size(), support);
    for (std::size_t i = 0; i < cloud.local_spacing.size(); ++i)
    {
        supports[i] = support / cloud.spacing * cloud.local_spacing[i];
    }
    require_positive("support of the neighbours [mm]", support);
    const Neighbors pairs = find_pairs_within(cloud.positions, supports);
    const Visibility visibility(cloud, surface, support / cloud.spacing * cloud.largest_spacing());
    const auto count = static_cast<std::int64_t>(cloud.positions.size());
    std::vector<char> keep(pairs.index.size(), 1);
    parallel_for(count,
                 [&](std::int64_t i)
                 {
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         const std::int32_t j = pairs.index[k];
                         if (j > i)
                         {
                             keep[k] = visibility.see_each_other(static_cast<std::int32_t>(i), j) ? 1 : 0;
                         }
                     }
                 });
    parallel_for(count,
                 [&](std::int64_t i)
                 {
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1] && pairs.index[k] < i; ++k)
                     {
                         keep[k] = keep[entry_of(pairs, pairs.index[k], static_cast<std::int32_t>(i))];
                     }
                 });
    Neighbors seen = kept_entries(pairs, keep);
    if (report != nullptr)
    {
        report->dropped_pairs = static_cast<std::int64_t>(pairs.index.size() - seen.index.size()) / 2;
    }
    return seen;
}

} // namespace corticle::cloud
