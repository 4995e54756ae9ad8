// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_engine.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::sweep
{

namespace
{

constexpr double most_cpus = 1024.0;
constexpr std::size_t most_lines = 100;

int read_cpus(const config::TomlNode& node, const SweepPlace& place)
{
    const double cpus = sweep_number(node, place);
    if (!(cpus >= 1.0 && cpus <= most_cpus) || cpus != std::floor(cpus))
    {
        throw InputError(fmt::format("cpus ({}): got {}, expected a whole number from 1 to {:.0f}", place.at(node),
                                     config::describe(node.value), most_cpus));
    }
    return static_cast<int>(cpus);
}

std::vector<std::string> read_lines(const config::TomlNode& node, const SweepPlace& place)
{
    if (node.kind != config::TomlNode::Kind::list || node.children.size() > most_lines)
    {
        throw InputError(fmt::format("lines ({}): got {}, expected a list of at most {} strings", place.at(node),
                                     config::describe(node.value), most_lines));
    }
    std::vector<std::string> lines;
    for (const config::TomlNode& child : node.children)
    {
        lines.push_back(sweep_text(child, place, node.key));
    }
    return lines;
}

/// A value of an #SBATCH line.
std::string read_word(const config::TomlNode& node, const SweepPlace& place)
{
    const std::string word = sweep_text(node, place);
    const auto is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("-_:.,+").find(c) != std::string::npos;
    };
    if (!std::ranges::all_of(word, is_plain))
    {
        throw InputError(fmt::format("{} ({}): got {}, expected letters, digits and -_:.,+", node.key, place.at(node),
                                     config::describe(node.value)));
    }
    return word;
}

} // namespace

EngineOptions read_engine(const config::TomlNode& node, const SweepPlace& place)
{
    if (node.kind != config::TomlNode::Kind::table)
    {
        throw InputError(fmt::format("engine ({}): got {}, expected a table: [engine]", place.at(node),
                                     config::describe(node.value)));
    }
    EngineOptions options;
    const std::vector<std::pair<std::string_view, std::string*>> words{{"partition", &options.partition},
                                                                       {"account", &options.account},
                                                                       {"time", &options.time},
                                                                       {"memory", &options.memory}};
    for (const config::TomlNode& child : node.children)
    {
        const auto word = std::ranges::find(words, child.key, [](const auto& entry) { return entry.first; });
        if (word != words.end())
        {
            *word->second = read_word(child, place);
        }
        else if (child.key == "cpus")
        {
            options.cpus = read_cpus(child, place);
        }
        else if (child.key == "lines")
        {
            options.lines = read_lines(child, place);
        }
        else
        {
            throw InputError(
                fmt::format("unknown key {} of [engine] ({}); expected partition, account, time, memory, cpus or lines",
                            config::printable(child.key), place.at(child)));
        }
    }
    return options;
}

} // namespace corticle::sweep
