// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/case_checks.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/config/remodelling_keys.hpp"
#include "corticle/config/tissue_keys.hpp"
#include "corticle/prepare/body_maps.hpp"
#include "corticle/prepare/patterning.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;

constexpr double most_elongated = 20.0; // ratio of semi-axes

void check_geometry(const prepare::GeometryOptions& geometry, const Place& place)
{
    if (geometry.spacing_mm && geometry.particles)
    {
        throw InputError(fmt::format("geometry.spacing_mm{} and geometry.particles{} are both given: expected one",
                                     place("geometry.spacing_mm"), place("geometry.particles")));
    }
    if (geometry.shape == prepare::Shape::file && geometry.file.empty())
    {
        throw InputError(
            fmt::format("geometry.file{} is missing: got none, expected the path of a surface, label volume or tet "
                        "mesh, as "
                        "geometry.shape{} is \"file\"",
                        place("geometry.file"), place("geometry.shape")));
    }
    if (geometry.shape != prepare::Shape::file && !geometry.file.empty())
    {
        throw InputError(fmt::format("geometry.file{} is given, but geometry.shape{} is \"{}\": expected shape = "
                                     "\"file\"",
                                     place("geometry.file"), place("geometry.shape"),
                                     prepare::name_of(geometry.shape)));
    }
    const auto [least, most] = std::ranges::minmax(geometry.semi_axes_mm);
    if (geometry.shape == prepare::Shape::ellipsoid && most > most_elongated * least)
    {
        throw InputError(fmt::format("geometry.semi_axes_mm{} is out of range: got a ratio of {:.3g}, expected at "
                                     "most {}",
                                     place("geometry.semi_axes_mm"), most / least, most_elongated));
    }
}

/// Keys that only a body from a file has a use for.
void check_file_keys(const prepare::GeometryOptions& geometry, const Place& place)
{
    const auto require_file = [&](std::string_view key, bool is_set)
    {
        if (is_set && geometry.shape != prepare::Shape::file)
        {
            throw InputError(fmt::format("{}{} is given, but geometry.shape{} is \"{}\": expected shape = \"file\"",
                                         key, place(key), place("geometry.shape"), prepare::name_of(geometry.shape)));
        }
    };
    require_file("geometry.labels", !geometry.mask.labels.empty());
    require_file("geometry.image_volume", geometry.mask.volume.has_value());
    require_file("geometry.threshold", geometry.mask.threshold.has_value());
    if (geometry.mask.threshold && !geometry.mask.labels.empty())
    {
        throw InputError(fmt::format("geometry.threshold{} and geometry.labels{} are both given: expected one, as an "
                                     "image holds probabilities or labels",
                                     place("geometry.threshold"), place("geometry.labels")));
    }
    require_file("geometry.hemisphere", geometry.mask.hemisphere != imaging::Hemisphere::both);
    require_file("geometry.repair", geometry.repair != geometry::Repair::none);
    require_file("geometry.arrangement", geometry.arrangement != prepare::Arrangement::body_fitted &&
                                             geometry.arrangement != prepare::Arrangement::mesh_nodes);
}

/// Keys that belong to one method.
void check_method(const Options& options, const Place& place)
{
    const prepare::GeometryOptions& geometry = options.geometry;
    const char* const other = geometry.particles ? "geometry.particles" : "geometry.spacing_mm";
    if (options.elements && (geometry.particles || geometry.spacing_mm))
    {
        throw InputError(fmt::format("solver.elements{} and {}{} are both given: expected one",
                                     place("solver.elements"), other, place(other)));
    }
    const auto require = [&](std::string_view key, std::string_view got, bool holds, std::string_view expected)
    {
        if (options.method == model::Method::fem && !holds)
        {
            throw InputError(fmt::format("{}{} is \"{}\", but solver.method{} is \"fem\": expected {}", key, place(key),
                                         got, place("solver.method"), expected));
        }
    };
    const bool is_thinned = geometry.arrangement == prepare::Arrangement::thinned ||
                            geometry.arrangement == prepare::Arrangement::thinned_at_random;
    require("geometry.arrangement", prepare::name_of(geometry.arrangement), !is_thinned,
            "\"body_fitted\" or \"tet_nodes\"");
    require("geometry.volumes", "neighbour_count", geometry.volumes == prepare::VolumeRule::cells, "\"cells\"");
    require("geometry.normals", "divisions", geometry.normals == prepare::NormalRule::surface, "\"surface\"");
}

/// What fits a body that is round, or has cortex all around.
void check_box(const Options& options, const Place& place)
{
    const auto refuse = [&](std::string_view key, bool is_set, std::string_view expected)
    {
        if (is_set && options.geometry.shape == prepare::Shape::box)
        {
            throw InputError(fmt::format("{}{} is given, but geometry.shape{} is \"box\": expected {}", key, place(key),
                                         place("geometry.shape"), expected));
        }
    };
    const prepare::GeometryOptions& geometry = options.geometry;
    refuse("tissue.lambda", options.tissue.lambda > 0.0, "0, and tissue.thickness_mm");
    refuse("geometry.grading", geometry.grading > 1.0, "1");
    refuse("geometry.normals", geometry.normals != prepare::NormalRule::surface, "\"surface\"");
    refuse("geometry.volumes", geometry.volumes != prepare::VolumeRule::cells, "\"cells\"");
}

