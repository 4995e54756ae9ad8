// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/boundary_parameters.hpp"

#include "corticle/config/parameters/parameter_builders.hpp"

#include <fmt/format.h>

namespace corticle::config
{

namespace
{

using namespace detail;
using boundary::SupportOptions;

/// A key of the support of this number, from 0.
template <class T>
Parameter support_key(std::size_t number, std::string_view name, std::string unit, Range range, std::string sentence,
                      T SupportOptions::*member)
{
    Parameter result =
        described<T>(fmt::format("support.{}.{}", number + 1, name), std::move(unit), range, std::move(sentence));
    result.of_list = true;
    result.get = [number, member](const Options& options) -> Value {
        return number < options.supports.size() ? Member<T>::get(options.supports[number].*member)
                                                : Value(Unsupported{});
    };
    result.set = [number, member](Options& options, const Value& value)
    {
        options.supports.resize(std::max(options.supports.size(), number + 1));
        Member<T>::set(options.supports[number].*member, value);
    };
    return result;
}

/// Growth times, which weeks replace where there is a clock.
template <class T>
Parameter support_time(std::size_t number, std::string_view name, std::string sentence, T SupportOptions::*member)
{
    return without_clock(support_key(number, name, "t", between(0.0, 1.0), std::move(sentence), member));
}

std::vector<Parameter> parameters_of_support(std::size_t k)
{
    const Range anywhere = between(-1e9, 1e9);
    const Range weeks = between(0.0, 100.0);
    return {
        with_example(support_key(k, "kind", "", {}, "Whether nodes are held, held along axes, or moved along axes.",
                                 &SupportOptions::kind),
                     "\"fixed\""),
        with_example(support_key(k, "plane", "", {}, "The face of the box around the body whose nodes it holds.",
                                 &SupportOptions::plane),
                     "\"z_min\""),
        with_example(support_key(k, "low_mm", "mm", anywhere,
                                 "Lower corner of a box: nodes outside are not held, on a plane neither.",
                                 &SupportOptions::low_mm),
                     "[-1.0, -1.0, -1.0]"),
        with_example(support_key(k, "high_mm", "mm", anywhere, "Upper corner of that box.", &SupportOptions::high_mm),
                     "[1.0, 1.0, 1.0]"),
        with_example(support_key(k, "axes", "", {},
                                 "Along which axes a roller or a displacement holds; none: the normal of the plane.",
                                 &SupportOptions::axes),
                     "\"x\""),
        with_example(support_key(k, "displacement_mm", "mm", between(-1000.0, 1000.0),
                                 "Where a displacement has moved its nodes at the end of its ramp.",
                                 &SupportOptions::displacement_mm),
                     "[-1.0, 0.0, 0.0]"),
        with_example(support_time(k, "start", "Growth time at which it begins to move.", &SupportOptions::start),
                     "0.0"),
        with_example(support_time(k, "end", "Growth time at which it has moved all the way.", &SupportOptions::end),
                     "1.0"),
        with_example(support_key(k, "start_week", "weeks", weeks, "Instead of start, with a clock.",
                                 &SupportOptions::start_week),
                     "23.0"),
        with_example(
            support_key(k, "end_week", "weeks", weeks, "Instead of end, with a clock.", &SupportOptions::end_week),
            "38.0"),
    };
}

} // namespace

#define CORTICLE_MEMBER(name) ([](auto& options) -> auto& { return options.boundary.name; })

std::vector<Parameter> boundary_parameters()
{
    return {
        parameter("boundary.shape", "", {},
                  "Where the skull comes from: none, the surface of the body at a distance, "
                  "an ellipsoid, or a file.",
                  CORTICLE_MEMBER(shape)),
        parameter("boundary.offset_mm", "mm", above(0.0, 1000.0), "Distance of an offset skull from the body.",
                  CORTICLE_MEMBER(offset_mm)),
        parameter("boundary.semi_axes_mm", "mm", above(0.0, 1000.0), "Semi-axes of an ellipsoid.",
                  CORTICLE_MEMBER(semi_axes_mm)),
        parameter("boundary.centre_mm", "mm", between(-1e6, 1e6), "Its centre.", CORTICLE_MEMBER(centre_mm)),
        path("boundary.file", "Closed triangulated surface of the skull, in the unit and coordinates of geometry.file.",
             CORTICLE_MEMBER(file)),
        parameter("boundary.kind", "", {}, "Whether the skull is where its growth says, or on springs to there.",
                  CORTICLE_MEMBER(kind)),
        parameter("boundary.stiffness", "mu_w/mm", above(0.0, 1e6),
                  "Pressure on an elastic skull over its displacement.", CORTICLE_MEMBER(stiffness)),
        without_clock(parameter("boundary.times", "t", between(0.0, 1.0),
                                "Growth times of boundary.scales, increasing.", CORTICLE_MEMBER(times))),
        parameter("boundary.weeks", "weeks", between(0.0, 100.0), "The same in weeks, with a clock.",
                  CORTICLE_MEMBER(weeks)),
        in_any_order(parameter("boundary.scales", "", above(0.0, 100.0),
                               "Size of the skull at these times over that at the start, about its centre, linear in "
                               "between; empty: it does not grow.",
                               CORTICLE_MEMBER(scales))),
        parameter("boundary.fluid", "", {},
                  "Fluid that presses on the brain: none, one of constant pressure, or one of constant volume between "
                  "brain and skull.",
                  CORTICLE_MEMBER(fluid)),
        parameter("boundary.pressure", "mu_w", between(-10.0, 10.0), "Pressure of a constant one.",
                  CORTICLE_MEMBER(pressure)),
        parameter("boundary.pressure_time", "t", above(0.0, 1.0),
                  "Growth time in which pressures rise from 0 at the start of the run.",
                  CORTICLE_MEMBER(pressure_time)),
        parameter("boundary.bulk_modulus", "mu_w", above(0.0, 1e4), "Bulk modulus of a conserved one.",
                  CORTICLE_MEMBER(bulk_modulus)),
        parameter("boundary.ventricle_pressure", "mu_w", between(-10.0, 10.0),
                  "Pressure in labelled ventricles (tissue.labels.ventricle) above that outside; 0: none.",
                  CORTICLE_MEMBER(ventricle_pressure)),
    };
}

#undef CORTICLE_MEMBER

#define CORTICLE_MEMBER(name) ([](auto& options) -> auto& { return options.tracts.name; })

std::vector<Parameter> tract_parameters()
{
    return {
        path("tracts.file",
             "CSV of tracts of axons: columns from and to, labels of map.region_file, or from_x, from_y, from_z, to_x, "
             "to_y, to_z in mm; columns stiffness, rest and growth_rate in place of the keys below.",
             CORTICLE_MEMBER(file)),
        parameter("tracts.stiffness", "mu_w mm", above(0.0, 1e9), "Force of a tract over its elongation.",
                  CORTICLE_MEMBER(stiffness)),
        parameter("tracts.rest", "", between(0.0, 10.0),
                  "Rest length of a tract over its length at the start; below 1 it pulls from the start.",
                  CORTICLE_MEMBER(rest)),
        parameter("tracts.ramp_time", "t", above(0.0, 1.0),
                  "Growth time in which it gets there from the length at the start.", CORTICLE_MEMBER(ramp_time)),
        parameter("tracts.growth_rate", "1/t, or 1/weeks with a clock", between(0.0, 1000.0),
                  "Rate at which the rest length of a stretched tract approaches its length.", CORTICLE_MEMBER(rate)),
        parameter("tracts.pushes", "", {}, "Whether a tract shorter than its rest length pushes.",
                  CORTICLE_MEMBER(pushes)),
        parameter("tracts.reach_mm", "mm", between(0.0, 1000.0),
                  "Distance about the place of an end within which it holds on to the tissue; 0: two spacings.",
                  CORTICLE_MEMBER(radius_mm)),
    };
}

#undef CORTICLE_MEMBER

std::vector<Parameter> support_parameters()
{
    std::vector<Parameter> all;
    for (std::size_t k = 0; k < boundary::most_supports; ++k)
    {
        std::ranges::move(parameters_of_support(k), std::back_inserter(all));
    }
    return all;
}

} // namespace corticle::config
