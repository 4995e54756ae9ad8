// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/run_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::record
{

namespace
{

// Growth sets in with a jerk from rest, which the damping has taken by then: until then stresses are small and nothing
// can be said of their balance.
constexpr double starting_time = 0.05;

// The sharp bends of creases squeeze up to 4 % of the particles in sound runs, and flatten up to 0.6 % of the tets.
constexpr double most_squeezed = 0.1;
constexpr double most_flat = 0.01;

constexpr double most_limited = 0.01; ///< of the work of growth, taken by the travel limit of contact

/// A share above which a run is not what it should be, and what to do about it.
struct Limit
{
    std::string_view kind;
    double metrics::EquilibriumMeasures::*value;
    double most;
    std::string_view what;   ///< subject and verb; the share follows
    std::string_view of;     ///< what it is a share of
    std::string_view advice; ///< why it matters and what to change
};

constexpr std::array limits{
    Limit{"zero_mode_share", &metrics::EquilibriumMeasures::zero_mode_share, 0.05, "the zero-energy control holds",
          "the elastic energy",
          "the cloud is coarse for these folds and acts stiffer than the tissue; more particles lower it"},
    Limit{"kinetic_share", &metrics::EquilibriumMeasures::kinetic_share, 0.10, "the kinetic energy is",
          "the elastic energy", "growth is too fast to be quasi-static; a larger solver.loading_time lowers it"},
    Limit{"residual_force", &metrics::EquilibriumMeasures::residual_force, 0.10, "the residual force is",
          "the internal force",
          "the body is not in equilibrium and lags behind its growth; a larger solver.loading_time or a smaller "
          "solver.damping lowers it"},
    Limit{"dissipated_share", &metrics::EquilibriumMeasures::dissipated_share, 0.25, "drag and contact have dissipated",
          "the work of growth",
          "growth is not quasi-static; a larger solver.loading_time or a smaller solver.damping lowers it"},
    Limit{"energy_balance_error", &metrics::EquilibriumMeasures::energy_balance_error, 0.01,
          "the energy balance is off by", "the work of growth",
          "the steps make or lose energy; a smaller solver.cfl, solver.damping or contact.stiffness may lower it"}};

std::string at_place(const Vec3& place)
{
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", place.x, place.y, place.z);
}

/// Counts that are 0 or few in a sound state.
void add_counts(const metrics::Measures& row, const RunSize& run, std::vector<RunWarning>& warnings)
{
    const auto add =
        [&](std::string_view kind, double count, double most, std::string_view what, std::string_view advice)
    {
        if (count > most)
        {
            warnings.push_back({kind, fmt::format("at t = {:.3f} {:.0f} {}, J is smallest near {}: {}", row.t, count,
                                                  what, at_place(row.smallest_J_place), advice)});
        }
    };
    add("inverted_elements", row.inverted_elements, 0.0, "tets are inverted (det F <= 0)",
        "what is around them is not to be trusted; more elements or a larger solver.loading_time may help");
    add("extrapolated_elements", row.extrapolated_elements, most_flat * run.elements,
        fmt::format("tets (of {:.0f}) are flat in one direction, where their law is extrapolated", run.elements),
        "the creases are too sharp for them; more elements may help");
    add("barrier_particles", row.barrier_particles, most_squeezed * run.nodes,
        fmt::format("particles or nodes (of {:.0f}) are squeezed below tissue.barrier_J", run.nodes),
        "the barrier holds them, not the tissue; more particles or a larger solver.loading_time may help");
    if (row.intersecting_triangles > 0.0)
    {
        warnings.push_back({"intersecting_triangles",
                            fmt::format("at t = {:.3f} {:.0f} triangles of the surface intersect others: surfaces have "
                                        "crossed",
                                        row.t, row.intersecting_triangles)});
    }
    if (row.energy_contact_limit > most_limited * std::max(row.work_growth, 0.0))
    {
        warnings.push_back(
            {"energy_contact_limit",
             fmt::format("at t = {:.3f} the travel limit of contact has taken {:.1f} % of the work of "
                         "growth (above {:.0f} %): surfaces are held apart by it and not by forces; a "
                         "larger solver.loading_time or contact.stiffness lowers it",
                         row.t, 100.0 * row.energy_contact_limit / row.work_growth, 100.0 * most_limited)});
    }
    if (row.overlap_area_share > 0.0)
    {
        warnings.push_back(
            {"overlap_area_share",
             fmt::format("at t = {:.3f} {:.2g} % of the surface lies within another part of the body, "
                         "{:.2g} mm deep near {}: surfaces have crossed",
                         row.t, 100.0 * row.overlap_area_share, row.max_penetration_mm, at_place(row.overlap_place))});
    }
}

} // namespace

RunSize size_of_run(const model::Simulation& simulation)
{
    const model::Model& model = simulation.model();
    const model::SimulationOptions& options = simulation.options();
    return {std::max(options.time.start, options.tissue.growth_onset),
            static_cast<double>(model.cloud.positions.size()),
            model.fem ? static_cast<double>(model.fem->elements.tets.size()) : 0.0};
}

std::vector<RunWarning> run_warnings(const metrics::Measures& row, const RunSize& run)
{
    std::vector<RunWarning> warnings;
    const bool has_set_in = row.t >= run.start_t + starting_time;
    for (const Limit& limit : limits)
    {
        const double share = row.*limit.value;
        if (has_set_in && !(share <= limit.most)) // NaN too
        {
            warnings.push_back(
                {limit.kind, fmt::format("at t = {:.3f} {} {:.1f} % of {} (above {:.0f} %): {}", row.t, limit.what,
                                         100.0 * share, limit.of, 100.0 * limit.most, limit.advice)});
        }
    }
    add_counts(row, run, warnings);
    return warnings;
}

} // namespace corticle::record
