// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/pattern_variation.hpp"

#include "corticle/mesh/sizes.hpp"
#include "corticle/metrics/fold_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::metrics
{

namespace
{

using Maps = std::vector<std::vector<double>>; ///< of the vertices, for each surface

double mean_of(const Maps& maps, std::size_t vertex)
{
    double sum = 0.0;
    for (const std::vector<double>& map : maps)
    {
        sum += map[vertex];
    }
    return sum / static_cast<double>(maps.size());
}

double deviation_of(const Maps& maps, std::size_t vertex)
{
    const double mean = mean_of(maps, vertex);
    double squares = 0.0;
    for (const std::vector<double>& map : maps)
    {
        squares += (map[vertex] - mean) * (map[vertex] - mean);
    }
    return std::sqrt(squares / static_cast<double>(maps.size() - 1));
}

template <class Value>
std::vector<double> at_vertices(std::size_t count, Value&& value)
{
    std::vector<double> values(count);
    for (std::size_t v = 0; v < count; ++v)
    {
        values[v] = value(v);
    }
    return values;
}

/// @param alike  of two maps
template <class Alike>
PatternAgreement agreement(const Maps& maps, Alike&& alike)
{
    PatternAgreement result{0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    double pairs = 0.0;
    for (std::size_t a = 0; a < maps.size(); ++a)
    {
        for (std::size_t b = a + 1; b < maps.size(); ++b)
        {
            const double one = alike(maps[a], maps[b]);
            result.mean += one;
            result.lowest = std::min(result.lowest, one);
            result.highest = std::max(result.highest, one);
            ++pairs;
        }
    }
    result.mean /= pairs;
    return result;
}

} // namespace

PatternVariation pattern_variation(const SurfaceView& first, std::span<const SurfaceView> surfaces)
{
    require_triangles(first.vertices, first.triangles);
    const std::size_t count = first.vertices.size();
    const std::vector<double> weights = vertex_areas(first.vertices, first.triangles);
    const FoldFeatures known = fold_features(first);
    Maps depth;
    Maps curvature;
    Maps depth_rest; // what the first body does not explain
    Maps curvature_rest;
    for (const SurfaceView& surface : surfaces)
    {
        require_size("vertices of a surface", surface.vertices.size(), count);
        FoldFeatures features = fold_features(surface);
        depth_rest.push_back(taken_out(features.depth, known.depth, weights));
        curvature_rest.push_back(taken_out(features.curvature, known.curvature, weights));
        depth.push_back(std::move(features.depth));
        curvature.push_back(std::move(features.curvature));
    }
    const auto correlated = [&](const auto& a, const auto& b) { return correlation(a, b, weights); };
    PatternVariation result;
    result.depth_mean = at_vertices(count, [&](std::size_t v) { return mean_of(depth, v); });
    result.depth_sd = at_vertices(count, [&](std::size_t v) { return deviation_of(depth, v); });
    result.curvature_mean = at_vertices(count, [&](std::size_t v) { return mean_of(curvature, v); });
    result.sulcal_share = at_vertices(count,
                                      [&](std::size_t v)
                                      {
                                          const auto concave = std::ranges::count_if(curvature, [v](const auto& map)
                                                                                     { return map[v] < 0.0; });
                                          return static_cast<double>(concave) / static_cast<double>(curvature.size());
                                      });
    result.depth = agreement(depth_rest, correlated);
    result.curvature = agreement(curvature_rest, correlated);
    result.dice = agreement(curvature, [&](const auto& a, const auto& b) { return sulcal_dice(a, b, weights); });
    return result;
}

} // namespace corticle::metrics
