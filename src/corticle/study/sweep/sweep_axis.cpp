// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_axis.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace corticle::sweep
{

namespace
{

constexpr std::size_t longest_name = 60; // of a place on an axis
constexpr double largest_count = 1e15;
constexpr int log_digits = 4; // of values between those given

/// One [[axis]] table as it is written.
struct WrittenAxis
{
    std::string where;
    const config::Parameter* parameter = nullptr;
    std::string zip;
    std::vector<config::Value> values;
    std::vector<std::string> names;
    bool is_log = false;
};

/// The members of an [[axis]] table by name.
class AxisTable
{
  public:
    AxisTable(const config::TomlNode& node, const SweepPlace& place) : node_(node), place_(place)
    {
        static constexpr std::array known{"key", "values", "start", "stop", "count", "step", "names", "spacing", "zip"};
        for (const config::TomlNode& child : node.children)
        {
            if (std::ranges::find(known, child.key) == known.end())
            {
                throw InputError(fmt::format("unknown key {} of an axis ({}); expected {}",
                                             config::printable(child.key), place.at(child), fmt::join(known, ", ")));
            }
        }
    }
    const config::TomlNode* find(std::string_view key) const
    {
        const auto found = std::ranges::find(node_.children, key, &config::TomlNode::key);
        return found == node_.children.end() ? nullptr : &*found;
    }
    const config::TomlNode& at(std::string_view key) const
    {
        const config::TomlNode* found = find(key);
        if (found == nullptr)
        {
            throw InputError(fmt::format("an axis without {} ({}); expected one", key, where()));
        }
        return *found;
    }
    std::string where() const { return place_.at(node_); }
    const SweepPlace& place() const { return place_; }

  private:
    const config::TomlNode& node_;
    const SweepPlace& place_;
};

/// The nearest number of so many digits: of 12, 0.1 + 2 * 0.1 becomes 0.3.
double tidy(double number, int digits = 12)
{
    const std::string text = fmt::format("{:.{}g}", number, digits);
    double result = number;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

bool is_log(const AxisTable& axis)
{
    const config::TomlNode* node = axis.find("spacing");
    if (node == nullptr)
    {
        return false;
    }
    const std::string text = sweep_text(*node, axis.place());
    if (text != "linear" && text != "log")
    {
        throw InputError(fmt::format("spacing of an axis ({}): got \"{}\", expected \"linear\" or \"log\"",
                                     axis.place().at(*node), config::printable(text)));
    }
    return text == "log";
}

std::size_t counted(const AxisTable& axis)
{
    const config::TomlNode& node = axis.at("count");
    const auto* count = std::get_if<std::int64_t>(&node.value);
    if (count == nullptr || *count < 2 || *count > static_cast<std::int64_t>(most_sweep_runs))
    {
        throw InputError(fmt::format("count of an axis ({}): got {}, expected an integer in [2, {}]",
                                     axis.place().at(node), config::describe(node.value), most_sweep_runs));
    }
    return static_cast<std::size_t>(*count);
}

/// Numbers from start to stop, `count` of them or a step apart.
std::vector<double> range_of(const AxisTable& axis)
{
    const double start = sweep_number(axis.at("start"), axis.place());
    const double stop = sweep_number(axis.at("stop"), axis.place());
    const bool log = is_log(axis);
    if (log && !(start > 0.0 && stop > 0.0))
    {
        throw InputError(
            fmt::format("a logarithmic axis ({}) from {} to {}; expected both above 0", axis.where(), start, stop));
    }
    std::vector<double> numbers;
    if (const config::TomlNode* node = axis.find("step"))
    {
        const double step = sweep_number(*node, axis.place());
        const double count = std::floor((stop - start) / step + 1e-9) + 1.0;
        if (axis.find("count") != nullptr || log || !(count >= 1.0 && count <= static_cast<double>(most_sweep_runs)))
        {
            throw InputError(
                fmt::format("step of an axis ({}): got {}, expected one that leads from start to stop in at "
                            "most {} steps, without count and without log spacing",
                            axis.place().at(*node), step, most_sweep_runs));
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        {
            numbers.push_back(tidy(start + static_cast<double>(i) * step));
        }
        return numbers;
    }
    const std::size_t count = counted(axis);
    for (std::size_t i = 0; i < count; ++i)
    {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        numbers.push_back(log ? tidy(start * std::pow(stop / start, share), log_digits)
                              : tidy(start + share * (stop - start)));
    }
    return numbers;
}

/// The values of an axis; those of a range are rounded where the key counts something.
std::vector<config::Value> written_values(const AxisTable& axis, bool is_count)
{
    if (axis.find("values") == nullptr)
    {
        std::vector<config::Value> values;
        for (const double number : range_of(axis))
        {
            const bool is_rounded = is_count && std::abs(number) < largest_count;
            values.push_back(is_rounded ? config::Value(static_cast<std::int64_t>(std::llround(number)))
                                        : config::Value(number));
        }
        return values;
    }
    for (const char* other : {"start", "stop", "count", "step"})
    {
        if (const config::TomlNode* node = axis.find(other))
        {
            throw InputError(
                fmt::format("an axis with values and {} ({}); expected one of them", other, axis.place().at(*node)));
        }
    }
    const config::TomlNode& list = axis.at("values");
    if (list.kind != config::TomlNode::Kind::list || list.children.empty() || list.children.size() > most_sweep_runs)
    {
        throw InputError(fmt::format("values of an axis ({}): got {}, expected a list of 1 to {} values",
                                     axis.place().at(list), config::describe(list.value), most_sweep_runs));
    }
    std::vector<config::Value> values;
    for (const config::TomlNode& node : list.children)
    {
        values.push_back(node.value);
    }
    return values;
}

/// A value as a part of a name: letters, digits, dots and signs.
std::string name_of(const config::Value& value)
{
    std::string text;
    if (const auto* real = std::get_if<double>(&value))
    {
        text = fmt::format("{}", *real);
    }
    else if (const auto* string = std::get_if<std::string>(&value))
    {
        text = std::filesystem::path(*string).filename().string();
    }
    else if (const auto* list = std::get_if<std::vector<double>>(&value))
    {
        text = fmt::format("{}", fmt::join(*list, "x"));
    }
    else
    {
        text = config::toml_text(value);
    }
    return text;
}

bool is_plain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
           c == '+';
}

std::vector<std::string> given_names(const AxisTable& axis, std::size_t count)
{
    std::vector<std::string> names;
    const config::TomlNode* list = axis.find("names");
    if (list == nullptr)
    {
        return names;
    }
    for (const config::TomlNode& node : list->children)
    {
        const auto* name = std::get_if<std::string>(&node.value);
        if (name == nullptr || name->empty() || !std::ranges::all_of(*name, is_plain) || name->front() == '.')
        {
            throw InputError(
                fmt::format("names of an axis ({}): got {}, expected letters, digits, \"-\", \"+\" and \".\", this "
                            "not first, between quotes",
                            axis.place().at(*list), config::describe(node.value)));
        }
        names.push_back(*name);
    }
    if (names.size() != count)
    {
        throw InputError(fmt::format("names of an axis ({}): got {} of them, expected one for each of {} values",
                                     axis.place().at(*list), names.size(), count));
    }
    return names;
}

WrittenAxis read_axis(const config::TomlNode& node, const SweepPlace& place)
{
    const AxisTable table(node, place);
    WrittenAxis axis;
    axis.where = table.where();
    const config::TomlNode& key = table.at("key");
    const std::string key_text = sweep_text(key, place);
    axis.parameter = config::find_parameter(key_text);
    if (axis.parameter == nullptr)
    {
        throw config::unknown_key_error(key_text, place.at(key));
    }
    for (const config::Value& value : written_values(table, axis.parameter->kind == config::Kind::integer))
    {
        axis.values.push_back(sweep_value(axis.parameter->key, value, axis.where, place));
    }
    axis.names = given_names(table, axis.values.size());
    axis.is_log = is_log(table);
    if (const config::TomlNode* zip = table.find("zip"))
    {
        axis.zip = sweep_text(*zip, place);
    }
    return axis;
}

/// Adds the keys and values of one more axis that is zipped with those before.
void join(SweepAxis& axis, const WrittenAxis& written)
{
    axis.values.resize(written.values.size());
    for (std::size_t i = 0; i < axis.values.size(); ++i)
    {
        axis.values[i].push_back(written.values[i]);
    }
    axis.keys.push_back(written.parameter->key);
    axis.is_log = axis.is_log || written.is_log;
    if (!written.names.empty())
    {
        axis.names = written.names;
        axis.labels = written.names;
        axis.has_given_names = true;
    }
}

/// Names from the values, where none are given: "cfl-0.4", of zipped keys "particles-8000_seed-2".
void name_places(SweepAxis& axis, const std::map<std::string, int>& uses, const std::string& where)
{
    if (!axis.has_given_names)
    {
        for (const std::vector<config::Value>& values : axis.values)
        {
            std::string name;
            std::string label;
            for (std::size_t k = 0; k < axis.keys.size(); ++k)
            {
                const std::string last = config::find_parameter(axis.keys[k])->name();
                label += (k == 0 ? "" : ", ") + name_of(values[k]);
                name += fmt::format("{}{}-{}", k == 0 ? "" : "_", uses.at(last) > 1 ? axis.keys[k] : last,
                                    name_of(values[k]));
            }
            std::ranges::replace_if(
                name, [](char c) { return !is_plain(c) && c != '_'; }, '-');
            axis.names.push_back(name);
            axis.labels.push_back(label);
        }
    }
    std::vector<std::string> sorted = axis.names;
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    const auto longest = std::ranges::max(sorted, {}, &std::string::size);
    if (twice != sorted.end() || longest.size() > longest_name)
    {
        throw InputError(fmt::format("axis {} ({}): {} \"{}\"; expected values that differ, or names",
                                     axis.keys.front(), where,
                                     twice != sorted.end() ? "two places named" : "too long a name,",
                                     config::printable(twice != sorted.end() ? *twice : longest)));
    }
}

} // namespace

std::vector<SweepAxis> sweep_axes(const config::TomlNode& list, const SweepPlace& place)
{
    std::vector<SweepAxis> axes;
    std::vector<std::string> where;
    std::map<std::string, std::size_t> zips; // label -> place in axes
    std::map<std::string, int> uses;         // of the names of keys without their section
    std::vector<std::string> keys;
    for (const config::TomlNode& node : list.children)
    {
        const WrittenAxis written = read_axis(node, place);
        if (std::ranges::find(keys, written.parameter->key) != keys.end())
        {
            throw InputError(fmt::format("two axes for {} ({}); expected one", written.parameter->key, written.where));
        }
        keys.push_back(written.parameter->key);
        ++uses[written.parameter->name()];
        const auto zipped = written.zip.empty() ? zips.end() : zips.find(written.zip);
        if (zipped == zips.end())
        {
            zips[written.zip] = axes.size();
            axes.emplace_back();
            where.push_back(written.where);
        }
        SweepAxis& axis = zipped == zips.end() ? axes.back() : axes[zipped->second];
        if (axis.size() != 0 && axis.size() != written.values.size())
        {
            throw InputError(fmt::format("axis {} ({}): got {} values, expected {}, as many as {}, which it is zipped "
                                         "with",
                                         written.parameter->key, written.where, written.values.size(), axis.size(),
                                         axis.keys.front()));
        }
        join(axis, written);
    }
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
        name_places(axes[i], uses, where[i]);
    }
    return axes;
}

} // namespace corticle::sweep
