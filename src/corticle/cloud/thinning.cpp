// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/thinning.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/base/random.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/point_tree.hpp"
#include "corticle/mesh/sizes.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace corticle::cloud
{

namespace
{

void require_count(std::span<const Vec3> points, std::int64_t count)
{
    if (count < 1 || count > std::ssize(points))
    {
        throw InputError(fmt::format("thinning: got {} points to keep; expected 1 to {}, the points there are", count,
                                     points.size()));
    }
}

/// Volume that a point stands for, from the distance of its fourth neighbour [mm³]. A point on the surface has that
/// many at the same distance as one inside, so that it is not taken for a lonely one.
std::vector<double> local_volumes(std::span<const Vec3> points)
{
    constexpr std::size_t itself_and_four = 5;
    const PointTree tree(points);
    std::vector<double> volumes(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t i)
                 {
                     const auto nearest = tree.nearest_squared<itself_and_four>(points[i]);
                     const double distance = std::isfinite(nearest.back()) ? std::sqrt(nearest.back()) : 1.0;
                     volumes[i] = std::numbers::pi / 3.0 * distance * distance * distance;
                 });
    return volumes;
}

/// Probabilities min(1, c w_i), with c such that they sum to count.
std::vector<double> inclusion_probabilities(std::span<const double> weights, std::int64_t count)
{
    std::vector<double> ascending(weights.begin(), weights.end());
    std::sort(ascending.begin(), ascending.end());
    double rest = std::accumulate(ascending.begin(), ascending.end(), 0.0);
    auto left = static_cast<double>(count); // to be shared by those whose chance is below 1
    double scale = rest > 0.0 ? left / rest : 0.0;
    for (std::size_t k = ascending.size(); k > 0 && left > 0.0 && scale * ascending[k - 1] > 1.0; --k)
    {
        left -= 1.0;
        rest -= ascending[k - 1];
        scale = rest > 0.0 ? left / rest : 0.0;
    }
    std::vector<double> probabilities(weights.begin(), weights.end());
    for (double& p : probabilities)
    {
        p = std::min(1.0, scale * p);
    }
    return probabilities;
}

/// The points along a space-filling curve, shuffled within parts that are to hold some `kept_per_part` chosen ones.
std::vector<std::int32_t> shuffled_by_parts(std::span<const Vec3> points, std::int64_t count, std::uint64_t seed)
{
    constexpr std::size_t kept_per_part = 32;
    std::vector<std::int32_t> order = hilbert_order(points);
    const std::size_t part = kept_per_part * (points.size() / static_cast<std::size_t>(count) + 1);
    for (std::size_t begin = 0; begin < order.size(); begin += part)
    {
        const std::size_t end = std::min(begin + part, order.size());
        for (std::size_t k = end - 1; k > begin; --k) // Fisher & Yates
        {
            const auto other = begin + static_cast<std::size_t>(hash_bits(seed, k) % (k - begin + 1));
            std::swap(order[k], order[other]);
        }
    }
    return order;
}

/// A point in elimination: `crowding` is what it was when queued, no less than what it is.
struct Candidate
{
    double crowding;
    std::uint64_t chance;
    std::int32_t index;
    friend bool operator<(const Candidate& a, const Candidate& b)
    {
        return std::tie(a.crowding, a.chance, a.index) < std::tie(b.crowding, b.chance, b.index);
    }
};

/// Crowding of a pair at a distance: (1 - d / 2 r_max)^8, the same for all distances below 2 r_min (Yuksel 2015, eqs. 1
/// and 3, with alpha = 8, beta = 0.65, gamma = 1.5).
struct PairCrowding
{
    double r_max, r_min;

    PairCrowding(double volume, double points, double count)
        : r_max(std::cbrt(volume / (4.0 * std::numbers::sqrt2 * count))),
          r_min(0.65 * r_max * (1.0 - std::pow(count / points, 1.5)))
    {
    }
    double reach() const { return 2.0 * r_max; }
    double operator()(double squared_distance) const
    {
        const double d = std::max(std::sqrt(squared_distance), 2.0 * r_min);
        const double p = std::max(1.0 - d / reach(), 0.0);
        const double p2 = p * p;
        return p2 * p2 * p2 * p2;
    }
};

std::vector<double> crowding_of_all(std::span<const Vec3> points, std::span<const Vec3> fixed, const CellGrid& grid,
                                    const PairCrowding& pair)
{
    const CellGrid fixed_grid(fixed, pair.reach());
    std::vector<double> crowding(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t i)
                 {
                     double sum = 0.0;
                     grid.near(points[i], [&](std::int32_t j, const Vec3& p)
                               { sum += j == i ? 0.0 : pair(squared_norm(p - points[i])); });
                     fixed_grid.near(points[i],
                                     [&](std::int32_t, const Vec3& p) { sum += pair(squared_norm(p - points[i])); });
                     crowding[i] = sum;
                 });
    return crowding;
}

