// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/body_maps.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/io/label_table.hpp"
#include "corticle/io/nifti.hpp"
#include "corticle/io/surface_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace corticle
{

namespace
{

/// A map file and which array of it is meant.
struct MapFile
{
    const char* key; ///< for messages
    const std::string& file;
    const std::string& array;
};

/// The values of maps at material points.
class MapSampler
{
  public:
    MapSampler(const TriangleMesh& surface, std::span<const Vec3> positions) : surface_(surface), positions_(positions)
    {
    }

    /// Interpolated numbers.
    std::vector<double> numbers(const MapFile& map)
    {
        const std::vector<double> values = at_vertices(map);
        return at_points(
            [&](const SurfacePoint& foot)
            {
                const Triangle& corners = surface_.triangles[static_cast<std::size_t>(foot.triangle)];
                double sum = 0.0;
                for (std::size_t k = 0; k < 3; ++k)
                {
                    sum += foot.barycentric[k] * values[static_cast<std::size_t>(corners[k])];
                }
                return sum;
            });
    }

    /// Labels, which are not interpolated.
    std::vector<double> labels(const MapFile& map)
    {
        if (is_nifti(map.file))
        {
            return in_volume(map);
        }
        const std::vector<double> values = at_vertices(map);
        for (std::size_t k = 0; k < values.size(); ++k)
        {
            if (values[k] != std::round(values[k]))
            {
                throw InputError(fmt::format("{} {}: vertex {} has {}; expected a whole number, a label", map.key,
                                             map.file, k, values[k]));
            }
        }
        return at_points(
            [&](const SurfacePoint& foot)
            {
                const Triangle& corners = surface_.triangles[static_cast<std::size_t>(foot.triangle)];
                const auto nearest = std::max_element(foot.barycentric.begin(), foot.barycentric.end());
                return values[static_cast<std::size_t>(
                    corners[static_cast<std::size_t>(nearest - foot.barycentric.begin())])];
            });
    }

  private:
    std::vector<double> at_vertices(const MapFile& map) const
    {
        if (surface_.vertices.empty())
        {
            throw InputError(
                fmt::format("{} {}: gives numbers at the vertices of a surface, but the body is not made from "
                            "a surface file; expected a NIfTI label volume, or geometry.file = a surface",
                            map.key, map.file));
        }
        return read_surface_map(map.file, map.array, std::ssize(surface_.vertices));
    }

    /// value(foot) for the foot of every point on the surface.
    template <class Value>
    std::vector<double> at_points(Value&& value)
    {
        if (feet_.empty())
        {
            const SurfaceTree tree(surface_.vertices, surface_.triangles);
            feet_.resize(positions_.size());
            parallel_for(std::ssize(positions_),
                         [&](std::int64_t i)
                         {
                             const auto k = static_cast<std::size_t>(i);
                             feet_[k] = tree.closest(positions_[k]);
                         });
        }
        std::vector<double> result;
        result.reserve(feet_.size());
        for (const SurfacePoint& foot : feet_)
        {
            result.push_back(value(foot));
        }
        return result;
    }

    /// The label of the voxel each point lies in; 0 outside the volume.
    std::vector<double> in_volume(const MapFile& map) const
    {
        const LabelVolume volume = read_nifti(map.file, std::nullopt);
        const Mat3 to_index = inverse(volume.frame.linear);
        std::vector<double> result;
        result.reserve(positions_.size());
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
            result.push_back(is_inside ? volume.labels[static_cast<std::size_t>(at)] : 0.0);
        }
        return result;
    }

    const TriangleMesh& surface_;
    std::span<const Vec3> positions_;
    std::vector<SurfacePoint> feet_; ///< found when first needed
};

/// Refuses values that are not above `low` (or at it, where that is allowed).
void require_above(const MapFile& map, std::span<const double> values, double low, bool is_open)
{
    const auto bad = std::find_if(values.begin(), values.end(),
                                  [&](double value) { return is_open ? !(value > low) : !(value >= low); });
    if (bad != values.end())
    {
        throw InputError(fmt::format("{} {}: holds {}; expected numbers {} {}", map.key, map.file, *bad,
                                     is_open ? "above" : "of at least", low));
    }
}

/// A column of the region table and what its numbers may be.
struct RegionColumn
{
    const char* name;
    double least;
    double most;
    bool is_needed;
};

/// The number of the region that each point is in; empty where the table has no such column.
std::vector<double> by_region(const MapOptions& options, const LabelTable& table, std::span<const double> labels,
                              const RegionColumn& wanted)
{
    const std::int64_t column = table.column(wanted.name);
    if (column < 0 && wanted.is_needed)
    {
        throw InputError(fmt::format("map.region_table {}: has no column {}; expected columns label and growth, and "
                                     "perhaps onset and rate",
                                     options.region_table, wanted.name));
    }
    std::vector<double> values;
    values.reserve(column < 0 ? 0 : labels.size());
    for (std::size_t i = 0; column >= 0 && i < labels.size(); ++i)
    {
        const auto found = table.rows.find(static_cast<std::int64_t>(labels[i]));
        if (found == table.rows.end())
        {
            throw InputError(
                fmt::format("map.region_table {}: has no line for label {:.0f}, which {} holds in the body; "
                            "expected one for each",
                            options.region_table, labels[i], options.region_file));
        }
        values.push_back(found->second[static_cast<std::size_t>(column)]);
        if (!(values.back() >= wanted.least && values.back() <= wanted.most))
        {
            throw InputError(fmt::format("map.region_table {}: {} of label {} is {}; expected {} to {}",
                                         options.region_table, wanted.name, found->first, values.back(), wanted.least,
                                         wanted.most));
        }
    }
    return values;
}

/// Growth, onset and rate of the region each point is in.
void apply_regions(const MapOptions& options, std::span<const double> labels, BodyMaps& maps)
{
    const LabelTable table = read_label_table(options.region_table);
    const std::vector<double> factors = by_region(options, table, labels, {"growth", 0.0, 1000.0, true});
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
        maps.growth[i] *= factors[i];
    }
    maps.onset = by_region(options, table, labels, {"onset", -10.0, 1.0, false});
    maps.rate = by_region(options, table, labels, {"rate", 1e-6, 100.0, false});
}

} // namespace

BodyMaps read_body_maps(const MapOptions& options, const TriangleMesh& surface, std::span<const Vec3> positions)
{
    MapSampler sampler(surface, positions);
    BodyMaps maps;
    maps.growth.assign(positions.size(), 1.0);
    if (!options.growth_file.empty())
    {
        const MapFile map{"map.growth_file", options.growth_file, options.growth_array};
        maps.growth = sampler.numbers(map);
        require_above(map, maps.growth, 0.0, false);
    }
    if (!options.region_file.empty())
    {
        apply_regions(options, sampler.labels({"map.region_file", options.region_file, options.region_array}), maps);
    }
    if (!options.still_file.empty())
    {
        const std::vector<double> still = sampler.labels({"map.still_file", options.still_file, options.still_array});
        for (std::size_t i = 0; i < still.size(); ++i)
        {
            maps.growth[i] = still[i] != 0.0 ? 0.0 : maps.growth[i];
        }
    }
    if (!options.thickness_file.empty())
    {
        const MapFile map{"map.thickness_file", options.thickness_file, options.thickness_array};
        maps.thickness = sampler.numbers(map);
        require_above(map, maps.thickness, 0.0, true);
    }
    return maps;
}

} // namespace corticle