/// Growth maps in time: as many arrays as times.
void check_growth_times(const prepare::MapOptions& map, const Place& place)
{
    if (map.growth_times.empty())
    {
        return;
    }
    const std::size_t arrays = prepare::growth_arrays(map).size();
    if (map.growth_file.empty() || arrays != map.growth_times.size())
    {
        throw InputError(fmt::format("map.growth_times{} has {} times: got {} names in map.growth_array{}{}, expected "
                                     "map.growth_file with a name for each time",
                                     place("map.growth_times"), map.growth_times.size(), arrays,
                                     place("map.growth_array"),
                                     map.growth_file.empty() ? " and no map.growth_file" : ""));
    }
}

void check_maps(const prepare::MapOptions& map, const Place& place)
{
    if (map.region_file.empty() != map.region_table.empty())
    {
        const auto [given, missing] = map.region_file.empty() ? std::pair("map.region_table", "map.region_file")
                                                              : std::pair("map.region_file", "map.region_table");
        throw InputError(
            fmt::format("{}{} is given without {}: expected both or neither", given, place(given), missing));
    }
    check_growth_times(map, place);
    if (map.modes.size() > prepare::growth_mode_count)
    {
        throw InputError(fmt::format("map.modes{}: got {} amplitudes, expected at most {}", place("map.modes"),
                                     map.modes.size(), prepare::growth_mode_count));
    }
    for (const std::string_view key : {"map.protomap_wavelength_mm", "map.protomap_seed"})
    {
        if (map.protomap_amplitude == 0.0 && !place(key).empty())
        {
            throw InputError(fmt::format("{}{} is given, but map.protomap_amplitude{} is 0: expected a number above 0, "
                                         "or no such key",
                                         key, place(key), place("map.protomap_amplitude")));
        }
    }
}

/// A graded spacing is of particles that are arranged, with the supports that go with it.
void check_grading(const Options& options, const Place& place)
{
    if (options.geometry.grading <= 1.0)
    {
        return;
    }
    const auto refuse = [&](std::string_view key, std::string_view got, std::string_view expected)
    {
        throw InputError(fmt::format("geometry.grading{} is {:g}, but {}{} is {}: expected {}, or grading = 1",
                                     place("geometry.grading"), options.geometry.grading, key, place(key), got,
                                     expected));
    };
    if (options.method == model::Method::fem)
    {
        refuse("solver.method", "\"fem\"", "\"tlsph\"");
    }
    if (options.geometry.arrangement != prepare::Arrangement::body_fitted)
    {
        refuse("geometry.arrangement", fmt::format("\"{}\"", prepare::name_of(options.geometry.arrangement)),
               "\"body_fitted\"");
    }
    if (options.tlsph.kernel_mm > 0.0)
    {
        refuse("solver.kernel_mm", fmt::format("{:g}", options.tlsph.kernel_mm), "0");
    }
    if (options.geometry.volumes != prepare::VolumeRule::cells)
    {
        refuse("geometry.volumes", "\"neighbour_count\"", "\"cells\"");
    }
    if (options.formulation != thesis::Formulation::corrected)
    {
        refuse("solver.formulation", "\"thesis\"", "\"corrected\"");
    }
}

void check_particle_count(const prepare::GeometryOptions& geometry, const Place& place)
{
    if (!geometry.spacing_mm || geometry.shape == prepare::Shape::file || geometry.grading > 1.0)
    {
        return; // known once the file is read
    }
    const double count = shape_volume(geometry) / std::pow(*geometry.spacing_mm, 3);
    if (!(count >= static_cast<double>(prepare::fewest_particles) &&
          count <= static_cast<double>(prepare::most_particles)))
    {
        throw InputError(fmt::format("geometry.spacing_mm{} is out of range: got {}, which gives about {:.3g} "
                                     "particles, expected {} to {}",
                                     place("geometry.spacing_mm"), *geometry.spacing_mm, count,
                                     prepare::fewest_particles, prepare::most_particles));
    }
}

