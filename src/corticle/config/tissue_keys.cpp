// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/tissue_keys.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;

std::string key_of(std::size_t kind)
{
    return fmt::format("tissue.labels.{}", material::tissue_names[kind]);
}

/// Every label in one list, and in the body.
void check_lists(const Options& options, const Place& place)
{
    const std::vector<std::int64_t>& body = options.geometry.mask.labels;
    std::map<std::int64_t, std::size_t> tissue_of;
    for (std::size_t kind = 0; kind < options.labels.size(); ++kind)
    {
        for (const std::int64_t label : options.labels[kind])
        {
            const auto [found, is_new] = tissue_of.emplace(label, kind);
            if (!is_new)
            {
                throw InputError(fmt::format("{}{} has label {}, which {}{} has too: expected each label once",
                                             key_of(kind), place(key_of(kind)), label, key_of(found->second),
                                             found->second == kind ? "" : place(key_of(found->second))));
            }
            if (!body.empty() && std::ranges::find(body, label) == body.end())
            {
                throw InputError(fmt::format("{}{} has label {}, which is not in geometry.labels{}: expected labels of "
                                             "the body",
                                             key_of(kind), place(key_of(kind)), label, place("geometry.labels")));
            }
        }
    }
}

/// What a labelled cortex stands in place of.
void check_labelled_cortex(const Options& options, const Place& place)
{
    constexpr std::string_view cortex = "tissue.labels.cortex";
    if (options.geometry.shape != prepare::Shape::file || !formats::is_volume(options.geometry.file))
    {
        throw InputError(fmt::format("{}{} is given, but the body is no label volume: expected geometry.shape{} = "
                                     "\"file\" and a NIfTI or MGH file",
                                     cortex, place(cortex), place("geometry.shape")));
    }
    const auto refuse = [&](std::string_view key, bool is_set)
    {
        if (is_set)
        {
            throw InputError(fmt::format("{}{} is given beside {}{}: expected one of them, as labels say how thick the "
                                         "cortex is",
                                         key, place(key), cortex, place(cortex)));
        }
    };
    refuse("tissue.lambda", options.tissue.lambda > 0.0);
    refuse("tissue.thickness_preset", options.tissue.thickness_preset != material::ThicknessPreset::none);
    refuse("tissue.thickness_rate_mm", options.tissue.thickness_rate_mm != 0.0);
    refuse("map.thickness_file", !options.map.thickness_file.empty());
    refuse("size.thin_cortex", options.size.thin_cortex);
    if (options.geometry.mask.threshold)
    {
        throw InputError(fmt::format("{}{} is given beside geometry.threshold{}: expected one of them, as an image "
                                     "holds labels or probabilities",
                                     cortex, place(cortex), place("geometry.threshold")));
    }
}

void check_growth_law(const Options& options, const Place& place)
{
    const bool is_table = options.tissue.growth_source == material::GrowthSource::table;
    if (is_table != !options.growth_table.empty())
    {
        throw InputError(is_table
                             ? fmt::format("growth.table is missing: got none, expected the path of a CSV file, as "
                                           "growth.law{} is \"table\"",
                                           place("growth.law"))
                             : fmt::format("growth.table{} is given, but growth.law{} is not \"table\"",
                                           place("growth.table"), place("growth.law")));
    }
    if (options.tissue.growth_source == material::GrowthSource::keys)
    {
        return;
    }
    const std::string law = fmt::format("growth.law{} is \"{}\"", place("growth.law"), is_table ? "table" : "fetal");
    if (options.time.clock == material::GestationalClock::none)
    {
        throw InputError(
            fmt::format("{}: got no clock{}, expected time.clock = \"wang\" or \"cubic\", as growth goes by "
                        "week",
                        law, place("time.clock")));
    }
    for (const std::string_view key : {"tissue.alpha_t", "tissue.alpha_r", "tissue.alpha_white", "tissue.growth_law",
                                       "tissue.growth_onset", "tissue.growth_rate"})
    {
        if (!place(key).empty())
        {
            throw InputError(fmt::format("{}{} is given, but {}: expected growth.law = \"keys\", or no such key", key,
                                         place(key), law));
        }
    }
    if (options.formulation == thesis::Formulation::thesis)
    {
        throw InputError(fmt::format("{}, but solver.formulation{} is \"thesis\": expected \"corrected\"", law,
                                     place("solver.formulation")));
    }
}

} // namespace

void check_tissue_keys(const Options& options, const Place& place)
{
    check_growth_law(options, place);
    check_lists(options, place);
    if (prepare::has_labelled_cortex(options))
    {
        check_labelled_cortex(options, place);
        return;
    }
    for (std::size_t kind = 0; kind < options.labels.size(); ++kind)
    {
        if (!options.labels[kind].empty())
        {
            throw InputError(fmt::format("{}{} is given without tissue.labels.cortex: expected both", key_of(kind),
                                         place(key_of(kind))));
        }
    }
}

} // namespace corticle::config
