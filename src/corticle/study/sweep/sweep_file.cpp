// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/study/sweep/sweep_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace corticle::sweep
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t most_measures = 100;
constexpr std::size_t most_times = 20;

/// What is shown of a run where the sweep does not say.
constexpr std::array default_measures{"particles", "neighbours_mean", "area_ratio", "gi_hull",
                                      "gi_sphere", "onset_t",         "J_min",      "J_max"};
constexpr std::array default_plots{"area_ratio", "gi_hull", "gi_sphere"};

SweepReference read_reference(const config::TomlNode& node, const SweepPlace& place)
{
    SweepReference reference;
    reference.where = place.at(node);
    if (node.kind == config::TomlNode::Kind::table)
    {
        reference.kind = SweepReference::Kind::values;
        reference.values = case_values(node, place);
        return reference;
    }
    if (const auto* number = std::get_if<std::int64_t>(&node.value))
    {
        reference.kind = SweepReference::Kind::number;
        reference.number = *number;
        return reference;
    }
    reference.name = sweep_text(node, place);
    reference.kind = reference.name == "finest" ? SweepReference::Kind::finest
                     : reference.name == "none" ? SweepReference::Kind::none
                                                : SweepReference::Kind::name;
    return reference;
}

std::vector<std::string> read_texts(const config::TomlNode& node, const SweepPlace& place)
{
    if (node.kind != config::TomlNode::Kind::list || node.children.size() > most_measures)
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a list of at most {} strings", node.key, place.at(node),
                                     config::describe(node.value), most_measures));
    }
    std::vector<std::string> texts;
    for (const config::TomlNode& child : node.children)
    {
        texts.push_back(sweep_text(child, place, node.key));
    }
    return texts;
}

/// One growth time or a list of them.
std::vector<double> read_times(const config::TomlNode& node, const SweepPlace& place)
{
    std::vector<double> times;
    const std::vector<config::TomlNode> single{node};
    for (const config::TomlNode& child : node.kind == config::TomlNode::Kind::list ? node.children : single)
    {
        times.push_back(sweep_number(child, place, node.key));
    }
    if (times.empty() || times.size() > most_times || !std::ranges::is_sorted(times, std::ranges::less_equal{}))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected a growth time or at most {} of them, increasing",
                                     node.key, place.at(node), config::describe(node.value), most_times));
    }
    return times;
}

SweepMeasure measure_of(const std::string& text, const std::string& where)
{
    SweepMeasure measure{text, text, std::nullopt, where};
    const auto at = text.find('@');
    if (at != std::string::npos)
    {
        measure.key = text.substr(0, at);
        double t = 0.0;
        const char* const end = text.data() + text.size();
        const auto parsed = std::from_chars(text.data() + at + 1, end, t);
        if (parsed.ec != std::errc() || parsed.ptr != end || !(t >= 0.0 && t <= 1.0))
        {
            throw InputError(fmt::format("measures ({}): got \"{}\", expected KEY or KEY@T with a growth time T in "
                                         "[0, 1]",
                                         where, config::printable(text)));
        }
        measure.t = t;
    }
    return measure;
}

SweepLine read_line(const config::TomlNode& node, const SweepPlace& place)
{
    SweepLine line;
    for (const config::TomlNode& child : node.children)
    {
        if (child.key == "slope" || child.key == "intercept")
        {
            (child.key == "slope" ? line.slope : line.intercept) = sweep_number(child, place);
        }
        else if (child.key == "axis" || child.key == "measure" || child.key == "label")
        {
            (child.key == "axis"      ? line.axis
             : child.key == "measure" ? line.measure
                                      : line.label) = sweep_text(child, place);
        }
        else
        {
            throw InputError(
                fmt::format("unknown key {} of a line ({}); expected axis, measure, label, slope, intercept",
                            config::printable(child.key), place.at(child)));
        }
    }
    if (line.axis.empty() || line.measure.empty() || line.label.empty())
    {
        throw InputError(fmt::format("a line without axis, measure or label ({}); expected them", place.at(node)));
    }
    return line;
}

/// Tables of a [[list]]. @throws InputError where it is none
const std::vector<config::TomlNode>& tables_of(const config::TomlNode& node, const SweepPlace& place)
{
    const auto is_table = [](const config::TomlNode& child) { return child.kind == config::TomlNode::Kind::table; };
    if (node.kind != config::TomlNode::Kind::list || !std::ranges::all_of(node.children, is_table))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected tables: [[{}]]", node.key, place.at(node),
                                     config::describe(node.value), node.key));
    }
    return node.children;
}

/// Reads the parts of a sweep one by one.
class SweepReader
{
  public:
    explicit SweepReader(const SweepPlace& place) : place_(place) {}

    void read(const config::TomlNode& node);
    SweepFile finish();

  private:
    void settle_measures();
    void check_keys() const;
    void check_lines() const;
    bool has_axis(std::string_view key) const;

    const SweepPlace& place_;
    SweepFile sweep_;
    std::vector<std::pair<std::string, config::Value>> settings_;
    std::vector<std::string> measures_{default_measures.begin(), default_measures.end()};
    std::string where_measures_ = "the default measures";
    std::optional<std::vector<std::string>> plots_;
    std::string where_plots_;
};

