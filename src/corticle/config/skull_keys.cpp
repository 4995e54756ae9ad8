// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/boundary_keys.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/mechanics/boundary/skull.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;
using boundary::BoundaryOptions;
using boundary::Fluid;
using boundary::SkullShape;

/// Refuses a key that nothing uses in this case and that has another value than by default.
void refuse(const Options& options, std::string_view key, bool is_idle, std::string_view expected, const Place& place)
{
    const Parameter* parameter = find_parameter(key);
    const std::string value = toml_text(parameter->get(options));
    if (is_idle && !value.empty() && value != toml_text(parameter->get(Options{})))
    {
        throw InputError(
            fmt::format("{}{} is {}, but does nothing here: expected {}", key, place(key), value, expected));
    }
}

void check_shape(const Options& options, const Place& place)
{
    const BoundaryOptions& skull = options.boundary;
    if (skull.shape == SkullShape::file && skull.file.empty())
    {
        throw InputError(fmt::format("boundary.file is missing: got none, expected the path of a closed surface, as "
                                     "boundary.shape{} is \"file\"",
                                     place("boundary.shape")));
    }
    if (skull.shape == SkullShape::none && !place("boundary.shape").empty())
    {
        return; // a skull that was switched off
    }
    const bool none = skull.shape == SkullShape::none;
    refuse(options, "boundary.file", skull.shape != SkullShape::file, "boundary.shape = \"file\"", place);
    refuse(options, "boundary.offset_mm", skull.shape != SkullShape::offset, "boundary.shape = \"offset\"", place);
    refuse(options, "boundary.semi_axes_mm", skull.shape != SkullShape::ellipsoid, "boundary.shape = \"ellipsoid\"",
           place);
    refuse(options, "boundary.centre_mm", skull.shape != SkullShape::ellipsoid, "boundary.shape = \"ellipsoid\"",
           place);
    for (const std::string_view key : {"boundary.kind", "boundary.times", "boundary.weeks", "boundary.scales"})
    {
        refuse(options, key, none, "a boundary.shape", place);
    }
    refuse(options, "boundary.stiffness", none || skull.kind != boundary::SkullKind::elastic,
           "boundary.kind = \"elastic\"", place);
}

void check_fluid(const Options& options, const Place& place)
{
    const BoundaryOptions& skull = options.boundary;
    if (skull.fluid == Fluid::conserved && skull.shape == SkullShape::none)
    {
        throw InputError(fmt::format("boundary.fluid{} is \"conserved\", but boundary.shape{} is \"none\": expected a "
                                     "skull that encloses the fluid",
                                     place("boundary.fluid"), place("boundary.shape")));
    }
    if (skull.ventricle_pressure != 0.0 &&
        options.labels[static_cast<std::size_t>(material::TissueKind::ventricle)].empty())
    {
        throw InputError(fmt::format("boundary.ventricle_pressure{} is {:g}, but no label says where the ventricles "
                                     "are: expected tissue.labels.ventricle",
                                     place("boundary.ventricle_pressure"), skull.ventricle_pressure));
    }
    if (skull.fluid == Fluid::none && !place("boundary.fluid").empty())
    {
        return; // a fluid that was switched off
    }
    refuse(options, "boundary.pressure", skull.fluid != Fluid::constant, "boundary.fluid = \"constant\"", place);
    refuse(options, "boundary.pressure_time", skull.fluid != Fluid::constant && skull.ventricle_pressure == 0.0,
           "a pressure that rises", place);
    refuse(options, "boundary.bulk_modulus", skull.fluid != Fluid::conserved, "boundary.fluid = \"conserved\"", place);
}

/// What keeps brain and skull apart.
void require_contact(const Options& options, const Place& place)
{
    if (options.boundary.shape == SkullShape::none)
    {
        return;
    }
    if (!options.contact.enabled)
    {
        throw InputError(fmt::format("boundary.shape{} is given, but contact.enabled{} is false: expected contact, "
                                     "which keeps brain and skull apart",
                                     place("boundary.shape"), place("contact.enabled")));
    }
    if (options.formulation != thesis::Formulation::corrected)
    {
        throw InputError(fmt::format("boundary.shape{} is given, but solver.formulation{} is \"thesis\": expected "
                                     "\"corrected\"",
                                     place("boundary.shape"), place("solver.formulation")));
    }
}

void settle_times(Options& options, const Place& place)
{
    BoundaryOptions& skull = options.boundary;
    if (!skull.weeks.empty() && options.time.clock == material::GestationalClock::none)
    {
        throw InputError(fmt::format("boundary.weeks{} is given, but time.clock{} is \"none\": expected a clock, or "
                                     "boundary.times",
                                     place("boundary.weeks"), place("time.clock")));
    }
    if (!skull.weeks.empty() && !place("boundary.times").empty())
    {
        throw InputError(fmt::format("boundary.times{} and boundary.weeks{} are both given: expected one",
                                     place("boundary.times"), place("boundary.weeks")));
    }
    if (!skull.weeks.empty())
    {
        skull.times.clear();
        for (const double week : skull.weeks)
        {
            skull.times.push_back(material::growth_time(options.time.clock, week));
        }
    }
    if (skull.times.size() != skull.scales.size())
    {
        throw InputError(fmt::format("boundary.scales{} has {} numbers, expected {}, one for each time",
                                     place("boundary.scales"), skull.scales.size(), skull.times.size()));
    }
    const double first = boundary::SkullGrowth(skull.times, skull.scales).scale(options.time.start);
    if (std::abs(first - 1.0) > 1e-9)
    {
        throw InputError(fmt::format("boundary.scales{} is out of range: got {:g} at the start of the run, expected 1, "
                                     "as the skull is given there",
                                     place("boundary.scales"), first));
    }
}

void check_tracts(const Options& options, const Place& place)
{
    for (const std::string_view key : {"tracts.stiffness", "tracts.rest", "tracts.ramp_time", "tracts.growth_rate",
                                       "tracts.pushes", "tracts.reach_mm"})
    {
        refuse(options, key, options.tracts.file.empty(), "tracts.file", place);
    }
}

} // namespace

void settle_boundary(Options& options, const Place& place)
{
    check_tracts(options, place);
    check_shape(options, place);
    check_fluid(options, place);
    require_contact(options, place);
    settle_times(options, place);
}

} // namespace corticle::config
