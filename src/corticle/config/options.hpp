// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/contact/options.hpp"
#include "corticle/dynamics/options.hpp"
#include "corticle/geometry/repair.hpp"
#include "corticle/imaging/options.hpp"
#include "corticle/io/coordinates.hpp"
#include "corticle/thesis/options.hpp"
#include "corticle/tissue/imperfection.hpp"
#include "corticle/tissue/options.hpp"
#include "corticle/tissue/size.hpp"
#include "corticle/tlsph/options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace corticle
{

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

struct OutputOptions
{
    std::int64_t count = 10;           ///< evenly spaced in t, besides t = 0
    std::vector<double> times;         ///< instead of count
    std::vector<double> weeks;         ///< instead of count, with a clock
    std::string pictures = "on";       ///< "on" | "off"
    std::vector<double> picture_times; ///< output times that get pictures (the nearest); empty: the last
    double checkpoint_minutes = 5.0;
};

struct TimeOptions
{
    double start = 0.0;                              ///< growth time t of the body as it is given
    double end = 1.0;                                ///< growth time t at which the run ends
    GestationalClock clock = GestationalClock::none; ///< with one, the weeks below set start and end
    std::optional<double> start_week;                ///< gestational age of the body as it is given
    std::optional<double> end_week;                  ///< gestational age at which the run ends
};

/// How a body is cut up.
enum class Method
{
    tlsph, ///< particles
    fem    ///< linear tetrahedra
};

/// What the user chose.
struct Options
{
    Method method = Method::tlsph;        ///< key solver.method
    std::optional<std::int64_t> elements; ///< key solver.elements: about this many tets
    GeometryOptions geometry;
    MapOptions map;
    TissueOptions tissue;
    ImperfectionOptions imperfection;
    Formulation formulation = Formulation::corrected; ///< key solver.formulation
    TlsphOptions tlsph;                               ///< keys under [solver]
    ThesisOptions thesis;                             ///< where formulation = "thesis"
    ContactOptions contact;                           ///< keys under [contact]
    DynamicsOptions dynamics;                         ///< keys under [solver]
    TimeOptions time;
    SizeOptions size;
    OutputOptions output;
    std::map<std::string, std::string, std::less<>> inputs; ///< SHA-256 of the file that a key ("geometry.file") names
};

/// Amplitude of the imperfection; where none is given, that of the built-in shapes, which are perfect. Bodies from
/// files are imperfect as they are, and the thesis knows no imperfection.
inline double imperfection_amplitude(const Options& options)
{
    const bool is_perfect = options.geometry.shape != "file" && options.formulation == Formulation::corrected;
    return options.imperfection.amplitude.value_or(is_perfect ? 0.05 : 0.0);
}

} // namespace corticle