void SweepReader::read(const config::TomlNode& node)
{
    if (node.key == "base")
    {
        sweep_.base = fs::absolute(place_.directory / sweep_text(node, place_)).lexically_normal();
    }
    else if (node.key == "title")
    {
        sweep_.title = sweep_text(node, place_);
    }
    else if (node.key == "set")
    {
        settings_ = case_values(node, place_);
    }
    else if (node.key == "axis")
    {
        tables_of(node, place_);
        sweep_.axes = sweep_axes(node, place_);
    }
    else if (node.key == "reference")
    {
        sweep_.reference = read_reference(node, place_);
    }
    else if (node.key == "measures")
    {
        measures_ = read_texts(node, place_);
        where_measures_ = place_.at(node);
    }
    else if (node.key == "plots")
    {
        plots_ = read_texts(node, place_);
        where_plots_ = place_.at(node);
    }
    else if (node.key == "pictures")
    {
        const auto* flag = std::get_if<bool>(&node.value);
        if (flag == nullptr)
        {
            throw InputError(fmt::format("pictures ({}): got {}, expected true or false", place_.at(node),
                                         config::describe(node.value)));
        }
        sweep_.has_pictures = *flag;
    }
    else if (node.key == "compare_t")
    {
        sweep_.compare_t = read_times(node, place_);
    }
    else if (node.key == "engine")
    {
        sweep_.engine = read_engine(node, place_);
    }
    else if (node.key == "line")
    {
        for (const config::TomlNode& child : tables_of(node, place_))
        {
            sweep_.lines.push_back(read_line(child, place_));
        }
    }
    else
    {
        throw InputError(
            fmt::format("unknown key {} ({}); expected base, title, set, axis, reference, measures, plots, "
                        "pictures, compare_t, line or engine",
                        config::printable(node.key), place_.at(node)));
    }
}

bool SweepReader::has_axis(std::string_view key) const
{
    return std::ranges::any_of(sweep_.axes, [&](const SweepAxis& axis)
                               { return std::ranges::find(axis.keys, key) != axis.keys.end(); });
}

/// No key may be set and swept; a reference may name only keys of axes.
void SweepReader::check_keys() const
{
    for (const auto& [key, value] : settings_)
    {
        if (has_axis(key))
        {
            throw InputError(
                fmt::format("{} ({}): both in [set] and on an axis; expected one of them", key, place_.name));
        }
    }
    for (const auto& [key, value] : sweep_.reference.values)
    {
        if (!has_axis(key))
        {
            throw InputError(
                fmt::format("reference ({}): got {}, expected keys of the axes", sweep_.reference.where, key));
        }
    }
}

void SweepReader::check_lines() const
{
    for (const SweepLine& line : sweep_.lines)
    {
        if (!has_axis(line.axis) || std::ranges::find(sweep_.plots, line.measure) == sweep_.plots.end())
        {
            throw InputError(
                fmt::format("line \"{}\" ({}): got axis {} and measure {}, expected a key of an axis and a "
                            "measure among plots",
                            config::printable(line.label), config::printable(place_.name), config::printable(line.axis),
                            config::printable(line.measure)));
        }
    }
}

void SweepReader::settle_measures()
{
    for (const std::string& text : measures_)
    {
        sweep_.measures.push_back(measure_of(text, where_measures_));
    }
    const auto is_measured = [&](const std::string& text)
    { return std::ranges::find(measures_, text) != measures_.end(); };
    for (const std::string& text : plots_.value_or(std::vector<std::string>{}))
    {
        if (!is_measured(text))
        {
            throw InputError(fmt::format("plots ({}): got \"{}\", expected some of measures", where_plots_,
                                         config::printable(text)));
        }
    }
    std::vector<std::string> defaults{default_plots.begin(), default_plots.end()};
    std::erase_if(defaults, [&](const std::string& text) { return !is_measured(text); });
    sweep_.plots = plots_.value_or(defaults);
}

SweepFile SweepReader::finish()
{
    if (sweep_.base.empty() || sweep_.axes.empty())
    {
        throw InputError(fmt::format("{} has no {}; expected {}", config::printable(place_.name),
                                     sweep_.base.empty() ? "base" : "[[axis]]",
                                     sweep_.base.empty() ? "the case that the runs start from" : "at least one"));
    }
    check_keys();
    for (const auto& [key, value] : settings_)
    {
        sweep_.settings.push_back(key + "=" + config::toml_text(value));
    }
    settle_measures();
    check_lines();
    std::size_t runs = 1;
    for (const SweepAxis& axis : sweep_.axes)
    {
        runs = runs > most_sweep_runs ? runs : runs * axis.size();
    }
    if (runs > most_sweep_runs)
    {
        throw InputError(fmt::format("{} has more than {} runs; expected at most as many",
                                     config::printable(place_.name), most_sweep_runs));
    }
    return std::move(sweep_);
}

} // namespace

SweepFile parse_sweep(std::string_view text, const std::string& name, const fs::path& directory)
{
    const SweepPlace place{name, directory};
    SweepReader reader(place);
    const config::TomlNode document = config::parse_toml_tree(text, name, "sweep");
    for (const config::TomlNode& node : document.children)
    {
        reader.read(node);
    }
    return reader.finish();
}

SweepFile read_sweep(const fs::path& file)
{
    SweepFile sweep = parse_sweep(config::read_case_text(file, "sweep"), file.string(), file.parent_path());
    sweep.title = sweep.title.empty() ? file.stem().string() : sweep.title;
    return sweep;
}

} // namespace corticle::sweep
