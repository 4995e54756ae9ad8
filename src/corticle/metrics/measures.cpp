// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/measures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/metrics/curved_surface.hpp"
#include "corticle/metrics/measure_table.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace corticle::metrics
{

namespace
{

constexpr double probe_in_spacings = 1e-4;

std::string header()
{
    std::string line;
    for (const MeasureColumn& column : measure_columns())
    {
        line += fmt::format("{}{} [{}]", line.empty() ? "" : ",", column.key, column.unit);
    }
    return line + "\n";
}

double area_mean(std::span<const double> values, std::span<const double> areas)
{
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    return std::inner_product(values.begin(), values.end(), areas.begin(), 0.0) / area;
}

/// det F over the nodes.
void set_volume_ratios(const model::Model& model, std::span<const Mat3> F, Measures& m)
{
    m.J_min = determinant(F[0]);
    m.J_max = m.J_min;
    double weighted = 0.0;
    double volume = 0.0;
    for (std::size_t i = 0; i < F.size(); ++i)
    {
        const double J = determinant(F[i]);
        m.J_min = std::min(m.J_min, J);
        m.J_max = std::max(m.J_max, J);
        weighted += model.cloud.volumes[i] * J;
        volume += model.cloud.volumes[i];
    }
    m.J_mean = weighted / volume;
}

/// Volume of the cortex, in the coordinates of the run [mm³].
double cortex_volume(const model::Simulation& simulation, std::span<const Mat3> F)
{
    const std::vector<double>& volumes = simulation.model().cloud.volumes;
    const std::vector<double>& theta = simulation.state().nodes.theta;
    double sum = 0.0;
    for (std::size_t i = 0; i < F.size(); ++i)
    {
        sum += theta[i] * volumes[i] * determinant(F[i]);
    }
    return sum;
}

double reference_volume(const model::Model& model)
{
    return std::accumulate(model.cloud.volumes.begin(), model.cloud.volumes.end(), 0.0);
}

void set_energies(const model::Simulation& simulation, std::span<const Mat3> F, Measures& m)
{
    const model::State& state = simulation.state();
    const mechanics::InternalResponse& internal = simulation.internal();
    m.energy_elastic = internal.elastic_energy;
    m.energy_kinetic = state.kinetic_energy;
    m.energy_zero_mode = internal.zero_mode_energy;
    double others = 0.0;
    for (const auto& [name, value] : simulation.energies())
    {
        m.energy_contact += name == "contact" ? value : 0.0;
        m.energy_remodelling += name == "remodelling" ? value : 0.0;
        others += name == "elastic" || name == "zero_mode" || name == "remodelling" ? 0.0 : value;
    }
    m.energy_dissipated = state.energy_balance.dissipated;
    m.work_growth = state.energy_balance.growth_work;
    static_cast<EquilibriumMeasures&>(m) = equilibrium_measures(
        {m.energy_elastic, m.energy_zero_mode, m.energy_kinetic, simulation.relative_kinetic_energy(), others,
         m.energy_dissipated, m.work_growth, m.energy_remodelling},
        reference_volume(simulation.model()));
    m.residual_force = residual_force(simulation, F);
}

} // namespace

Measures measure(const model::OutputView& view, const SurfaceArrays& arrays)
{
    const model::Simulation& simulation = view.simulation;
    const model::Model& model = view.model();
    const model::State& state = view.state();
    const model::PhysicalScale& scale = view.scale;
    const std::vector<Vec3>& x = view.surface;
    const SurfaceMeasures now = measure_surface(x, model.cloud.surface_triangles);
    const double area_0 = surface_area(model.surface.vertices, model.surface.triangles);
    const double volume_0 = enclosed_volume(model.surface.vertices, model.surface.triangles);
    const CurvedSize curved_0 = curved_size(model.surface.vertices, model.surface.triangles);
    const Overlap overlap =
        measure_overlap(x, model.cloud.surface_triangles, probe_in_spacings * model.cloud.spacing * scale.length);

    const ReferenceFolds waves = reference_folds(view);

    Measures m;
    static_cast<SurfaceMeasures&>(m) = now;
    static_cast<FoldMeasures&>(m) = measure_folds(x, model.cloud.surface_triangles, arrays.folds, fold_options(view));
    m.t = state.t;
    m.week = scale.week;
    m.length_scale = scale.length;
    m.steps = static_cast<double>(state.steps);
    m.rejected_steps = static_cast<double>(state.rejected_steps);
    m.area_ratio = now.area_mm2 / (area_0 * std::pow(scale.length, 2));
    m.volume_ratio = now.volume_mm3 / (volume_0 * std::pow(scale.length, 3));
    m.curved_area_ratio = now.curved_area_mm2 / (curved_0.area_mm2 * std::pow(scale.length, 2));
    m.curved_volume_ratio = now.curved_volume_mm3 / (curved_0.volume_mm3 * std::pow(scale.length, 3));
    m.thickness_mean_mm = area_mean(arrays.thickness, vertex_areas(x, model.cloud.surface_triangles));
    m.cortex_volume_mm3 = cortex_volume(simulation, *view.F) * std::pow(scale.length, 3);
    m.inner_area_mm2 = arrays.inner_area;
    m.cortex_thickness_mm = 2.0 * m.cortex_volume_mm3 / (m.area_mm2 + m.inner_area_mm2);
    m.fold_wavelength_reference_mm = waves.wavelength_mm;
    m.fold_degree = waves.degree;
    set_volume_ratios(model, *view.F, m);
    set_energies(simulation, *view.F, m);
    static_cast<BoundaryMeasures&>(m) = boundary_measures(view);
    m.overlap_area_share = overlap.area_share;
    m.max_penetration_mm = overlap.deepest_penetration;
    m.barrier_particles = static_cast<double>(simulation.internal().barrier_count);
    m.extrapolated_elements = static_cast<double>(simulation.internal().extrapolated_count);
    m.inverted_elements = static_cast<double>(simulation.internal().inverted_count);
    m.contact_pairs = static_cast<double>(simulation.contact().active);
    m.intersecting_triangles =
        static_cast<double>(geometry::intersecting_triangles({view.as_folded, model.cloud.surface_triangles}));
    m.contact_limited_share =
        static_cast<double>(state.travel_taken.vertex_steps) /
        (static_cast<double>(std::max<std::int64_t>(state.steps, 1)) * static_cast<double>(x.size()));
    m.energy_contact_limit = state.travel_taken.energy;
    m.smallest_J_place = scale.length * simulation.place_of_smallest_J();
    m.overlap_place = overlap.place;
    m.added = added_measures(view);
    return m;
}

std::string measures_csv(std::span<const Measures> rows)
{
    std::string text = header();
    for (const Measures& row : rows)
    {
        std::string_view separator;
        for (const MeasureColumn& column : measure_columns())
        {
            text += fmt::format("{}{:.17g}", separator, column.of(row));
            separator = ",";
        }
        text += '\n';
    }
    return text;
}

std::vector<Measures> parse_measures_csv(std::string_view text, const std::string& name)
{
    const std::string expected = header();
    if (!text.starts_with(expected))
    {
        throw InputError(fmt::format("{}: not a table of measures written by this version", name));
    }
    std::vector<Measures> rows;
    const char* at = text.data() + expected.size();
    const char* const end = text.data() + text.size();
    while (at < end)
    {
        Measures row;
        for (const MeasureColumn& column : measure_columns())
        {
            const auto [next, error] = std::from_chars(at, end, column.in(row));
            if (error != std::errc{} || next == end)
            {
                throw InputError(
                    fmt::format("{}: line {}: bad number in column {}", name, rows.size() + 2, column.key));
            }
            at = next + 1; // the comma or the end of the line
        }
        rows.push_back(row);
    }
    return rows;
}

} // namespace corticle::metrics
