// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/formats/coordinates.hpp"
#include "corticle/geometry/repair.hpp"
#include "corticle/imaging/options.hpp"
#include "corticle/material/imperfection.hpp"
#include "corticle/model/options.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace corticle
{

/// Particles of a case that gives neither geometry.particles nor geometry.spacing_mm.
inline constexpr std::int64_t default_particles = 45000;
inline constexpr std::int64_t fewest_particles = 500;
inline constexpr std::int64_t most_particles = 100'000'000;

/// Where the body comes from.
struct GeometryOptions
{
    std::string shape = "sphere";                         ///< "sphere" | "ellipsoid" | "file"
    double radius_mm = 12.496;                            ///< sphere
    std::array<double, 3> semi_axes_mm{15.0, 12.0, 10.0}; ///< ellipsoid
    std::string file;                                     ///< closed triangulated surface, label volume or tet mesh
    std::string unit = "mm";                              ///< of a surface or tet mesh: "mm" | "cm" | "m"
    Coordinates coordinates = Coordinates::scanner;       ///< of a surface or label volume with metadata
    MaskOptions mask;                      ///< of a label volume: keys labels, image_volume, closing_mm, ...
    Repair repair = Repair::none;          ///< of a surface that is not closed and embedded
    RepairOptions wrap;                    ///< keys wrap_alpha_mm, wrap_offset_mm
    std::optional<double> spacing_mm;      ///< either this
    std::optional<std::int64_t> particles; ///< or this, or Options::elements
    std::int64_t seed = 1;
    std::string arrangement = "body_fitted"; ///< "body_fitted" | "mesh_nodes" | "tet_nodes" | "thinned" | ...
    std::string volumes = "cells";           ///< of the particles: "cells" | "neighbour_count"
    std::string normals = "surface";         ///< of the particles: "surface" | "divisions"
    std::int64_t normal_divisions = 8;       ///< where normals = "divisions"
};

/// Values on the body read from files (keys under [map]); an empty file: none.
struct MapOptions
{
    std::string growth_file;     ///< regional growth m, one number a vertex of the input surface
    std::string growth_array;    ///< which array of that file; empty: its first
    std::string thickness_file;  ///< cortical thickness at t = 0 [mm], the same way
    std::string thickness_array; ///< which array of that file
    std::string still_file;      ///< where this is not 0 nothing grows, the same way, or a label volume
    std::string still_array;     ///< which array of that file
    std::string region_file;     ///< region labels, one whole number a vertex, or a label volume
    std::string region_array;    ///< which array of that file
    std::string region_table;    ///< CSV with columns label, growth
};

/// What making a body needs to know.
struct PreparationOptions : SimulationOptions
{
    std::optional<std::int64_t> elements; ///< key solver.elements: about this many tets
    GeometryOptions geometry;
    MapOptions map;
    ImperfectionOptions imperfection;
};

/// Amplitude of the imperfection; where none is given, that of the built-in shapes, which are perfect. Bodies from
/// files are imperfect as they are, and the thesis knows no imperfection.
inline double imperfection_amplitude(const PreparationOptions& options)
{
    const bool is_perfect = options.geometry.shape != "file" && options.formulation == Formulation::corrected;
    return options.imperfection.amplitude.value_or(is_perfect ? 0.05 : 0.0);
}

} // namespace corticle
