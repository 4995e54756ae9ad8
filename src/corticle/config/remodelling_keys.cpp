// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/remodelling_keys.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/config/parameters/remodelling_parameters.hpp"

#include <fmt/format.h>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;

/// The key without which another one of these says nothing.
std::string_view needed_by(std::string_view key, const material::RemodellingOptions& options)
{
    if (key.starts_with("relaxation."))
    {
        return "relaxation.share";
    }
    if (key.starts_with("stress_growth."))
    {
        return "stress_growth.rate";
    }
    if (!options.has_fibres())
    {
        return "fibres.direction";
    }
    return key == "fibres.ramp" ? "fibres.active_stress" : "fibres.growth_rate";
}

void check_moot_keys(const Options& options, const Place& place)
{
    for (const Parameter& parameter : remodelling_parameters())
    {
        if (!place(parameter.key).empty() && std::holds_alternative<Unsupported>(parameter.get(options)))
        {
            const std::string_view needed = needed_by(parameter.key, options.tissue.remodelling);
            throw InputError(fmt::format("{}{} is given, but {}{} is {}: expected {}, or no such key", parameter.key,
                                         place(parameter.key), needed, place(needed),
                                         needed == "fibres.direction" ? "\"none\"" : "0",
                                         needed == "fibres.direction" ? "a direction" : "a number above 0"));
        }
    }
}

void check_fibres(const material::FibreOptions& fibres, const Place& place)
{
    if (fibres.stiffness == 0.0 && fibres.active_stress == 0.0)
    {
        throw InputError(fmt::format("fibres.direction{} is given, but fibres carry nothing: expected fibres.stiffness "
                                     "or fibres.active_stress above 0",
                                     place("fibres.direction")));
    }
    if (fibres.growth_rate > 0.0 && fibres.stiffness == 0.0)
    {
        throw InputError(fmt::format("fibres.growth_rate{} is {:g}, but fibres.stiffness{} is 0, so that their rest "
                                     "length does not matter: expected fibres.stiffness above 0",
                                     place("fibres.growth_rate"), fibres.growth_rate, place("fibres.stiffness")));
    }
}

} // namespace

void check_remodelling(const Options& options, const Place& place)
{
    const material::RemodellingOptions& remodelling = options.tissue.remodelling;
    check_moot_keys(options, place);
    const bool is_file = remodelling.fibres.direction == material::FibreField::file;
    if (is_file != !options.fibre_file.empty())
    {
        throw InputError(is_file ? fmt::format("fibres.file is missing: got none, expected the path of a NIfTI volume "
                                               "of vectors, as fibres.direction{} is \"file\"",
                                               place("fibres.direction"))
                                 : fmt::format("fibres.file{} is given, but fibres.direction{} is not \"file\"",
                                               place("fibres.file"), place("fibres.direction")));
    }
    if (remodelling.has_fibres())
    {
        check_fibres(remodelling.fibres, place);
    }
    if (remodelling.any() && options.formulation == thesis::Formulation::thesis)
    {
        const std::string_view key = remodelling.has_fibres()             ? "fibres.direction"
                                     : remodelling.relaxation.share > 0.0 ? "relaxation.share"
                                                                          : "stress_growth.rate";
        throw InputError(fmt::format("{}{} is given, but solver.formulation{} is \"thesis\", which knows no history of "
                                     "the tissue: expected \"corrected\"",
                                     key, place(key), place("solver.formulation")));
    }
}

} // namespace corticle::config
