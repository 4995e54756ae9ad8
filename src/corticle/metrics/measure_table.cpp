// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/measure_table.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace corticle::metrics
{

namespace
{

using RunColumn = Column<Measures>;
using EquilibriumColumn = Column<EquilibriumMeasures>;

constexpr std::array run_table{
    RunColumn{"t", "-", "growth time", &Measures::t},
    RunColumn{"week", "weeks", "gestational age; NaN without a clock", &Measures::week},
    RunColumn{"length_scale", "-", "mm at this week per mm of the body as given; 1 without a length law",
              &Measures::length_scale},
    RunColumn{"steps", "-", "accepted steps so far", &Measures::steps},
    RunColumn{"rejected_steps", "-", "halvings of a step so far", &Measures::rejected_steps},
    RunColumn{"area_ratio", "-", "area over that of the reference surface", &Measures::area_ratio},
    RunColumn{"volume_ratio", "-", "enclosed volume over that of the reference surface", &Measures::volume_ratio},
    RunColumn{"curved_area_ratio", "-", "curved area over that of the reference surface", &Measures::curved_area_ratio},
    RunColumn{"curved_volume_ratio", "-", "curved volume over that of the reference surface",
              &Measures::curved_volume_ratio},
    RunColumn{"thickness_mean_mm", "mm", "mean thickness of the deformed cortex, weighted with area",
              &Measures::thickness_mean_mm},
    RunColumn{"cortex_volume_mm3", "mm3", "volume of the deformed cortex", &Measures::cortex_volume_mm3},
    RunColumn{
        "inner_area_mm2", "mm2",
        "area of the deformed boundary of cortex and other tissue; with labels of the cortex, of the surface of the "
        "body without it",
        &Measures::inner_area_mm2},
    RunColumn{"cortex_thickness_mm", "mm", "cortex_volume_mm3 over the mean of area_mm2 and inner_area_mm2",
              &Measures::cortex_thickness_mm},
    RunColumn{"fold_wavelength_reference_mm", "mm",
              "dominant wavelength of the normal displacement on the reference surface; 0: no folds",
              &Measures::fold_wavelength_reference_mm},
    RunColumn{"fold_degree", "-", "spherical harmonic of the folds of a sphere; 0: no folds, or no sphere",
              &Measures::fold_degree},
    RunColumn{"J_min", "-", "smallest det F over the nodes", &Measures::J_min},
    RunColumn{"J_mean", "-", "mean det F, weighted with reference volume", &Measures::J_mean},
    RunColumn{"J_max", "-", "largest det F over the nodes", &Measures::J_max},
    RunColumn{"energy_elastic", "mu_w mm3", "elastic energy stored now", &Measures::energy_elastic},
    RunColumn{"energy_kinetic", "mu_w mm3", "kinetic energy now", &Measures::energy_kinetic},
    RunColumn{"energy_zero_mode", "mu_w mm3", "energy of the zero-energy control (hourglass control) now",
              &Measures::energy_zero_mode},
    RunColumn{"energy_contact", "mu_w mm3", "energy of contact now", &Measures::energy_contact},
    RunColumn{"energy_dissipated", "mu_w mm3", "energy that damping and limits took so far",
              &Measures::energy_dissipated},
    RunColumn{"energy_remodelling", "mu_w mm3",
              "energy that relaxation and growth by stress took so far, less what active fibres put in",
              &Measures::energy_remodelling},
    RunColumn{"work_growth", "mu_w mm3", "work that growth put in so far", &Measures::work_growth},
    RunColumn{"overlap_area_share", "-", "share of the area covered by another part of the body",
              &Measures::overlap_area_share},
    RunColumn{"max_penetration_mm", "mm", "depth of the deepest overlap", &Measures::max_penetration_mm},
    RunColumn{"barrier_particles", "-", "particles, or nodes, with J_e below tissue.barrier_J",
              &Measures::barrier_particles},
    RunColumn{"extrapolated_elements", "-", "tets flat below a tenth in one direction",
              &Measures::extrapolated_elements},
    RunColumn{"inverted_elements", "-", "tets with det F <= 0", &Measures::inverted_elements},
    RunColumn{"contact_pairs", "-", "vertices and edges that repel now", &Measures::contact_pairs},
    RunColumn{"intersecting_triangles", "-",
              "triangles of the surface that cross or touch another one, by exact predicates",
              &Measures::intersecting_triangles},
    RunColumn{"contact_limited_share", "-",
              "share of all displacements of surface vertices so far that the travel limit of contact changed",
              &Measures::contact_limited_share},
    RunColumn{"energy_contact_limit", "mu_w mm3",
              "kinetic energy that the travel limit took so far, part of energy_dissipated",
              &Measures::energy_contact_limit},
};

constexpr std::array equilibrium_table{
    EquilibriumColumn{"zero_mode_share", "-", "energy_zero_mode over energy_elastic; 0 where both are round-off",
                      &EquilibriumMeasures::zero_mode_share},
    EquilibriumColumn{
        "kinetic_share", "-",
        "kinetic energy over energy_elastic, with growth by week that of the motion against the mean growth of the "
        "body; 0 where both are round-off",
        &EquilibriumMeasures::kinetic_share},
    EquilibriumColumn{"dissipated_share", "-", "energy_dissipated over work_growth",
                      &EquilibriumMeasures::dissipated_share},
    EquilibriumColumn{"energy_balance_error", "-",
                      "difference of work_growth and all that is stored or dissipated, over the larger of the two",
                      &EquilibriumMeasures::energy_balance_error},
    EquilibriumColumn{"residual_force", "-",
                      "residual force against the stress of the tissue on patches of neighbours: 0 in equilibrium",
                      &EquilibriumMeasures::residual_force},
};

using BoundaryColumn = Column<BoundaryMeasures>;
constexpr std::array boundary_table{
    BoundaryColumn{"skull_force", "mu_w mm2", "contact between brain and skull: sum of the magnitudes of its forces",
                   &BoundaryMeasures::skull_force},
    BoundaryColumn{"skull_pressure", "mu_w", "skull_force over the area of the skull",
                   &BoundaryMeasures::skull_pressure},
    BoundaryColumn{"skull_contact_share", "-", "share of the brain's surface that touches the skull",
                   &BoundaryMeasures::skull_contact_share},
    BoundaryColumn{"skull_intersections", "-", "triangles of brain and skull that cross the other, by exact predicates",
                   &BoundaryMeasures::skull_intersections},
    BoundaryColumn{"skull_volume_mm3", "mm3", "volume that the skull encloses", &BoundaryMeasures::skull_volume_mm3},
    BoundaryColumn{"energy_skull", "mu_w mm3", "of the skull's contact with the brain, its springs and its motion",
                   &BoundaryMeasures::energy_skull},
    BoundaryColumn{"fluid_pressure", "mu_w", "of the fluid on the surface of the brain",
                   &BoundaryMeasures::fluid_pressure},
    BoundaryColumn{"fluid_volume_mm3", "mm3", "volume between brain and skull; 0 without a fluid and a skull",
                   &BoundaryMeasures::fluid_volume_mm3},
    BoundaryColumn{"energy_fluid", "mu_w mm3", "potential of the fluid's pressure, outside and in the ventricles",
                   &BoundaryMeasures::energy_fluid},
    BoundaryColumn{"ventricle_volume_mm3", "mm3", "of the ventricles; 0 where no pressure acts in them",
                   &BoundaryMeasures::ventricle_volume_mm3},
    BoundaryColumn{"tract_tension", "mu_w mm2", "sum of the tensions of the tracts", &BoundaryMeasures::tract_tension},
    BoundaryColumn{"tract_stretch", "-", "mean of length over rest length of the tracts; 0 without tracts",
                   &BoundaryMeasures::tract_stretch},
    BoundaryColumn{"energy_tracts", "mu_w mm3", "stored in the tracts", &BoundaryMeasures::energy_tracts},
};

constexpr std::array size_table{
    SizeColumn{"area_mm2", "mm2", "area of the surface", &SurfaceMeasures::area_mm2},
    SizeColumn{"volume_mm3", "mm3", "volume it encloses", &SurfaceMeasures::volume_mm3},
    SizeColumn{"area_per_volume", "1/mm", "area over volume", &SurfaceMeasures::area_per_volume},
    SizeColumn{"hull_area_mm2", "mm2", "area of the convex hull", &SurfaceMeasures::hull_area_mm2},
    SizeColumn{"gi_hull", "-", "gyrification index: area over that of the convex hull", &SurfaceMeasures::gi_hull},
    SizeColumn{"gi_sphere", "-", "gyrification index: area over that of the sphere of equal volume",
               &SurfaceMeasures::gi_sphere},
    SizeColumn{"curved_area_mm2", "mm2", "area of the smooth surface through the vertices",
               &SurfaceMeasures::curved_area_mm2},
    SizeColumn{"curved_volume_mm3", "mm3", "volume that the smooth surface encloses",
               &SurfaceMeasures::curved_volume_mm3},
    SizeColumn{"curved_gi_hull", "-", "curved area over that of the convex hull", &SurfaceMeasures::curved_gi_hull},
    SizeColumn{"curved_gi_sphere", "-", "curved area over that of the sphere of equal curved volume",
               &SurfaceMeasures::curved_gi_sphere},
    SizeColumn{"length_mm", "mm", "extent along y, from back to front where x points to the right",
               &SurfaceMeasures::length_mm},
    SizeColumn{"width_mm", "mm", "extent along x", &SurfaceMeasures::width_mm},
    SizeColumn{"height_mm", "mm", "extent along z", &SurfaceMeasures::height_mm},
};

constexpr std::array fold_table{
    FoldColumn{"gi_zilles", "-", "gyrification index of coronal slices", &FoldMeasures::gi_zilles},
    FoldColumn{"gi_local_mean", "-", "mean local gyrification index", &FoldMeasures::gi_local_mean},
    FoldColumn{"abs_mean_curvature_per_mm", "1/mm", "mean of the absolute mean curvature",
               &FoldMeasures::abs_mean_curvature_per_mm},
    FoldColumn{"curvedness_per_mm", "1/mm", "mean curvedness over the surface", &FoldMeasures::curvedness_per_mm},
    FoldColumn{"sulcal_depth_mean_mm", "mm", "mean depth below the outer surface", &FoldMeasures::sulcal_depth_mean_mm},
    FoldColumn{"sulcal_depth_max_mm", "mm", "largest depth below the outer surface",
               &FoldMeasures::sulcal_depth_max_mm},
    FoldColumn{"sulcal_pits", "-", "number of sulcal pits", &FoldMeasures::sulcal_pits},
    FoldColumn{"gyral_crowns", "-", "number of gyral crowns", &FoldMeasures::gyral_crowns},
    FoldColumn{"fold_wavelength_mm", "mm",
               "dominant wavelength of the mean curvature along the folded surface; 0: no folds",
               &FoldMeasures::fold_wavelength_mm},
    FoldColumn{"asymmetry_area", "-", "area of the left side less the right, over their mean",
               &FoldMeasures::asymmetry_area},
    FoldColumn{"asymmetry_volume", "-", "volume of the left side less the right, over their mean",
               &FoldMeasures::asymmetry_volume},
};

/// The table of runs, and how what was added is measured.
struct Table
{
    std::vector<MeasureColumn> columns;
    std::vector<double (*)(const model::OutputView& view)> added;

    Table()
    {
        columns.insert(columns.end(), run_table.begin(), run_table.end());
        columns.insert(columns.end(), equilibrium_table.begin(), equilibrium_table.end());
        columns.insert(columns.end(), size_table.begin(), size_table.end());
        columns.insert(columns.end(), fold_table.begin(), fold_table.end());
        columns.insert(columns.end(), boundary_table.begin(), boundary_table.end());
    }
};

Table& table()
{
    static Table all;
    return all;
}

} // namespace

std::span<const SizeColumn> size_columns()
{
    return size_table;
}

std::span<const FoldColumn> fold_columns()
{
    return fold_table;
}

std::span<const MeasureColumn> measure_columns()
{
    return table().columns;
}

double MeasureColumn::of(const Measures& row) const
{
    if (member_ != nullptr)
    {
        return row.*member_;
    }
    return place_ < row.added.size() ? row.added[place_] : std::numeric_limits<double>::quiet_NaN();
}

double& MeasureColumn::in(Measures& row) const
{
    if (member_ != nullptr)
    {
        return row.*member_;
    }
    row.added.resize(std::max(row.added.size(), place_ + 1));
    return row.added[place_];
}

void add_measure(std::string_view key, std::string_view unit, std::string_view sentence,
                 double (*value)(const model::OutputView& view))
{
    Table& all = table();
    all.columns.emplace_back(key, unit, sentence, all.added.size());
    all.added.push_back(value);
}

std::vector<double> added_measures(const model::OutputView& view)
{
    std::vector<double> values;
    for (const auto value : table().added)
    {
        values.push_back(value(view));
    }
    return values;
}

std::string measures_markdown()
{
    std::string text = "| key | unit | meaning |\n|---|---|---|\n";
    for (const MeasureColumn& column : measure_columns())
    {
        text += fmt::format("| `{}` | {} | {} |\n", column.key, column.unit, column.sentence);
    }
    return text;
}

} // namespace corticle::metrics
