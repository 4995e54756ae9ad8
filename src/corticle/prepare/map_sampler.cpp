// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/map_sampler.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/formats/surfaces/surface_map.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace corticle::prepare
{

namespace
{

constexpr std::size_t most_listed = 20;

/// Least and greatest.
struct Extremes
{
    double low;
    double high;
};

Extremes extremes_of(std::span<const double> values)
{
    const auto [low, high] = std::ranges::minmax(values);
    return {low, high};
}

/// "7 (12 vertices), 9 (3 vertices)"
std::string listed(const std::map<double, std::int64_t>& labels)
{
    std::vector<std::string> entries;
    for (const auto& [label, count] : labels)
    {
        if (entries.size() == most_listed)
        {
            entries.emplace_back("...");
            break;
        }
        entries.push_back(fmt::format("{:.0f} ({} vertices)", label, count));
    }
    return fmt::format("{}", fmt::join(entries, ", "));
}

} // namespace

std::vector<double> MapSampler::numbers(const MapFile& map, const MapRange& range)
{
    const std::vector<double> values = at_vertices(map);
    const auto is_bad = [&](double value) { return range.is_open ? !(value > range.low) : !(value >= range.low); };
    const auto bad = std::ranges::find_if(values, is_bad);
    if (bad != values.end())
    {
        throw InputError(fmt::format("{} {}: holds {} at vertex {}; expected numbers {} {}", map.key, map.file, *bad,
                                     bad - values.begin(), range.is_open ? "above" : "of at least", range.low));
    }
    find_feet();
    std::vector<double> result;
    result.reserve(feet_.size());
    for (const geometry::SurfacePoint& foot : feet_)
    {
        const Triangle& corners = surface_.triangles[static_cast<std::size_t>(foot.triangle)];
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            sum += foot.barycentric[k] * values[static_cast<std::size_t>(corners[k])];
        }
        result.push_back(sum);
    }
    judge_numbers(map, values, result);
    return result;
}

void MapSampler::judge_numbers(const MapFile& map, std::span<const double> given, std::span<const double> carried)
{
    const Extremes file = extremes_of(given);
    const Extremes points = extremes_of(carried);
    notes.push_back(fmt::format("{}: {:.6g} to {:.6g} at {} vertices, {:.6g} to {:.6g} at {} points of the body",
                                map.key, file.low, file.high, given.size(), points.low, points.high, carried.size()));
    constexpr double much = 0.2; // of the spread
    const double lost = std::max(file.high - points.high, points.low - file.low);
    if (lost > much * (file.high - file.low))
    {
        warnings.push_back(fmt::format("{}: its extremes fall between the points of the body ({:.6g} to {:.6g} becomes "
                                       "{:.6g} to {:.6g}): the map is finer than the particles",
                                       map.key, file.low, file.high, points.low, points.high));
    }
}

std::vector<double> MapSampler::labels(const MapFile& map)
{
    const bool is_volume =
        formats::is_volume(map.file) && !formats::is_vertex_image(map.file, std::ssize(surface_.vertices));
    return is_volume ? in_volume(map) : labels_of_vertices(map);
}

std::vector<double> MapSampler::labels_of_vertices(const MapFile& map)
{
    std::vector<double> values = at_vertices(map);
    for (std::size_t k = 0; k < values.size(); ++k)
    {
        if (!imaging::is_whole_label(values[k], values[k]))
        {
            throw InputError(fmt::format("{} {}: vertex {} has {:.9g}; expected a whole number, a label", map.key,
                                         map.file, k, values[k]));
        }
        values[k] = std::nearbyint(values[k]);
    }
    find_feet();
    std::vector<double> result;
    result.reserve(feet_.size());
    for (const geometry::SurfacePoint& foot : feet_)
    {
        const Triangle& corners = surface_.triangles[static_cast<std::size_t>(foot.triangle)];
        const auto nearest = std::ranges::max_element(foot.barycentric) - foot.barycentric.begin();
        result.push_back(values[static_cast<std::size_t>(corners[static_cast<std::size_t>(nearest)])]);
    }
    judge_labels(map, values, result);
    return result;
}

void MapSampler::judge_labels(const MapFile& map, std::span<const double> given, std::span<const double> carried)
{
    std::map<double, std::int64_t> lost;
    for (const double label : given)
    {
        ++lost[label];
    }
    const std::size_t there = lost.size();
    for (const double label : carried)
    {
        lost.erase(label);
    }
    if (!lost.empty())
    {
        warnings.push_back(fmt::format("{}: {} of its {} labels fall between the points of the body and are lost: {}",
                                       map.key, lost.size(), there, listed(lost)));
    }
}

std::vector<double> MapSampler::at_vertices(const MapFile& map) const
{
    if (surface_.vertices.empty())
    {
        throw InputError(
            fmt::format("{} {}: gives numbers at the vertices of a surface, but the body is not made from "
                        "a surface file; expected a label volume (NIfTI, MGH), or geometry.file = a surface",
                        map.key, map.file));
    }
    return formats::read_surface_map(map.file, map.array, std::ssize(surface_.vertices));
}

void MapSampler::find_feet()
{
    if (!feet_.empty())
    {
        return;
    }
    const geometry::SurfaceTree tree(surface_.vertices, surface_.triangles);
    feet_.resize(positions_.size());
    parallel_for(std::ssize(positions_),
                 [&](std::int64_t i)
                 {
                     const auto k = static_cast<std::size_t>(i);
                     feet_[k] = tree.closest(positions_[k]);
                 });
}

/// The label of the voxel each point lies in; 0 outside the volume.
std::vector<double> MapSampler::in_volume(const MapFile& map)
{
    const imaging::LabelVolume volume = formats::read_labels(map.file);
    for (const std::string& note : volume.notes)
    {
        notes.push_back(fmt::format("{}: {}", map.key, note));
    }
    const Mat3 to_index = inverse(volume.frame.linear);
    std::vector<double> result;
    result.reserve(positions_.size());
    std::size_t outside = 0;
    for (const Vec3& X : positions_)
    {
        const Vec3 index = to_index * (X - volume.frame.origin);
        std::int64_t at = 0;
        bool is_inside = true;
        for (int axis = 2; axis >= 0; --axis)
        {
            const auto size = volume.size[static_cast<std::size_t>(axis)];
            const double k = std::round(index[axis]);
            is_inside = is_inside && k >= 0.0 && k < static_cast<double>(size);
            at = is_inside ? at * size + static_cast<std::int64_t>(k) : 0;
        }
        outside += is_inside ? 0 : 1;
        result.push_back(is_inside ? volume.labels[static_cast<std::size_t>(at)] : 0.0);
    }
    if (outside == positions_.size())
    {
        throw InputError(fmt::format("{} {}: no point of the body lies in this volume; expected one in the same "
                                     "coordinates as the body",
                                     map.key, map.file));
    }
    const auto background = static_cast<std::size_t>(std::ranges::count(result, 0.0));
    notes.push_back(
        fmt::format("{}: {} of {} points of the body have label 0", map.key, background, positions_.size()));
    if (outside > 0)
    {
        warnings.push_back(fmt::format("{}: {} of {} points of the body lie outside this volume and have label 0",
                                       map.key, outside, positions_.size()));
    }
    return result;
}

} // namespace corticle::prepare
