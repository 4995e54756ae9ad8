// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/sulcal_pits.hpp"

#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <algorithm>
#include <numeric>

namespace corticle::metrics
{

namespace
{

/// Basins as sets of vertices with their maximum as representative.
class Basins
{
  public:
    explicit Basins(std::size_t vertices) : parent_(vertices, none) {}

    bool is_flooded(std::int32_t v) const { return parent_[v] != none; }
    void open(std::int32_t v) { parent_[v] = v; }
    void join(std::int32_t lower, std::int32_t higher) { parent_[lower] = higher; }
    std::int32_t maximum(std::int32_t v)
    {
        while (parent_[v] != v)
        {
            parent_[v] = parent_[parent_[v]];
            v = parent_[v];
        }
        return v;
    }

  private:
    static constexpr std::int32_t none = -1;
    std::vector<std::int32_t> parent_;
};

} // namespace

std::vector<std::int32_t> prominent_maxima(std::span<const double> values, std::span<const Triangle> triangles,
                                           double prominence)
{
    const VertexLists adjacent = adjacent_vertices(values.size(), triangles);
    std::vector<std::int32_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::int32_t> rank(values.size());
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return values[a] > values[b]; });
    for (std::size_t k = 0; k < order.size(); ++k)
    {
        rank[order[k]] = static_cast<std::int32_t>(k);
    }
    Basins basins(values.size());
    std::vector<double> lowest(values.begin(),
                               values.end()); // value at which a maximum ends: its saddle, or its part's
    for (const std::int32_t v : order)
    {
        basins.open(v);
        for (const std::int32_t near : adjacent.of(v))
        {
            if (!basins.is_flooded(near))
            {
                continue;
            }
            const std::int32_t a = basins.maximum(v);
            const std::int32_t b = basins.maximum(near);
            if (a != b)
            {
                const auto [higher, lower] = rank[a] < rank[b] ? std::pair{a, b} : std::pair{b, a};
                lowest[lower] = values[v];
                basins.join(lower, higher);
            }
        }
        const std::int32_t top = basins.maximum(v);
        lowest[top] = values[v];
    }
    std::vector<std::int32_t> maxima;
    std::copy_if(order.begin(), order.end(), std::back_inserter(maxima),
                 [&](std::int32_t v) { return values[v] - lowest[v] >= prominence; });
    return maxima;
}

DepthExtrema depth_extrema(std::span<const double> sulcal_depth, std::span<const Triangle> triangles,
                           double ridge_height)
{
    std::vector<double> height(sulcal_depth.size());
    std::transform(sulcal_depth.begin(), sulcal_depth.end(), height.begin(), std::negate<>{});
    return {prominent_maxima(sulcal_depth, triangles, ridge_height), prominent_maxima(height, triangles, ridge_height)};
}

} // namespace corticle::metrics
