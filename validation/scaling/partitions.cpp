// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/random.hpp"
#include "corticle/mesh/cell_grid.hpp"
#include "corticle/mesh/halo.hpp"
#include "corticle/mesh/space_filling_curve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

// Counts what ranks own, read of each other and send, on a body of the size that is asked for: points of a jittered
// lattice within it, along the same curve and with the same supports as a prepared body. Nothing is simulated.

namespace
{

using namespace corticle;

constexpr double support = 2.3;           // spacings: as of solver.support
constexpr double jitter = 0.3;            // spacings
constexpr double of_quadratic_fit = 70.0; // pairs: as tlsph::block_costs has it

/// Distance to the surface from inside, about: exact for the sphere. Spacings of a body of unit size.
double depth_in_sphere(const Vec3& p)
{
    return 1.0 - norm(p);
}

/// Two hemispheres, ellipsoids of 1 : 0.8 : 0.75 beside a fissure, joined below it.
double depth_in_brain(const Vec3& p)
{
    const Vec3 scaled{p.x, p.y / 0.8, p.z / 0.75};
    const double to_ellipsoid = (1.0 - norm(scaled)) * 0.8;
    const double to_fissure = p.z > -0.15 ? std::abs(p.y) - 0.01 : std::hypot(p.y, p.z + 0.15) - 0.01;
    return std::min(to_ellipsoid, to_fissure);
}

struct Cloud
{
    std::vector<Vec3> points; ///< in spacings
    std::vector<float> depth; ///< in spacings
};

template <class Depth>
Cloud make_cloud(std::int64_t particles, Depth&& depth)
{
    constexpr std::int64_t probes = 128; // a side
    std::int64_t inside = 0;
    for (std::int64_t k = 0; k < probes * probes * probes; ++k)
    {
        const auto at = [&](std::int64_t c) { return (2.0 * static_cast<double>(c) + 1.0) / probes - 1.0; };
        inside += depth({at(k % probes), at(k / probes % probes), at(k / (probes * probes))}) > 0.0 ? 1 : 0;
    }
    const double share = static_cast<double>(inside) / static_cast<double>(probes * probes * probes);
    const double spacing = 2.0 * std::cbrt(share / static_cast<double>(particles));
    const auto side = static_cast<std::int64_t>(std::ceil(2.0 / spacing));
    std::vector<Vec3> points;
    std::vector<float> depths;
    for (std::int64_t k = 0; k < side * side * side; ++k)
    {
        const auto at = [&](int axis, std::int64_t c)
        {
            const double moved = hash_uniform(static_cast<std::uint64_t>(axis), static_cast<std::uint64_t>(k));
            return (static_cast<double>(c) + 0.5 + jitter * (2.0 * moved - 1.0)) * spacing - 1.0;
        };
        const Vec3 p{at(0, k % side), at(1, k / side % side), at(2, k / (side * side))};
        if (const double d = depth(p); d > 0.0)
        {
            points.push_back((1.0 / spacing) * p);
            depths.push_back(static_cast<float>(d / spacing));
        }
    }
    const std::vector<std::int32_t> order = hilbert_order(points);
    Cloud cloud;
    for (const std::int32_t k : order)
    {
        cloud.points.push_back(points[static_cast<std::size_t>(k)]);
        cloud.depth.push_back(depths[static_cast<std::size_t>(k)]);
    }
    return cloud;
}

/// Particles on the surface: one for each square of spacings, as on a prepared body.
bool is_surface(float depth)
{
    return depth < 1.0f;
}
/// Those with a quadratic fit: as many as on the standard sphere, 34 % of 45,000 and 22 % of 200,000.
bool is_enriched(float depth)
{
    return depth < 2.87f;
}

/// One line of a JSON list for every rank.
void print_ranks(const Cloud& cloud, const CellGrid& grid, std::span<const double> costs, int ranks)
{
    const auto each_neighbor = [&](std::int64_t i, auto&& act)
    {
        const Vec3& at = cloud.points[static_cast<std::size_t>(i)];
        grid.near(at,
                  [&](std::int32_t j, const Vec3& p)
                  {
                      if (j != i && squared_norm(p - at) < support * support)
                      {
                          act(j);
                      }
                  });
    };
    const Partition partition = make_partition(std::ssize(cloud.points), costs, ranks);
    std::vector<std::string> lines(static_cast<std::size_t>(ranks));
    parallel_blocks(
        ranks,
        [&](std::int64_t k, std::int64_t)
        {
            const int rank = static_cast<int>(k);
            const auto halo = find_halo(partition, rank, each_neighbor);
            const std::int64_t begin = partition.begin(rank);
            const std::int64_t end = partition.end(rank);
            std::int64_t ghosts = 0;
            std::int64_t bytes = 0;
            std::int64_t surface = 0;
            std::int64_t inner_blocks = 0;
            double cost = 0.0;
            std::vector<std::uint8_t> is_outer(static_cast<std::size_t>(block_count(end - begin, partition_block)));
            for (const HaloPart& part : halo)
            {
                for (const std::int32_t j : part.ghosts)
                {
                    ++ghosts;
                    bytes += 24 + (is_enriched(cloud.depth[static_cast<std::size_t>(j)]) ? 224 : 80);
                }
                for (const std::int32_t i : part.ours)
                {
                    is_outer[static_cast<std::size_t>((i - begin) / partition_block)] = 1;
                }
            }
            for (std::int64_t i = begin; i < end; ++i)
            {
                surface += is_surface(cloud.depth[static_cast<std::size_t>(i)]) ? 1 : 0;
            }
            for (std::int64_t block = 0; block < std::ssize(is_outer); ++block)
            {
                inner_blocks += is_outer[static_cast<std::size_t>(block)] == 0 ? 1 : 0;
                cost += costs[static_cast<std::size_t>(begin / partition_block + block)];
            }
            lines[static_cast<std::size_t>(k)] = fmt::format(
                R"({{"owned": {}, "ghosts": {}, "neighbours": {}, "bytes": {}, "surface": {}, "blocks": {}, "inner_blocks": {}, "cost": {:.0f}}})",
                end - begin, ghosts, halo.size(), bytes, surface, is_outer.size(), inner_blocks, cost);
        },
        1);
    fmt::print("{}", fmt::join(lines, ",\n  "));
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4)
    {
        fmt::print(stderr, "usage: corticle_partitions sphere|brain PARTICLES RANKS...\n");
        return 2;
    }
    const std::string shape = argv[1];
    const std::int64_t particles = std::atoll(argv[2]);
    const Cloud cloud = shape == "brain" ? make_cloud(particles, depth_in_brain) : make_cloud(particles, depth_in_sphere);
    const CellGrid grid(cloud.points, support);
    std::vector<double> cost_of(cloud.points.size());
    parallel_for(std::ssize(cloud.points),
                 [&](std::int64_t i)
                 {
                     const Vec3& at = cloud.points[static_cast<std::size_t>(i)];
                     double pairs = -1.0; // not with itself
                     grid.near(at, [&](std::int32_t, const Vec3& p)
                               { pairs += squared_norm(p - at) < support * support ? 1.0 : 0.0; });
                     cost_of[i] = pairs + (is_enriched(cloud.depth[i]) ? of_quadratic_fit : 0.0);
                 });
    std::vector<double> costs;
    for (std::int64_t begin = 0; begin < std::ssize(cost_of); begin += partition_block)
    {
        const std::int64_t end = std::min(begin + partition_block, std::ssize(cost_of));
        costs.push_back(std::accumulate(cost_of.begin() + begin, cost_of.begin() + end, 0.0));
    }
    fmt::print("{{\"shape\": \"{}\", \"particles\": {}, \"ranks\": {{", shape, cloud.points.size());
    for (int k = 3; k < argc; ++k)
    {
        fmt::print("{}\n \"{}\": [", k > 3 ? "," : "", argv[k]);
        print_ranks(cloud, grid, costs, std::atoi(argv[k]));
        fmt::print("]");
    }
    fmt::print("}}}}\n");
    return 0;
}
