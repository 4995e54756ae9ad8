// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/boundary_measures.hpp"

#include "corticle/geometry/self_intersections.hpp"
#include "corticle/mechanics/boundary/fluid_term.hpp"
#include "corticle/mechanics/boundary/skull_term.hpp"
#include "corticle/mechanics/tracts/tract_term.hpp"

#include <cmath>

namespace corticle::metrics
{

namespace
{

/// Triangles of the brain and the skull together that cross another one, less those of the brain that cross each other.
double skull_intersections(const model::OutputView& view, const boundary::Skull& skull)
{
    TriangleMesh both{view.as_folded, view.model().cloud.surface_triangles};
    const auto alone = geometry::intersecting_triangles(both);
    const auto first = static_cast<std::int32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), skull.positions().begin(), skull.positions().end());
    for (const auto& [a, b, c] : skull.triangles())
    {
        both.triangles.push_back({first + a, first + b, first + c});
    }
    return static_cast<double>(geometry::intersecting_triangles(both) - alone);
}

void add_skull(const model::OutputView& view, const boundary::Skull& skull, BoundaryMeasures& m)
{
    const contact::WallContact contact = view.simulation.wall_contact();
    const std::vector<double> areas = vertex_areas(view.as_folded, view.triangles());
    double touching = 0.0;
    double area = 0.0;
    for (std::size_t k = 0; k < areas.size(); ++k)
    {
        area += areas[k];
        touching += contact.is_pushed.empty() || contact.is_pushed[k] == 0 ? 0.0 : areas[k];
    }
    const double length = view.scale.length;
    m.skull_force = contact.force;
    m.skull_pressure = contact.force / surface_area(skull.positions(), skull.triangles());
    m.skull_contact_share = touching / area;
    m.skull_intersections = skull_intersections(view, skull);
    m.skull_volume_mm3 = skull.enclosed_volume() * std::pow(length, 3);
}

} // namespace

BoundaryMeasures boundary_measures(const model::OutputView& view)
{
    BoundaryMeasures m;
    for (const auto& term : view.simulation.terms())
    {
        if (const auto* skull = dynamic_cast<const boundary::SkullTerm*>(term.get()); skull != nullptr)
        {
            add_skull(view, skull->skull(), m);
        }
        if (const auto* fluid = dynamic_cast<const boundary::FluidTerm*>(term.get()); fluid != nullptr)
        {
            const double volume_scale = std::pow(view.scale.length, 3);
            m.fluid_pressure = fluid->pressure();
            m.fluid_volume_mm3 = fluid->outer_volume() * volume_scale;
            m.ventricle_volume_mm3 = fluid->ventricle_volume() * volume_scale;
        }
    }
    for (const auto& term : view.simulation.terms())
    {
        if (const auto* tracts = dynamic_cast<const tracts::TractTerm*>(term.get()); tracts != nullptr)
        {
            for (const tracts::TractState& state : tracts->states())
            {
                m.tract_tension += state.tension;
                m.tract_stretch += state.length / state.rest_length / static_cast<double>(tracts->states().size());
            }
        }
    }
    for (const auto& [name, value] : view.simulation.energies())
    {
        m.energy_skull += name.starts_with("skull") ? value : 0.0;
        m.energy_fluid += name == "fluid" ? value : 0.0;
        m.energy_tracts += name == "tracts" ? value : 0.0;
    }
    return m;
}

} // namespace corticle::metrics