void check_tissue(const Options& options, const Place& place)
{
    const material::TissueOptions& tissue = options.tissue;
    if (tissue.lambda > 0.0 && tissue.layer != material::Layer::binary)
    {
        throw InputError(fmt::format("tissue.lambda{} is out of range: got {}, expected 0 unless tissue.layer is "
                                     "\"binary\"",
                                     place("tissue.lambda"), tissue.lambda));
    }
    if (tissue.lambda > 0.0 && tissue.thickness_rate_mm != 0.0)
    {
        throw InputError(fmt::format("tissue.thickness_rate_mm{} is out of range: got {}, expected 0 where "
                                     "tissue.lambda sets the thickness",
                                     place("tissue.thickness_rate_mm"), tissue.thickness_rate_mm));
    }
    const double last = tissue.thickness_mm + tissue.thickness_rate_mm * options.time.end;
    if (!(last > 0.0))
    {
        throw InputError(fmt::format("tissue.thickness_rate_mm{} is out of range: got {}, which leaves a thickness of "
                                     "{:.3g} mm at the end, expected more than 0",
                                     place("tissue.thickness_rate_mm"), tissue.thickness_rate_mm, last));
    }
}

void check_imperfection(const material::ImperfectionOptions& imperfection, const Place& place)
{
    if (imperfection.shortest > imperfection.longest)
    {
        throw InputError(fmt::format("imperfection.shortest{} is out of range: got {}, expected at most "
                                     "imperfection.longest{}, {}",
                                     place("imperfection.shortest"), imperfection.shortest,
                                     place("imperfection.longest"), imperfection.longest));
    }
}

void check_solver(const Options& options, const Place& place)
{
    if (options.dynamics.integrator == dynamics::Integrator::rk4 && options.contact.enabled)
    {
        throw InputError(fmt::format("contact.enabled{} is true, but solver.integrator{} is \"rk4\": expected "
                                     "\"symplectic_euler\", whose steps keep surfaces from crossing",
                                     place("contact.enabled"), place("solver.integrator")));
    }
}

} // namespace

double shape_volume(const prepare::GeometryOptions& geometry)
{
    constexpr double factor = 4.0 / 3.0 * std::numbers::pi;
    if (geometry.shape == prepare::Shape::sphere)
    {
        return factor * std::pow(geometry.radius_mm, 3);
    }
    if (geometry.shape == prepare::Shape::box)
    {
        return geometry.size_mm[0] * geometry.size_mm[1] * geometry.size_mm[2];
    }
    const auto& axes = geometry.semi_axes_mm;
    return geometry.shape == prepare::Shape::ellipsoid ? factor * axes[0] * axes[1] * axes[2] : 0.0;
}

void check_case(const Options& options, const Place& place)
{
    check_geometry(options.geometry, place);
    check_file_keys(options.geometry, place);
    check_method(options, place);
    check_grading(options, place);
    check_box(options, place);
    check_maps(options.map, place);
    check_particle_count(options.geometry, place);
    check_tissue(options, place);
    check_tissue_keys(options, place);
    check_remodelling(options, place);
    check_imperfection(options.imperfection, place);
    check_solver(options, place);
}

std::vector<std::string> dropped_outputs(const Options& options, double from, std::span<const double> recorded)
{
    const model::TimeOptions& time = options.time;
    std::vector<std::string> warnings;
    const auto add =
        [&](std::string_view key, std::span<const double> asked, const std::string& span, auto&& growth_time_of)
    {
        std::vector<double> outside;
        std::vector<double> passed;
        for (const double value : asked)
        {
            const double t = growth_time_of(value);
            const bool is_recorded = std::ranges::any_of(recorded, [&](double known)
                                                         { return std::abs(known - t) < model::same_output_time; });
            if (t < time.start - model::same_output_time || t > time.end + model::same_output_time)
            {
                outside.push_back(value);
            }
            else if (t < from - model::same_output_time && !is_recorded)
            {
                passed.push_back(value);
            }
        }
        if (!outside.empty())
        {
            warnings.push_back(
                fmt::format("{}: {} outside the run, {}: left out", key, fmt::join(outside, ", "), span));
        }
        if (!passed.empty())
        {
            warnings.push_back(fmt::format("{}: {} passed before the run is resumed at t = {:g}: left out", key,
                                           fmt::join(passed, ", "), from));
        }
    };
    const std::string span = fmt::format("t = {:g} to {:g}", time.start, time.end);
    const auto as_given = [](double t) { return t; };
    add("output.times", options.output.times, span, as_given);
    add("output.picture_times", options.output.picture_times, span, as_given);
    add("output.weeks", options.output.weeks,
        fmt::format("weeks {:g} to {:g}", time.start_week.value_or(0.0), time.end_week.value_or(0.0)),
        [&](double week) { return std::max(0.0, material::growth_time(time.clock, week)); });
    return warnings;
}

std::vector<std::string> case_warnings(const Options& options)
{
    std::vector<std::string> warnings = dropped_outputs(options, options.time.start);
    if (options.size.law == material::LengthLaw::hyperbolic && options.time.clock == material::GestationalClock::wang)
    {
        warnings.emplace_back("size.law = \"hyperbolic\" belongs to time.clock = \"cubic\": with \"wang\" its lengths "
                              "are those of other weeks");
    }
    if (!options.contact.enabled && options.formulation == thesis::Formulation::corrected)
    {
        warnings.emplace_back("contact is off: folds will pass through each other");
    }
    return warnings;
}

} // namespace corticle::config
