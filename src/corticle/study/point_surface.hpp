// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/surface_rows.hpp"

#include <filesystem>
#include <optional>

namespace corticle::study
{

/// What `corticle measure --surface delaunay` is asked for.
struct PointSurfaceRequest
{
    std::filesystem::path file;
    std::optional<double> length_limit_mm; ///< none: two thirds more than the mean distance of points
    std::filesystem::path out;             ///< .vtp for the surface found; empty: none
};

/// A surface made from points alone by a Delaunay triangulation (thesis section 3.2), measured; and where the file is a
/// frame of a run (particles_NAME.vtu beside surface_NAME.vtp), how far it is from the triangulation that the run
/// carries along, and where. Points come from .vtu, from a table (.csv) with columns x, y and z, or are the vertices of
/// any surface file. The file written has the distance to the carried surface as an array.
/// @throws InputError
std::vector<metrics::SurfaceRow> measure_point_surface(const PointSurfaceRequest& request);

} // namespace corticle::study
