// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace corticle::prepare
{

/// A map file and which array of it is meant.
struct MapFile
{
    const char* key; ///< of the case, for messages
    const std::string& file;
    const std::string& array;
};

/// What numbers of a map may be.
struct MapRange
{
    double low = -std::numeric_limits<double>::infinity();
    bool is_open = false; ///< low itself is not allowed
};

/// Carries maps to material points, and notes what of them falls between the points. Numbers at vertices are
/// interpolated at the closest point of the surface they belong to, labels taken from its nearest corner, volumes from
/// the voxel a point lies in.
class MapSampler
{
  public:
    /// @param surface  whose vertices the maps refer to [mm]; without vertices: there is none
    MapSampler(const TriangleMesh& surface, std::span<const Vec3> positions) : surface_(surface), positions_(positions)
    {
    }

    /// @throws InputError for a map that cannot be read, or a number out of range at any vertex, whether a point is
    /// near it or not
    std::vector<double> numbers(const MapFile& map, const MapRange& range);
    /// @throws InputError for a map that cannot be read, numbers that are not whole, or a volume that holds no point
    std::vector<double> labels(const MapFile& map);

    std::vector<std::string> notes;    ///< how each map reaches the points, one line each
    std::vector<std::string> warnings; ///< what of it does not, one line each

  private:
    std::vector<double> at_vertices(const MapFile& map) const;
    std::vector<double> labels_of_vertices(const MapFile& map);
    std::vector<double> in_volume(const MapFile& map);
    void find_feet();
    void judge_numbers(const MapFile& map, std::span<const double> given, std::span<const double> carried);
    void judge_labels(const MapFile& map, std::span<const double> given, std::span<const double> carried);

    const TriangleMesh& surface_;
    std::span<const Vec3> positions_;
    std::vector<geometry::SurfacePoint> feet_; ///< of the points on the surface; found when first needed
};

} // namespace corticle::prepare
