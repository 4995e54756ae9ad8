// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/formats/coordinates.hpp"
#include "corticle/formats/unit_of_length.hpp"
#include "corticle/geometry/repair.hpp"
#include "corticle/imaging/options.hpp"
#include "corticle/imaging/tissue_labels.hpp"
#include "corticle/material/imperfection.hpp"
#include "corticle/model/options.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace corticle::prepare
{

/// Particles of a case that gives neither geometry.particles nor geometry.spacing_mm.
inline constexpr std::int64_t default_particles = 45000;
inline constexpr std::int64_t fewest_particles = 500;
inline constexpr std::int64_t most_particles = 100'000'000;

enum class Shape
{
    sphere,
    ellipsoid,
    box, ///< a strip of cortex: its face of the highest z is the surface of the brain
    file
};

/// Where the particles are.
enum class Arrangement
{
    body_fitted,
    mesh_nodes, ///< nodes of the tets that fem makes
    tet_nodes,  ///< nodes of a tet mesh from a file
    thinned,    ///< some of them, evenly
    thinned_at_random
};

/// Of the particles.
enum class VolumeRule
{
    cells,
    neighbour_count ///< the thesis's
};

/// Of the particles.
enum class NormalRule
{
    surface,
    divisions ///< the thesis's
};

/// Names in a case.
constexpr std::array shape_names{"sphere", "ellipsoid", "box", "file"};
constexpr std::array arrangement_names{"body_fitted", "mesh_nodes", "tet_nodes", "thinned", "thinned_at_random"};
constexpr const char* name_of(Shape shape)
{
    return shape_names[static_cast<std::size_t>(shape)];
}
constexpr const char* name_of(Arrangement arrangement)
{
    return arrangement_names[static_cast<std::size_t>(arrangement)];
}

/// Where the body comes from.
struct GeometryOptions
{
    Shape shape = Shape::sphere;
    double radius_mm = 12.496;                              ///< sphere
    std::array<double, 3> semi_axes_mm{15.0, 12.0, 10.0};   ///< ellipsoid
    std::array<double, 3> size_mm{40.0, 4.0, 15.0};         ///< box: lengths along x, y and z
    std::string file;                                       ///< closed triangulated surface, label volume or tet mesh
    formats::UnitOfLength unit = formats::UnitOfLength::mm; ///< of a surface or tet mesh
    formats::Coordinates coordinates = formats::Coordinates::scanner; ///< of a surface or label volume with metadata
    imaging::MaskOptions mask;          ///< of a label volume: keys labels, image_volume, ...; the next two overrule it
    std::optional<double> closing_mm;   ///< not given: as little as the spacing needs
    std::optional<double> smoothing_mm; ///< not given: as little as voxels and spacing need
    geometry::Repair repair = geometry::Repair::none; ///< of a surface that is not closed and embedded
    geometry::RepairOptions wrap;                     ///< keys wrap_alpha_mm, wrap_offset_mm
    std::optional<double> spacing_mm;                 ///< either this
    std::optional<std::int64_t> particles;            ///< or this, or Options::elements
    double grading = 1.0;                             ///< spacing in the core over that in the cortex
    std::int64_t seed = 1;
    Arrangement arrangement = Arrangement::body_fitted;
    VolumeRule volumes = VolumeRule::cells;
    NormalRule normals = NormalRule::surface;
    std::int64_t normal_divisions = 8; ///< where normals = divisions
};

/// Values on the body read from files (keys under [map]); an empty file: none.
struct MapOptions
{
    std::string growth_file;          ///< regional growth m, one number a vertex of the input surface
    std::string growth_array;         ///< which array of that file; empty: its first
    std::vector<double> growth_times; ///< of several arrays, which growth_array lists with commas [t, or weeks]
    double protomap_amplitude = 0.0;  ///< standard deviation of a random map, by which m is multiplied [-]
    double protomap_wavelength_mm = 10.0;
    std::int64_t protomap_seed = 1;
    std::vector<double> modes;   ///< amplitudes of smooth modes by which m is multiplied, see growth_mode [-]
    std::string thickness_file;  ///< cortical thickness at t = 0 [mm], the same way
    std::string thickness_array; ///< which array of that file
    std::string still_file;      ///< where this is not 0 nothing grows, the same way, or a label volume
    std::string still_array;     ///< which array of that file
    std::string region_file;     ///< region labels, one whole number a vertex, or a label volume
    std::string region_array;    ///< which array of that file
    std::string region_table;    ///< CSV with columns label, growth
};

/// What making a body needs to know.
struct PreparationOptions : model::SimulationOptions
{
    std::optional<std::int64_t> elements; ///< key solver.elements: about this many tets
    GeometryOptions geometry;
    MapOptions map;
    imaging::TissueLabels labels; ///< of each tissue; without cortex: the depth decides
    std::string fibre_file;       ///< key fibres.file: NIfTI volume of vectors
    std::string growth_table;     ///< key growth.table: CSV of week, tissue, tangential, radial
    material::ImperfectionOptions imperfection;
};

/// Whether labels say where the cortex is.
inline bool has_labelled_cortex(const PreparationOptions& options)
{
    return !options.labels[static_cast<std::size_t>(material::TissueKind::cortex)].empty();
}

/// Amplitude of the imperfection; where none is given, that of the built-in shapes, which are perfect. Bodies from
/// files are imperfect as they are, and the thesis knows no imperfection.
inline double imperfection_amplitude(const PreparationOptions& options)
{
    const bool is_perfect =
        options.geometry.shape != Shape::file && options.formulation == thesis::Formulation::corrected;
    return options.imperfection.amplitude.value_or(is_perfect ? 0.05 : 0.0);
}

} // namespace corticle::prepare
