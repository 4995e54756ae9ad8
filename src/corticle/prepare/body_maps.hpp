// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/prepare/options.hpp"

#include <span>
#include <string>
#include <vector>

namespace corticle::prepare
{

/// What map files say at material points.
struct BodyMaps
{
    std::vector<double> growth;                     ///< regional growth m [-], one per point
    std::vector<std::vector<double>> growth_series; ///< maps in time by which m is multiplied, one for each time
    std::vector<double> onset;                      ///< of growth [t], one per point; empty: the same everywhere
    std::vector<double> rate;                       ///< of growth [1/t], one per point; empty: the same everywhere
    std::vector<double> region;                     ///< label of the region, one per point; empty: there are none
    std::vector<double> thickness;     ///< of the cortex at t = 0 [mm], one per point; empty: the same everywhere
    std::vector<std::string> notes;    ///< how each map reaches the points, one line each
    std::vector<std::string> warnings; ///< what of a map is lost between them, one line each
};

/// The arrays that growth_array lists, one for each of growth_times.
std::vector<std::string> growth_arrays(const MapOptions& options);

/// Reads the maps and carries them to material points (MapSampler).
/// m is the product of the growth map and the region's factor, 0 under the mask of what is still.
/// @param surface    whose vertices the maps refer to, as it is in its file, in mm; without vertices: there is none
/// @param positions  reference [mm]
/// @throws InputError: a map that cannot be read, of the wrong length, negative, or (thickness) not positive; a region
/// without a line in the table; a map by vertices where there is no surface
BodyMaps read_body_maps(const MapOptions& options, const TriangleMesh& surface, std::span<const Vec3> positions);

} // namespace corticle::prepare
