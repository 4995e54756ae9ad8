// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_faults.hpp"

#include <string>

namespace corticle::geometry
{

enum class Repair
{
    automatic, ///< mends what it can and keeps the rest of the surface as it is; wraps where that is not enough
    wrap,      ///< a new surface around the old one
    none       ///< refuses what is not valid
};

struct RepairOptions
{
    double alpha_mm = 0.0;  ///< radius of the ball that feels the surface in a wrap; 0: chosen from size and holes
    double offset_mm = 0.0; ///< distance at which it does; 0: alpha / 20, at most 1/400 of the diagonal
};

/// What was wrong with a surface, and what was done about it.
struct RepairReport
{
    std::int64_t duplicate_vertices = 0;   ///< at the place of another; merged
    std::int64_t dropped_triangles = 0;    ///< without area, or there already
    EdgeFaults edges;                      ///< once duplicates are merged
    bool inside_out = false;               ///< the enclosed volume was negative
    std::int64_t crossing_pairs = 0;       ///< pairs of triangles that cross, once holes are filled
    std::vector<double> shell_volumes_mm3; ///< of the closed shells found, largest first
    bool wrapped = false;
    std::int64_t bodies_before = 0; ///< found before a wrap, which makes one of them (find_bodies)
    std::int64_t genus_before = 0;  ///< of that body
    std::int64_t genus_after = 0;   ///< of the wrap
    double left_out_mm = 0.0;       ///< largest distance of that body from the wrap
    double area_before_mm2 = 0.0;
    double area_after_mm2 = 0.0;
    double volume_before_mm3 = 0.0; ///< enclosed; means little for an open surface
    double volume_after_mm3 = 0.0;
    std::vector<std::string> warnings; ///< one line each
    std::vector<std::string> lines;    ///< what was found and done, in words, one line each; empty for a sound surface
};

struct RepairedSurface
{
    TriangleMesh mesh; ///< passes require_valid_surface
    RepairReport report;
};

/// Makes one closed, embedded, outward-oriented surface of what a file holds; the same bits every time.
/// automatic: merges equal vertices, drops triangles without area and doubled ones, orients the rest, drops loose
/// pieces (below 1 % of the volume) and inner shells, fills holes, and replaces what crosses itself. A sound surface
/// stays as it is. What is still not valid is wrapped.
/// @throws InputError, one line naming `file`: for `none`, any fault; otherwise numbers that are not finite, several
/// bodies of comparable volume, or a wrap that came out with a fault itself.
RepairedSurface repair_surface(const TriangleMesh& surface, const std::string& file, Repair choice,
                               const RepairOptions& options = {});

} // namespace corticle::geometry
