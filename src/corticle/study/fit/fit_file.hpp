// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/parameter_space.hpp"
#include "corticle/study/fit/quantity.hpp"
#include "corticle/study/surrogate/minimize.hpp"

namespace corticle::fit
{

/// What a study starts from: the keys that fits and sensitivity analyses have in common.
struct StudyBase
{
    std::filesystem::path base; ///< the case, absolute
    std::string title;
    std::vector<std::string> settings; ///< "section.key=value" for all runs
    std::uint64_t seed = 1;
    config::Options options; ///< of the base with the settings
};

/// Points where the runs are made from which the surrogate is learnt.
struct SurrogateOptions
{
    int points = 0;       ///< a latin hypercube; 0: no surrogate, and no uncertainty
    double width = 1.0;   ///< share of the cube that they cover, about the best point so far
    int refinements = 6;  ///< most rounds of runs where the surrogate expects the parameters
    double share = 0.1;   ///< of the variance of each parameter that is the surrogate's: rounds end there
    int runs_a_round = 4; ///< the most likely point, and draws from the posterior
};

/// Runs of higher fidelity that correct those of the base.
struct FidelityOptions
{
    std::vector<std::string> settings; ///< what makes them dear; empty: no correction
    int runs = 3;
};

struct PosteriorOptions
{
    bool is_laplace = false; ///< normal about the most likely point, else a random walk
    int samples = 20000;     ///< of the walk, over all chains
};

/// What a fit file says.
struct FitFile
{
    StudyBase study;
    ParameterSpace space;
    std::vector<Quantity> targets;
    std::vector<Quantity> predictions;
    std::optional<Minimization> search;
    SurrogateOptions surrogate;
    FidelityOptions fidelity;
    PosteriorOptions posterior;

    /// Targets, then predictions.
    std::vector<Quantity> quantities() const;
};

/// Reads base, title, seed and [set]. @throws InputError
StudyBase read_study_base(const config::TomlNode& document, const sweep::SweepPlace& place,
                          std::span<const std::string> overrides);

/// Reads a fit (TOML): base, title, seed, [set], [[parameter]], [[target]], [[predict]], [search], [surrogate],
/// [fidelity], [posterior].
/// @param overrides  "section.key=value" for all runs
/// @throws InputError, one line
FitFile read_fit(const std::filesystem::path& file, std::span<const std::string> overrides);
FitFile parse_fit(std::string_view text, const std::string& name, const std::filesystem::path& directory,
                  std::span<const std::string> overrides);

} // namespace corticle::fit
