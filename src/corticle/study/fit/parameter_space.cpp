// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/parameter_space.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace corticle::fit
{

namespace
{

constexpr std::size_t most_parameters = 20;
constexpr std::size_t longest_list = 100; // of which one number may be free

/// Of "map.modes.3" the list map.modes and the place 2; of other keys nothing.
std::optional<std::pair<const config::Parameter*, std::size_t>> number_of_list(const std::string& key)
{
    const std::size_t dot = key.rfind('.');
    const config::Parameter* list = dot == std::string::npos ? nullptr : config::find_parameter(key.substr(0, dot));
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(key.data() + dot + 1, key.data() + key.size(), number);
    const bool is_number = error == std::errc() && end == key.data() + key.size() && number >= 1;
    if (list == nullptr || list->kind != config::Kind::list || !list->any_order || !is_number || number > longest_list)
    {
        return std::nullopt;
    }
    return std::pair(list, number - 1);
}

std::vector<double> list_of(const config::Parameter& list, const config::Options& base)
{
    const config::Value value = list.get(base);
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    return numbers != nullptr ? *numbers : std::vector<double>{};
}

/// Sets the key of `parameter`, which is a number of the case or of a list of it. @return what is known of it
const config::Parameter& find_key(const std::string& key, const std::string& where, const config::Options& base,
                                  FreeParameter& parameter)
{
    parameter.key = key;
    if (const auto found = number_of_list(key))
    {
        const auto& [list, place] = *found;
        parameter.list = list->key;
        parameter.place = place;
        parameter.others = list_of(*list, base);
        parameter.others.resize(std::max(parameter.others.size(), place + 1));
        return *list;
    }
    const config::Parameter* known = config::find_parameter(key);
    if (known == nullptr)
    {
        throw config::unknown_key_error(key, where);
    }
    if (known->kind != config::Kind::real && known->kind != config::Kind::integer)
    {
        const std::string of_list =
            known->any_order ? fmt::format(", or one of its numbers: \"{}.1\"", known->key) : "";
        throw InputError(fmt::format("{} ({}): a {}, expected a key of the case that is a number{}", key, where,
                                     known->kind_text(), of_list));
    }
    return *known;
}

double base_value(const config::Parameter& known, const config::Options& base, const FreeParameter& parameter)
{
    const config::Value value = known.get(base);
    const auto* real = std::get_if<double>(&value);
    const auto* integer = std::get_if<std::int64_t>(&value);
    return !parameter.list.empty() ? parameter.others[parameter.place]
           : real != nullptr       ? *real
           : integer != nullptr    ? static_cast<double>(*integer)
                                   : NAN;
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
    const config::Parameter& known = find_key(table.text("key"), table.where(), base, parameter);
    parameter.unit = known.unit;
    parameter.is_whole = known.kind == config::Kind::integer;
    read_bounds(table, known, parameter);
    if (table.text("prior", "") == "normal")
    {
        table.at("mean");
    }
    read_prior(table, parameter);
    const double from_base = base_value(known, base, parameter);
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

std::string FreeParameter::name() const
{
    return key.substr((list.empty() ? key : list).rfind('.') + 1);
}

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
    std::map<std::string, std::vector<double>> lists;
    const std::vector<double> found = values(u);
    for (std::size_t k = 0; k < size(); ++k)
    {
        const FreeParameter& one = parameters[k];
        if (!one.list.empty())
        {
            std::vector<double>& list = lists[one.list];
            for (std::size_t i = list.size(); i < one.others.size(); ++i)
            {
                list.push_back(one.others[i]);
            }
            list[one.place] = found[k];
            continue;
        }
        const config::Value value =
            one.is_whole ? config::Value(static_cast<std::int64_t>(found[k])) : config::Value(found[k]);
        texts.push_back(one.key + "=" + config::toml_text(value));
    }
    for (const auto& [key, numbers] : lists)
    {
        texts.push_back(key + "=" + config::toml_text(config::Value(numbers)));
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
