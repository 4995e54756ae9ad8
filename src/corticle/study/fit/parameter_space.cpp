// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/parameter_space.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::fit
{

namespace
{

constexpr std::size_t most_parameters = 20;

const config::Parameter& number_of_case(const std::string& key, const std::string& where)
{
    const config::Parameter* parameter = config::find_parameter(key);
    if (parameter == nullptr)
    {
        throw config::unknown_key_error(key, where);
    }
    if (parameter->kind != config::Kind::real && parameter->kind != config::Kind::integer)
    {
        throw InputError(fmt::format("{} ({}): a {}, expected a key of the case that is a number", key, where,
                                     parameter->kind_text()));
    }
    return *parameter;
}

double base_value(const config::Parameter& parameter, const config::Options& base)
{
    const config::Value value = parameter.get(base);
    const auto* real = std::get_if<double>(&value);
    const auto* integer = std::get_if<std::int64_t>(&value);
    return real != nullptr ? *real : integer != nullptr ? static_cast<double>(*integer) : NAN;
}

void read_bounds(const TableReader& table, const config::Parameter& known, FreeParameter& parameter)
{
    parameter.low = table.number("low");
    parameter.high = table.number("high");
    if (!(parameter.low < parameter.high))
    {
        throw InputError(fmt::format("parameter {} ({}): got low {} and high {}, expected low < high", parameter.key,
                                     table.where(), parameter.low, parameter.high));
    }
    for (const double bound : {parameter.low, parameter.high})
    {
        if (!known.range.contains(bound))
        {
            throw InputError(fmt::format("parameter {} ({}): got a bound of {}, expected {}", parameter.key,
                                         table.where(), bound, known.expected_text()));
        }
    }
    const std::string scale = table.text("scale", "linear");
    parameter.is_log = scale == "log";
    if ((scale != "log" && scale != "linear") || (parameter.is_log && !(parameter.low > 0.0)))
    {
        throw InputError(fmt::format("parameter {} ({}): got scale \"{}\" from {}, expected \"linear\", or \"log\" "
                                     "with bounds > 0",
                                     parameter.key, table.where(), config::printable(scale), parameter.low));
    }
}

void read_prior(const TableReader& table, FreeParameter& parameter)
{
    const std::string prior = table.text("prior", "uniform");
    parameter.is_normal = prior == "normal";
    if (prior != "normal" && prior != "uniform")
    {
        throw InputError(fmt::format("parameter {} ({}): got prior \"{}\", expected \"uniform\" or \"normal\"",
                                     parameter.key, table.where(), config::printable(prior)));
    }
    if (!parameter.is_normal && (table.find("mean") != nullptr || table.find("sd") != nullptr))
    {
        throw InputError(fmt::format("parameter {} ({}): mean or sd without prior = \"normal\"; expected both or none",
                                     parameter.key, table.where()));
    }
    if (parameter.is_normal)
    {
        parameter.mean = parameter.is_log ? *table.positive_if("mean") : table.number("mean");
        table.at("sd");
        parameter.sd = *table.positive_if("sd");
    }
}

FreeParameter read_parameter(const config::TomlNode& node, const sweep::SweepPlace& place, const config::Options& base)
{
    static constexpr std::array<std::string_view, 8> keys{"key",   "low",  "high", "scale",
                                                          "prior", "mean", "sd",   "start"};
    const TableReader table(node, place, "a parameter", keys);
    FreeParameter parameter;
    parameter.key = table.text("key");
    const config::Parameter& known = number_of_case(parameter.key, table.where());
    parameter.unit = known.unit;
    parameter.is_whole = known.kind == config::Kind::integer;
    read_bounds(table, known, parameter);
    if (table.text("prior", "") == "normal")
    {
        table.at("mean");
    }
    read_prior(table, parameter);
    const double from_base = base_value(known, base);
    const bool is_within = from_base >= parameter.low && from_base <= parameter.high;
    parameter.start = table.number_if("start").value_or(is_within ? from_base : parameter.value(0.5));
    if (!(parameter.start >= parameter.low && parameter.start <= parameter.high))
    {
        throw InputError(fmt::format("parameter {} ({}): got a start of {}, expected a number from {} to {}",
                                     parameter.key, table.where(), parameter.start, parameter.low, parameter.high));
    }
    return parameter;
}

} // namespace

double FreeParameter::value(double u) const
{
    const double found = is_log ? low * std::pow(high / low, u) : low + u * (high - low);
    const double within = std::clamp(found, low, high);
    return is_whole ? std::round(within) : within;
}

double FreeParameter::unit_of(double value) const
{
    return is_log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::vector<double> ParameterSpace::values(std::span<const double> u) const
{
    std::vector<double> result;
    for (std::size_t k = 0; k < size(); ++k)
    {
        result.push_back(parameters[k].value(u[k]));
    }
    return result;
}

Point ParameterSpace::start() const
{
    Point u;
    for (const FreeParameter& parameter : parameters)
    {
        u.push_back(std::clamp(parameter.unit_of(parameter.start), 0.0, 1.0));
    }
    return u;
}

double ParameterSpace::log_prior(std::span<const double> u) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < size(); ++k)
    {
        const FreeParameter& one = parameters[k];
        if (one.is_normal)
        {
            const double value =
                one.is_log ? one.low * std::pow(one.high / one.low, u[k]) : one.low + u[k] * (one.high - one.low);
            const double z = one.is_log ? std::log(value / one.mean) / one.sd : (value - one.mean) / one.sd;
            sum -= 0.5 * z * z;
        }
    }
    return sum;
}

std::vector<std::string> ParameterSpace::overrides(std::span<const double> u) const
{
    std::vector<std::string> texts;
    const std::vector<double> found = values(u);
    for (std::size_t k = 0; k < size(); ++k)
    {
        const config::Value value =
            parameters[k].is_whole ? config::Value(static_cast<std::int64_t>(found[k])) : config::Value(found[k]);
        texts.push_back(parameters[k].key + "=" + config::toml_text(value));
    }
    return texts;
}

ParameterSpace read_parameters(const config::TomlNode& list, const sweep::SweepPlace& place,
                               const config::Options& base)
{
    ParameterSpace space;
    for (const config::TomlNode& node : tables_of(list, place))
    {
        space.parameters.push_back(read_parameter(node, place, base));
        const std::string& key = space.parameters.back().key;
        if (std::ranges::count(space.parameters, key, &FreeParameter::key) > 1)
        {
            throw InputError(fmt::format("{} ({}): in two [[parameter]] tables; expected one", key, place.at(node)));
        }
    }
    if (space.parameters.empty() || space.size() > most_parameters)
    {
        throw InputError(fmt::format("parameter ({}): got {} tables, expected 1 to {}", place.at(list), space.size(),
                                     most_parameters));
    }
    return space;
}

} // namespace corticle::fit
