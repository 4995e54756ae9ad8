// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/parameter_space.hpp"
#include "corticle/study/fit/quantity.hpp"

#include <functional>
#include <map>

namespace corticle::fit
{

/// Thrown when a signal asked for an end; the runs have ended with their checkpoints.
struct Interrupted
{
};

/// One run for one choice of parameters.
struct Evaluation
{
    std::string stage;          ///< what asked for it: "search", "design", "refinement", "dear" ...
    Point u;                    ///< in the unit cube
    std::vector<double> values; ///< of the parameters
    std::string folder;         ///< relative, "runs/0123456789abcdef"; empty where the case is not valid
    std::string failure;        ///< reason; empty: it gave all quantities
    std::vector<double> predicted;
};

/// How runs are made.
struct RunMaking
{
    std::filesystem::path out;  ///< cases/ and failures.json go here
    std::filesystem::path runs; ///< folder of the run folders; several fits may share it, one at a time
    std::string command = "/proc/self/exe";
    int jobs = 0;
    int threads_per_run = 0;
    bool quiet = true; ///< no line for each run of a batch
};

/// Makes runs of a base case. Each has a folder named after what makes it, the resolved case, so that it is made once
/// whatever asks for it, and a study that is made again after an interruption finds all that was finished.
class Evaluator
{
  public:
    Evaluator(std::filesystem::path base, std::vector<std::string> settings, const ParameterSpace& space,
              std::vector<Quantity> quantities, RunMaking making);

    /// Runs for these points, side by side; `more` ("section.key=value") are settings of this batch. In the order of
    /// the points. @throws Interrupted
    std::vector<Evaluation> evaluate(std::span<const Point> points, const std::string& stage,
                                     std::span<const std::string> more = {});

    /// The resolved case of a point. @throws InputError where its values do not go together
    config::Options options_at(std::span<const double> u, std::span<const std::string> more) const;

    /// Runs that were made by this object, not found.
    std::size_t made() const { return made_; }

  private:
    struct Planned;

    Planned plan(const Point& u, const std::string& stage, std::span<const std::string> more) const;
    void make(std::span<Planned> planned);
    void note_failure(const std::string& key, const std::string& reason);
    void collect(Planned& planned) const;

    std::filesystem::path base_;
    std::string base_text_;
    std::vector<std::string> settings_;
    const ParameterSpace& space_;
    std::vector<Quantity> quantities_;
    RunMaking making_;
    std::map<std::string, std::string> failures_; ///< of runs that leave no trace in their folder, by its name
    std::size_t made_ = 0;
};

} // namespace corticle::fit