/// Weighted sample elimination (Yuksel 2015) of points that fill a volume [mm³] beside the fixed ones.
std::vector<std::int32_t> eliminate(std::span<const Vec3> fixed, std::span<const Vec3> points, double volume,
                                    std::int64_t count, std::uint64_t seed)
{
    const PairCrowding pair(volume, static_cast<double>(points.size()), static_cast<double>(count));
    const CellGrid grid(points, pair.reach());
    std::vector<double> crowding = crowding_of_all(points, fixed, grid, pair);

    std::priority_queue<Candidate> queue;
    const auto push = [&](std::int32_t i) {
        queue.push({crowding[i], hash_bits(seed, static_cast<std::uint64_t>(i)), i});
    };
    for (std::int32_t i = 0; i < std::ssize(points); ++i)
    {
        push(i);
    }
    std::vector<char> gone(points.size(), 0);
    for (std::int64_t left = std::ssize(points); left > count;)
    {
        const Candidate most = queue.top();
        queue.pop();
        if (most.crowding != crowding[most.index]) // neighbours went since it was queued
        {
            push(most.index);
            continue;
        }
        gone[most.index] = 1;
        --left;
        grid.near(points[most.index],
                  [&](std::int32_t j, const Vec3& p)
                  {
                      if (gone[j] == 0)
                      {
                          crowding[j] -= pair(squared_norm(p - points[most.index]));
                      }
                  });
    }
    std::vector<std::int32_t> kept;
    for (std::int32_t i = 0; i < std::ssize(points); ++i)
    {
        if (gone[i] == 0)
        {
            kept.push_back(i);
        }
    }
    return kept;
}

/// How many points elimination chooses from. Where there is more to choose from it packs what it keeps more tightly, so
/// the choice is to be equal everywhere: as many as can be had at an even density, from two to five times the count.
std::int64_t candidate_count(std::span<const double> volumes, std::int64_t count)
{
    std::vector<double> sorted(volumes.begin(), volumes.end());
    const auto large = sorted.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), large, sorted.end());
    const double total = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    const auto some = static_cast<double>(count);
    const double evenly = *large > 0.0 ? std::clamp(total / *large, 2.0 * some, 5.0 * some) : 5.0 * some;
    return std::min<std::int64_t>(std::ssize(volumes), std::llround(evenly));
}

} // namespace

std::vector<std::int32_t> thin_random(std::span<const Vec3> points, std::int64_t count, std::uint64_t seed)
{
    require_finite("points", points);
    return thin_random_by_volume(points, local_volumes(points), count, seed);
}

std::vector<std::int32_t> thin_random_by_volume(std::span<const Vec3> points, std::span<const double> volumes,
                                                std::int64_t count, std::uint64_t seed)
{
    require_count(points, count);
    require_size("volumes of the points", volumes.size(), points.size());
    require_finite("points", points);
    const std::vector<double> probability = inclusion_probabilities(volumes, count);
    // Systematic sampling: a point is taken where the running sum of probabilities passes u, u + 1, u + 2, ...
    double sum = 0.0;
    double next = hash_uniform(seed, points.size());
    std::vector<std::int32_t> kept;
    std::vector<std::int32_t> others;
    for (const std::int32_t i : shuffled_by_parts(points, count, seed))
    {
        sum += probability[i];
        const bool take = sum > next && std::ssize(kept) < count;
        next += take ? 1.0 : 0.0;
        (take ? kept : others).push_back(i);
    }
    for (; std::ssize(kept) < count; others.pop_back()) // what round-off left out
    {
        kept.push_back(others.back());
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

std::vector<std::int32_t> thin_uniform(std::span<const Vec3> points, std::int64_t count, std::uint64_t seed)
{
    require_finite("points", points);
    return thin_uniform_beside({}, points, local_volumes(points), count, seed);
}

std::vector<std::int32_t> thin_uniform_beside(std::span<const Vec3> fixed, std::span<const Vec3> points,
                                              std::span<const double> volumes, std::int64_t count, std::uint64_t seed)
{
    require_count(points, count);
    require_size("volumes of the points", volumes.size(), points.size());
    require_finite("fixed points", fixed);
    const std::vector<std::int32_t> candidates =
        thin_random_by_volume(points, volumes, candidate_count(volumes, count), seed);
    std::vector<Vec3> positions;
    positions.reserve(candidates.size());
    for (const std::int32_t i : candidates)
    {
        positions.push_back(points[i]);
    }
    const double volume = std::max(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1e-300);
    std::vector<std::int32_t> kept = eliminate(fixed, positions, volume, count, seed);
    for (std::int32_t& k : kept)
    {
        k = candidates[k];
    }
    return kept;
}

} // namespace corticle::cloud
