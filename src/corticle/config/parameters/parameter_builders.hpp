// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/choices.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

// How parameters are made from members of Options: what parameter_table.cpp is written in.

namespace corticle::config::detail
{

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

template <>
struct Member<std::vector<std::int64_t>>
{
    static constexpr Kind kind = Kind::integers;
    static Value get(const std::vector<std::int64_t>& member)
    {
        return std::vector<double>(member.begin(), member.end());
    }
    static void set(std::vector<std::int64_t>& member, const Value& value)
    {
        const auto& list = std::get<std::vector<double>>(value);
        member.assign(list.begin(), list.end());
    }
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

/// What is known of a parameter of this type but where it is kept.
template <class T>
Parameter described(std::string key, std::string unit, Range range, std::string sentence)
{
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
    return result;
}

/// A parameter kept in the member that `access(options)` refers to.
template <class Access>
Parameter parameter(std::string key, std::string unit, Range range, std::string sentence, Access access)
{
    using T = std::remove_cvref_t<decltype(access(std::declval<Options&>()))>;
    Parameter result = described<T>(std::move(key), std::move(unit), range, std::move(sentence));
    result.get = [access](const Options& options) { return Member<T>::get(access(options)); };
    result.set = [access](Options& options, const Value& value) { Member<T>::set(access(options), value); };
    return result;
}

/// The path of a file, relative to the case; "" for none.
template <class Access>
Parameter path(std::string key, std::string sentence, Access access)
{
    Parameter result = parameter(std::move(key), "", {}, std::move(sentence), access);
    result.is_path = true;
    return result;
}

/// A list of any length whose numbers need not increase.
inline Parameter in_any_order(Parameter parameter)
{
    parameter.any_order = true;
    return parameter;
}

/// A key without a default.
inline Parameter with_example(Parameter parameter, std::string example)
{
    parameter.example = std::move(example);
    return parameter;
}

/// A key that says nothing where a condition does not hold.
inline Parameter where(bool (*holds)(const Options&), Parameter parameter)
{
    parameter.get = [holds, get = parameter.get](const Options& options) -> Value
    { return holds(options) ? get(options) : Unsupported{}; };
    return parameter;
}

/// A growth time that weeks replace where there is a clock.
inline Parameter without_clock(Parameter parameter)
{
    return where([](const Options& options) { return options.time.clock == material::GestationalClock::none; },
                 std::move(parameter));
}

/// A number of the thickness, which a preset replaces.
inline Parameter without_thickness_preset(Parameter parameter)
{
    return where([](const Options& options)
                 { return options.tissue.thickness_preset == material::ThicknessPreset::none; },
                 std::move(parameter));
}

/// A key of growth by t, which growth by week replaces.
inline Parameter without_growth_by_week(Parameter parameter)
{
    return where([](const Options& options) { return options.tissue.growth_source == material::GrowthSource::keys; },
                 std::move(parameter));
}

/// A key of the thesis's formulation, which other cases do not have.
inline Parameter of_thesis(Parameter parameter)
{
    return where([](const Options& options) { return options.formulation == thesis::Formulation::thesis; },
                 std::move(parameter));
}

/// An optional number that is `otherwise(options)` where it is not given.
inline Parameter with_default(Parameter parameter, double (*otherwise)(const Options&))
{
    parameter.get = [otherwise](const Options& options) -> Value { return otherwise(options); };
    return parameter;
}

inline Range above(double low, double high = std::numeric_limits<double>::infinity())
{
    return {low, high, true};
}
inline Range between(double low, double high)
{
    return {low, high, false};
}
inline Range at_least(double low)
{
    return {low, std::numeric_limits<double>::infinity(), false};
}

} // namespace corticle::config::detail
