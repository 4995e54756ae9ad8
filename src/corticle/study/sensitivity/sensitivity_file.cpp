// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/sensitivity_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::sensitivity
{

namespace
{

constexpr std::int64_t most_paths = 1000;
constexpr std::int64_t most_levels = 20;
constexpr std::int64_t most_points = 2000;
constexpr std::int64_t most_samples = 1 << 20;

std::vector<fit::Quantity> read_measures(const config::TomlNode& node, const sweep::SweepPlace& place,
                                         const config::Options& base)
{
    std::vector<fit::Quantity> measures;
    for (const config::TomlNode& child : node.children)
    {
        measures.push_back(fit::parse_quantity(sweep::sweep_text(child, place, node.key), place.at(child), base));
    }
    if (node.kind != config::TomlNode::Kind::list || measures.empty())
    {
        throw InputError(fmt::format("measures ({}): got {}, expected a list such as [\"gi_hull@0.5\", \"onset_t\"]",
                                     place.at(node), config::describe(node.value)));
    }
    for (const fit::Quantity& one : measures)
    {
        if (std::ranges::count(measures, one.name(), &fit::Quantity::name) > 1)
        {
            throw InputError(fmt::format("measures ({}): {} twice; expected it once", place.at(node), one.name()));
        }
    }
    return measures;
}

void read_morris(const config::TomlNode& node, const sweep::SweepPlace& place, SensitivityFile& file)
{
    static constexpr std::array<std::string_view, 2> keys{"paths", "levels"};
    const fit::TableReader table(node, place, "[morris]", keys);
    file.paths = static_cast<std::size_t>(table.count("paths", 8, 0, most_paths));
    file.levels = static_cast<std::size_t>(table.count("levels", 4, 2, most_levels));
    if (file.paths == 1 || file.levels % 2 != 0)
    {
        throw InputError(
            fmt::format("[morris] ({}): got {} paths and {} levels, expected 0 or at least 2 paths, and an "
                        "even number of levels",
                        table.where(), file.paths, file.levels));
    }
}

void read_sobol(const config::TomlNode& node, const sweep::SweepPlace& place, SensitivityFile& file)
{
    static constexpr std::array<std::string_view, 2> keys{"points", "samples"};
    const fit::TableReader table(node, place, "[sobol]", keys);
    const auto fewest = static_cast<std::int64_t>(4 * (file.space.size() + 1));
    file.points = static_cast<std::size_t>(
        table.count("points", 12 * static_cast<std::int64_t>(file.space.size()), 0, most_points));
    file.samples = static_cast<std::size_t>(table.count("samples", 8192, 64, most_samples));
    if (file.points > 0 && static_cast<std::int64_t>(file.points) < fewest)
    {
        throw InputError(
            fmt::format("points ({}): got {}, expected 0 (no Sobol indices) or at least {} for {} parameters",
                        table.where(), file.points, fewest, file.space.size()));
    }
}

} // namespace

SensitivityFile parse_sensitivity(std::string_view text, const std::string& name,
                                  const std::filesystem::path& directory, std::span<const std::string> overrides)
{
    static constexpr std::array<std::string_view, 8> keys{"base",      "title",    "seed",   "set",
                                                          "parameter", "measures", "morris", "sobol"};
    const sweep::SweepPlace place{name, directory};
    const config::TomlNode document = config::parse_toml_tree(text, name, "sensitivity analysis");
    const fit::TableReader table(document, place, "a sensitivity analysis", keys);
    SensitivityFile file;
    file.study = fit::read_study_base(document, place, overrides);
    file.space = fit::read_parameters(table.at("parameter"), place, file.study.options);
    file.measures = read_measures(table.at("measures"), place, file.study.options);
    file.points = std::max<std::size_t>(12 * file.space.size(), 4 * (file.space.size() + 1));
    if (const config::TomlNode* morris = table.find("morris"))
    {
        read_morris(*morris, place, file);
    }
    if (const config::TomlNode* sobol = table.find("sobol"))
    {
        read_sobol(*sobol, place, file);
    }
    if (file.paths == 0 && file.points == 0)
    {
        throw InputError(fmt::format("{}: neither [morris] paths nor [sobol] points; expected one of them",
                                     config::printable(name)));
    }
    return file;
}

SensitivityFile read_sensitivity(const std::filesystem::path& file, std::span<const std::string> overrides)
{
    return parse_sensitivity(config::read_case_text(file, "sensitivity analysis"), file.string(), file.parent_path(),
                             overrides);
}

} // namespace corticle::sensitivity
