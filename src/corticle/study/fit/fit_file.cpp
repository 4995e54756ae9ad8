// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/fit_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace corticle::fit
{

namespace
{

namespace fs = std::filesystem;

constexpr int most_evaluations = 100000;
constexpr int most_points = 2000;
constexpr double least_width = 0.01;

/// Runs are looked at by no one.
constexpr std::array quiet_settings{"output.pictures=\"off\"", "output.report=\"off\""};

Minimization read_search(const config::TomlNode& node, const sweep::SweepPlace& place, std::uint64_t seed)
{
    static constexpr std::array<std::string_view, 4> keys{"method", "evaluations", "tolerance", "step"};
    const TableReader table(node, place, "[search]", keys);
    Minimization search;
    const std::string name = table.text("method", "BOBYQA");
    search.method = find_method(name);
    if (search.method.empty())
    {
        throw InputError(fmt::format("method ({}): got \"{}\", expected BOBYQA, DIRECT, CRS, COBYLA, NELDERMEAD, SBPLX "
                                     "or another of NLopt's without derivatives: {}",
                                     table.where(), config::printable(name), fmt::join(method_names(), ", ")));
    }
    search.evaluations = static_cast<int>(table.count("evaluations", 60, 1, most_evaluations));
    search.tolerance = table.positive_if("tolerance").value_or(1e-3);
    search.step = table.positive_if("step").value_or(0.2);
    search.seed = seed;
    return search;
}

SurrogateOptions read_surrogate(const config::TomlNode& node, const sweep::SweepPlace& place, std::size_t parameters)
{
    static constexpr std::array<std::string_view, 5> keys{"points", "width", "refinements", "runs_a_round", "share"};
    const TableReader table(node, place, "[surrogate]", keys);
    SurrogateOptions options;
    const auto fewest = static_cast<std::int64_t>(2 * (parameters + 1));
    options.points =
        static_cast<int>(table.count("points", 12 * static_cast<std::int64_t>(parameters), 0, most_points));
    if (options.points > 0 && options.points < fewest)
    {
        throw InputError(fmt::format("points ({}): got {}, expected 0 (no surrogate) or at least {} for {} parameters",
                                     table.where(), options.points, fewest, parameters));
    }
    options.width = table.positive_if("width").value_or(1.0);
    if (options.width > 1.0 || options.width < least_width)
    {
        throw InputError(fmt::format("width ({}): got {}, expected a share from {} to 1", table.where(), options.width,
                                     least_width));
    }
    options.refinements = static_cast<int>(table.count("refinements", options.refinements, 0, 100));
    options.runs_a_round = static_cast<int>(table.count("runs_a_round", options.runs_a_round, 1, 1000));
    options.share = table.positive_if("share").value_or(options.share);
    if (options.share > 1.0)
    {
        throw InputError(
            fmt::format("share ({}): got {}, expected a share of the variance, up to 1", table.where(), options.share));
    }
    return options;
}

FidelityOptions read_fidelity(const config::TomlNode& node, const sweep::SweepPlace& place)
{
    static constexpr std::array<std::string_view, 2> keys{"runs", "set"};
    const TableReader table(node, place, "[fidelity]", keys);
    FidelityOptions options;
    options.runs = static_cast<int>(table.count("runs", 3, 1, 1000));
    for (const auto& [key, value] : sweep::case_values(table.at("set"), place))
    {
        options.settings.push_back(key + "=" + config::toml_text(value));
    }
    if (options.settings.empty())
    {
        throw InputError(fmt::format("set ({}): empty; expected keys of the case that make runs dearer, such as "
                                     "geometry.particles",
                                     table.where()));
    }
    return options;
}

PosteriorOptions read_posterior(const config::TomlNode& node, const sweep::SweepPlace& place)
{
    static constexpr std::array<std::string_view, 2> keys{"method", "samples"};
    const TableReader table(node, place, "[posterior]", keys);
    const std::string method = table.text("method", "walk");
    if (method != "walk" && method != "laplace")
    {
        throw InputError(fmt::format("method ({}): got \"{}\", expected \"walk\" or \"laplace\"", table.where(),
                                     config::printable(method)));
    }
    return {method == "laplace", static_cast<int>(table.count("samples", 20000, 400, 10'000'000))};
}

void require_sensible(const FitFile& fit, const std::string& name)
{
    const auto key_of = [](const std::string& text) { return text.substr(0, text.find('=')); };
    for (const auto* settings : {&fit.study.settings, &fit.fidelity.settings})
    {
        for (const std::string& text : *settings)
        {
            if (std::ranges::find(fit.space.parameters, key_of(text), &FreeParameter::key) !=
                fit.space.parameters.end())
            {
                throw InputError(fmt::format("{} ({}): both set and a [[parameter]]; expected one of them",
                                             key_of(text), config::printable(name)));
            }
        }
    }
    if (fit.targets.empty())
    {
        throw InputError(fmt::format("{} has no [[target]]; expected at least one", config::printable(name)));
    }
    if (!fit.search && fit.surrogate.points == 0)
    {
        throw InputError(fmt::format("{}: [surrogate] points = 0 without [search]; expected one of them to find the "
                                     "parameters by",
                                     config::printable(name)));
    }
    if (!fit.fidelity.settings.empty() && fit.surrogate.points == 0)
    {
        throw InputError(fmt::format("{}: [fidelity] without a surrogate to correct; expected [surrogate] points > 0",
                                     config::printable(name)));
    }
}

const config::TomlNode* child_of(const config::TomlNode& node, std::string_view key)
{
    const auto found = std::ranges::find(node.children, key, &config::TomlNode::key);
    return found == node.children.end() ? nullptr : &*found;
}

} // namespace

std::vector<Quantity> FitFile::quantities() const
{
    std::vector<Quantity> all = targets;
    all.insert(all.end(), predictions.begin(), predictions.end());
    return all;
}

StudyBase read_study_base(const config::TomlNode& document, const sweep::SweepPlace& place,
                          std::span<const std::string> overrides)
{
    StudyBase study;
    const config::TomlNode* base = child_of(document, "base");
    if (base == nullptr)
    {
        throw InputError(
            fmt::format("{} has no base; expected the case that the runs start from", config::printable(place.name)));
    }
    study.base = fs::absolute(place.directory / sweep::sweep_text(*base, place)).lexically_normal();
    const config::TomlNode* title = child_of(document, "title");
    study.title = title == nullptr ? fs::path(place.name).stem().string() : sweep::sweep_text(*title, place);
    if (const config::TomlNode* seed = child_of(document, "seed"))
    {
        const auto* number = std::get_if<std::int64_t>(&seed->value);
        if (number == nullptr || *number < 0)
        {
            throw InputError(fmt::format("seed ({}): got {}, expected a whole number >= 0", place.at(*seed),
                                         config::describe(seed->value)));
        }
        study.seed = static_cast<std::uint64_t>(*number);
    }
    study.settings.assign(quiet_settings.begin(), quiet_settings.end());
    if (const config::TomlNode* set = child_of(document, "set"))
    {
        for (const auto& [key, value] : sweep::case_values(*set, place))
        {
            study.settings.push_back(key + "=" + config::toml_text(value));
        }
    }
    study.settings.insert(study.settings.end(), overrides.begin(), overrides.end());
    study.options = config::read_case(study.base, study.settings);
    return study;
}

FitFile parse_fit(std::string_view text, const std::string& name, const fs::path& directory,
                  std::span<const std::string> overrides)
{
    static constexpr std::array<std::string_view, 11> keys{"base",      "title",    "seed",     "set",
                                                           "parameter", "target",   "predict",  "search",
                                                           "surrogate", "fidelity", "posterior"};
    const sweep::SweepPlace place{name, directory};
    const config::TomlNode document = config::parse_toml_tree(text, name, "fit");
    const TableReader table(document, place, "a fit", keys);
    FitFile fit;
    fit.study = read_study_base(document, place, overrides);
    fit.space = read_parameters(table.at("parameter"), place, fit.study.options);
    const auto read = [&](const char* key, auto&& reader)
    {
        if (const config::TomlNode* node = table.find(key))
        {
            reader(*node);
        }
    };
    read("target", [&](const auto& node) { fit.targets = read_targets(node, place, fit.study.options); });
    read("predict", [&](const auto& node) { fit.predictions = read_predictions(node, place, fit.study.options); });
    read("search", [&](const auto& node) { fit.search = read_search(node, place, fit.study.seed); });
    fit.surrogate.points = 12 * static_cast<int>(fit.space.size());
    read("surrogate", [&](const auto& node) { fit.surrogate = read_surrogate(node, place, fit.space.size()); });
    read("fidelity", [&](const auto& node) { fit.fidelity = read_fidelity(node, place); });
    read("posterior", [&](const auto& node) { fit.posterior = read_posterior(node, place); });
    require_sensible(fit, name);
    return fit;
}

FitFile read_fit(const fs::path& file, std::span<const std::string> overrides)
{
    return parse_fit(config::read_case_text(file, "fit"), file.string(), file.parent_path(), overrides);
}

} // namespace corticle::fit
