// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/regularity.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/tlsph/kernel.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/point_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace corticle::study
{

namespace
{

struct Moments
{
    double mean = 0.0;
    double variation = 0.0; ///< standard deviation over mean
};

Moments moments(std::span<const double> values)
{
    if (values.empty())
    {
        return {};
    }
    const auto count = static_cast<double>(values.size());
    const double mean = parallel_sum(std::ssize(values), [&](std::int64_t i) { return values[i]; }) / count;
    const double squares =
        parallel_sum(std::ssize(values), [&](std::int64_t i) { return (values[i] - mean) * (values[i] - mean); });
    return {mean, mean > 0.0 ? std::sqrt(squares / count) / mean : 0.0};
}

struct Neighborhoods
{
    std::vector<double> count;     ///< neighbours within the support
    std::vector<double> condition; ///< of the shape matrix
};

Neighborhoods neighborhoods(std::span<const Vec3> positions, double support)
{
    const CellGrid grid(positions, support);
    Neighborhoods found{std::vector<double>(positions.size()), std::vector<double>(positions.size())};
    parallel_for(std::ssize(positions),
                 [&](std::int64_t i)
                 {
                     Mat3 shape;
                     double count = -1.0; // not itself
                     grid.near(positions[i],
                               [&](std::int32_t, const Vec3& p)
                               {
                                   const Vec3 X_ij = p - positions[i];
                                   const double distance = norm(X_ij);
                                   count += distance < support ? 1.0 : 0.0;
                                   shape += tlsph::pair_weight(distance, support) * outer(X_ij, X_ij);
                               });
                     found.count[i] = count;
                     found.condition[i] = tlsph::condition_number(shape);
                 });
    return found;
}

std::vector<double> nearest_distances(std::span<const Vec3> positions)
{
    const PointTree tree(positions);
    std::vector<double> distances(positions.size());
    parallel_for(std::ssize(positions),
                 [&](std::int64_t i) { distances[i] = std::sqrt(tree.nearest_squared<2>(positions[i])[1]); });
    return distances;
}

} // namespace

Regularity measure_regularity(std::span<const Vec3> positions, std::span<const double> depths, double spacing,
                              double support)
{
    assert(positions.size() > 1 && depths.size() == positions.size());
    const std::vector<double> nearest = nearest_distances(positions);
    const Neighborhoods near = neighborhoods(positions, support);
    std::vector<double> deep_counts;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        if (depths[i] > support)
        {
            deep_counts.push_back(near.count[i]);
        }
    }
    const Moments distance = moments(nearest);
    Regularity regularity;
    regularity.particles = std::ssize(positions);
    regularity.closest_pair = *std::min_element(nearest.begin(), nearest.end()) / spacing;
    regularity.nearest_mean = distance.mean / spacing;
    regularity.nearest_variation = distance.variation;
    regularity.neighbors_variation = moments(deep_counts).variation;
    regularity.fewest_neighbors = std::llround(*std::min_element(near.count.begin(), near.count.end()));
    regularity.worst_condition = *std::max_element(near.condition.begin(), near.condition.end());
    regularity.ill_conditioned =
        std::count_if(near.condition.begin(), near.condition.end(),
                      [](double condition) { return !(condition <= tlsph::largest_condition); });
    return regularity;
}

} // namespace corticle::study
