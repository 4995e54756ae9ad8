// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace corticle
{

namespace
{

/// Names of enumerators, in their order.
template <class Enum>
std::vector<std::string> names();
template <>
std::vector<std::string> names<Layer>()
{
    return {"smooth", "binary"};
}
template <>
std::vector<std::string> names<BulkRule>()
{
    return {"per_tissue", "uniform"};
}

/// How a member of Options is read and written as a Value.
template <class T>
struct Member
{
    static constexpr Kind kind = std::is_same_v<T, bool>           ? Kind::boolean
                                 : std::is_same_v<T, std::int64_t> ? Kind::integer
                                 : std::is_same_v<T, double>       ? Kind::real
                                 : std::is_same_v<T, std::string>  ? Kind::text
                                                                   : Kind::list;
    static Value get(const T& member) { return member; }
    static void set(T& member, const Value& value) { member = std::get<T>(value); }
};

template <class T>
struct Member<std::optional<T>>
{
    static constexpr Kind kind = Member<T>::kind;
    static Value get(const std::optional<T>& member) { return member ? Value(*member) : Value(Unsupported{}); }
    static void set(std::optional<T>& member, const Value& value) { member = std::get<T>(value); }
};

template <std::size_t size>
struct Member<std::array<double, size>>
{
    static constexpr Kind kind = Kind::list;
    static Value get(const std::array<double, size>& member)
    {
        return std::vector<double>(member.begin(), member.end());
    }
    static void set(std::array<double, size>& member, const Value& value)
    {
        std::ranges::copy(std::get<std::vector<double>>(value), member.begin());
    }
};

template <class T>
requires std::is_enum_v<T>
struct Member<T>
{
    static constexpr Kind kind = Kind::choice;
    static Value get(const T& member) { return names<T>().at(static_cast<std::size_t>(member)); }
    static void set(T& member, const Value& value)
    {
        const auto all = names<T>();
        member = static_cast<T>(std::ranges::find(all, std::get<std::string>(value)) - all.begin());
    }
};

template <class T>
inline constexpr std::size_t list_length = 0;
template <std::size_t size>
inline constexpr std::size_t list_length<std::array<double, size>> = size;

/// A parameter kept in the member that `access(options)` refers to.
template <class Access>
Parameter parameter(std::string key, std::string unit, Range range, std::string sentence, Access access)
{
    using T = std::remove_cvref_t<decltype(access(std::declval<Options&>()))>;
    Parameter result;
    result.key = std::move(key);
    result.kind = Member<T>::kind;
    result.unit = std::move(unit);
    result.range = range;
    result.length = list_length<T>;
    result.sentence = std::move(sentence);
    if constexpr (std::is_enum_v<T>)
    {
        result.choices = names<T>();
    }
    result.get = [access](const Options& options) { return Member<T>::get(access(options)); };
    result.set = [access](Options& options, const Value& value) { Member<T>::set(access(options), value); };
    return result;
}

/// A text that must be one of `choices`.
template <class Access>
Parameter choice(std::string key, std::vector<std::string> choices, std::string sentence, Access access)
{
    Parameter result = parameter(std::move(key), "", {}, std::move(sentence), access);
    result.kind = Kind::choice;
    result.choices = std::move(choices);
    return result;
}

/// A parameter with one possible value, kept nowhere.
Parameter constant(std::string key, const std::string& value, std::string sentence)
{
    Parameter result;
    result.key = std::move(key);
    result.kind = Kind::choice;
    result.choices = {value};
    result.sentence = std::move(sentence);
    result.get = [value](const Options&) -> Value { return value; };
    result.set = [](Options&, const Value&) {};
    return result;
}

Range above(double low, double high = std::numeric_limits<double>::infinity())
{
    return {low, high, true};
}
Range between(double low, double high)
{
    return {low, high, false};
}
Range at_least(double low)
{
    return {low, std::numeric_limits<double>::infinity(), false};
}

// The accessors: `[](auto& o) -> auto&` gives the member of an Options, const or not.
#define CORTICLE_MEMBER(path) ([](auto& options) -> auto& { return options.path; })

std::vector<Parameter> geometry_parameters()
{
    return {
        choice("geometry.shape", {"sphere", "ellipsoid", "file"}, "Where the body comes from.",
               CORTICLE_MEMBER(geometry.shape)),
        parameter("geometry.radius_mm", "mm", above(0.0, 1000.0), "Radius of the sphere.",
                  CORTICLE_MEMBER(geometry.radius_mm)),
        parameter("geometry.semi_axes_mm", "mm", above(0.0, 1000.0), "Semi-axes of the ellipsoid.",
                  CORTICLE_MEMBER(geometry.semi_axes_mm)),
        parameter("geometry.file", "", {},
                  "Closed triangulated surface (STL, OBJ, PLY, OFF, VTP), relative to the case; needed by shape = "
                  "\"file\".",
                  CORTICLE_MEMBER(geometry.file)),
        choice("geometry.unit", {"mm", "cm", "m"}, "Unit of length of the file.", CORTICLE_MEMBER(geometry.unit)),
        parameter("geometry.spacing_mm", "mm", above(0.0, 1000.0),
                  "Distance between neighbouring particles; instead of particles.",
                  CORTICLE_MEMBER(geometry.spacing_mm)),
        parameter("geometry.particles", "",
                  between(static_cast<double>(fewest_particles), static_cast<double>(most_particles)),
                  "About this many particles; instead of spacing_mm.", CORTICLE_MEMBER(geometry.particles)),
        parameter("geometry.seed", "", at_least(0.0), "Seed of the arrangement of particles.",
                  CORTICLE_MEMBER(geometry.seed)),
    };
}

std::vector<Parameter> tissue_parameters()
{
    return {
        parameter("tissue.layer", "", {}, "Transition from cortex to white matter.", CORTICLE_MEMBER(tissue.layer)),
        parameter("tissue.thickness_mm", "mm", above(0.0, 100.0), "Thickness of the cortex at t = 0.",
                  CORTICLE_MEMBER(tissue.thickness_mm)),
        parameter("tissue.thickness_rate_mm", "mm", between(-100.0, 100.0),
                  "Change of the thickness from t = 0 to t = 1.", CORTICLE_MEMBER(tissue.thickness_rate_mm)),
        parameter("tissue.lambda", "", between(0.0, 0.999),
                  "Above 0: cortex is where the squared scaled radius of a sphere or ellipsoid reaches this "
                  "(binary layer only); 0: the thickness decides.",
                  CORTICLE_MEMBER(tissue.lambda)),
        parameter("tissue.mu_cortex", "mu_w", between(0.001, 1000.0), "Shear modulus of the cortex.",
                  CORTICLE_MEMBER(tissue.mu_cortex)),
        parameter("tissue.mu_white", "mu_w", between(0.001, 1000.0), "Shear modulus of the white matter.",
                  CORTICLE_MEMBER(tissue.mu_white)),
        parameter("tissue.bulk", "", {}, "Whether the bulk modulus follows the shear modulus or is one constant.",
                  CORTICLE_MEMBER(tissue.bulk)),
        parameter("tissue.bulk_modulus", "mu or mu_w", between(0.1, 10000.0),
                  "Bulk modulus: in shear moduli of the tissue (per_tissue) or itself (uniform).",
                  CORTICLE_MEMBER(tissue.bulk_modulus)),
        parameter("tissue.alpha_t", "", between(0.0, 10.0), "Tangential growth of the cortex at t = 1.",
                  CORTICLE_MEMBER(tissue.alpha_t)),
        parameter("tissue.barrier_J", "", between(0.0, 0.95),
                  "Elastic volume ratio below which a barrier resists crushing; 0: none.",
                  CORTICLE_MEMBER(tissue.barrier_J)),
    };
}

std::vector<Parameter> solver_parameters()
{
    return {
        constant("solver.method", "tlsph", "Discretisation: Total-Lagrangian SPH."),
        parameter("solver.support", "spacings", between(1.5, 5.0), "Support radius of the kernel.",
                  CORTICLE_MEMBER(tlsph.support)),
        parameter("solver.zeta", "", between(0.0, 10.0), "Strength of the control of zero-energy modes.",
                  CORTICLE_MEMBER(tlsph.zeta)),
        parameter("solver.cfl", "", above(0.0, 1.0), "Safety factor of the time step.", CORTICLE_MEMBER(dynamics.cfl)),
        parameter("solver.loading_time", "crossings", between(1.0, 100000.0),
                  "Time given to t = 0..1, in crossings of the body by a pressure wave.",
                  CORTICLE_MEMBER(dynamics.loading_time)),
        parameter("solver.damping", "", between(0.0, 100000.0), "Damping rate times the time given to t = 0..1.",
                  CORTICLE_MEMBER(dynamics.damping)),
        parameter("solver.max_halvings", "", between(0.0, 60.0),
                  "Consecutive halvings of the step before a run gives up.", CORTICLE_MEMBER(dynamics.max_halvings)),
    };
}

std::vector<Parameter> other_parameters()
{
    return {
        parameter("contact.enabled", "", {}, "Whether the surface is kept from passing through itself.",
                  CORTICLE_MEMBER(contact.enabled)),
        parameter("contact.distance", "spacings", above(0.0, 1.0), "Surfaces closer than this repel.",
                  CORTICLE_MEMBER(contact.distance)),
        parameter("contact.stiffness", "m/dt^2", above(0.0, 1.0), "Contact stiffness in units of what the step allows.",
                  CORTICLE_MEMBER(contact.stiffness)),
        parameter("time.end", "", above(0.0, 1.0), "Growth time t at which the run ends.", CORTICLE_MEMBER(time.end)),
        parameter("output.count", "", between(1.0, 100000.0), "Output times evenly spaced in t, besides t = 0.",
                  CORTICLE_MEMBER(output.count)),
        parameter("output.times", "", between(0.0, 1.0), "Output times instead of count, increasing; empty: count.",
                  CORTICLE_MEMBER(output.times)),
        choice("output.pictures", {"on", "off"}, "Whether pictures are drawn.", CORTICLE_MEMBER(output.pictures)),
        parameter("output.picture_times", "", between(0.0, 1.0),
                  "Output times that get pictures (the nearest), increasing; empty: about five, evenly spaced.",
                  CORTICLE_MEMBER(output.picture_times)),
        parameter("output.checkpoint_minutes", "min", above(0.0, 100000.0), "Wall time between checkpoints.",
                  CORTICLE_MEMBER(output.checkpoint_minutes)),
    };
}

#undef CORTICLE_MEMBER

std::vector<Parameter> all_parameters()
{
    std::vector<Parameter> all;
    for (auto part : {geometry_parameters, tissue_parameters, solver_parameters, other_parameters})
    {
        std::ranges::move(part(), std::back_inserter(all));
    }
    return all;
}

} // namespace

std::span<const Parameter> parameters()
{
    static const std::vector<Parameter> all = all_parameters();
    return all;
}

Options default_options()
{
    Options options;
    options.geometry.particles = default_particles;
    return options;
}

} // namespace corticle
