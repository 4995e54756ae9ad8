// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/boundary_measures.hpp"
#include "corticle/metrics/equilibrium.hpp"
#include "corticle/metrics/surface_arrays.hpp"
#include "corticle/metrics/surface_measures.hpp"

#include <limits>
#include <span>
#include <string_view>

namespace corticle::metrics
{

/// Measures of a run at one output time: a row of measures.csv. Lengths, areas and volumes are in mm at the week, but
/// ratios, energies and fold_wavelength_reference_mm belong to the run's own coordinates.
struct Measures : SurfaceMeasures, FoldMeasures, EquilibriumMeasures, BoundaryMeasures
{
    double t = 0.0;
    double week = std::numeric_limits<double>::quiet_NaN(); ///< gestational age; NaN without a clock
    double length_scale = 1.0;                              ///< see PhysicalScale
    double steps = 0.0;
    double rejected_steps = 0.0;
    double area_ratio = 0.0;                   ///< over the initial area
    double volume_ratio = 0.0;                 ///< over the initial volume
    double curved_area_ratio = 0.0;            ///< over the initial curved area
    double curved_volume_ratio = 0.0;          ///< over the initial curved volume
    double thickness_mean_mm = 0.0;            ///< of the cortex, weighted with current area
    double cortex_volume_mm3 = 0.0;            ///< by its share of the nodes
    double inner_area_mm2 = 0.0;               ///< of the boundary of cortex and white matter
    double cortex_thickness_mm = 0.0;          ///< its volume over the mean area of its two surfaces
    double fold_wavelength_reference_mm = 0.0; ///< see ReferenceFolds
    double fold_degree = 0.0;                  ///< the same
    double J_min = 0.0;
    double J_mean = 0.0; ///< volume-weighted by reference volume
    double J_max = 0.0;
    double energy_elastic = 0.0;
    double energy_kinetic = 0.0;
    double energy_zero_mode = 0.0;
    double energy_contact = 0.0;
    double energy_dissipated = 0.0;
    double energy_remodelling = 0.0; ///< taken by the history of the tissue
    double work_growth = 0.0;
    double overlap_area_share = 0.0;
    double max_penetration_mm = 0.0;
    double barrier_particles = 0.0;
    double extrapolated_elements = 0.0; ///< see InternalResponse
    double inverted_elements = 0.0;     ///< the same
    double contact_pairs = 0.0;
    double intersecting_triangles = 0.0; ///< of the surface, with another of its triangles (exact predicates)
    double contact_limited_share = 0.0;  ///< of all displacements of surface vertices so far: TravelLimit changed them
    double energy_contact_limit = 0.0;   ///< kinetic energy that it took so far
    Vec3 smallest_J_place{};             ///< where J is smallest [mm at the week]; in no file, as the next
    Vec3 overlap_place{};                ///< of the deepest overlap [mm at the week]
    std::vector<double> added;           ///< see add_measure()
};

/// @param arrays  those of the same view
Measures measure(const model::OutputView& view, const SurfaceArrays& arrays);

/// measures.csv of the rows: header with units, one line each, 17 significant digits.
std::string measures_csv(std::span<const Measures> rows);

/// Reads measures.csv back. @throws InputError when it is not one of ours
std::vector<Measures> parse_measures_csv(std::string_view text, const std::string& name);

} // namespace corticle::metrics
