// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measures.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_request.hpp"
#include "corticle/record/summary.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace corticle
{

/// Writes a run into its folder: frames, measures, pictures and a checkpoint at output times, and the summary.
class Recorder
{
  public:
    using Clock = std::chrono::steady_clock;

    /// @param folder    locked; learns of every file before it is written
    /// @param versions  of the program, see versions_after()
    /// @param draws     whether pictures can be drawn
    Recorder(const RunRequest& request, const PreparationReport& made, ResultFolder& folder, std::string versions,
             std::shared_ptr<spdlog::logger> log, Clock::time_point start, bool draws);

    /// Goes on with the rows of measures.csv and the steps of an earlier session.
    void resume(std::vector<Measures> rows, std::int64_t steps);
    /// Whether an output time has been recorded, in this session or an earlier one.
    bool has(double t) const { return !rows_.empty() && rows_.back().t >= t; }

    /// An output time: frame, measures, pictures, checkpoint.
    void record(const Simulation& simulation, bool with_pictures);
    void save(const Simulation& simulation);
    void save_if_due(const Simulation& simulation);
    void summarize(const Simulation& simulation, const std::string& status, const std::string& reason = {});
    /// The failure of a run; without a simulation one that failed before its first state.
    void record_failure(const std::optional<Simulation>& simulation, const std::string& reason);
    void draw_measures();

  private:
    RunInfo run_info(const std::string& status, const std::string& reason, std::int64_t steps) const;
    void write(const Simulation& simulation, std::vector<Mat3> F, const PhysicalScale& scale,
               const SurfaceArrays& arrays, bool with_pictures);

    const RunRequest& request_;
    const PreparationReport& made_;
    ResultFolder& folder_;
    std::string case_text_;
    std::string versions_;
    std::shared_ptr<spdlog::logger> log_;
    Clock::time_point start_;
    Clock::time_point saved_at_;
    double wall_before_ = 0.0; ///< of earlier sessions [s]
    std::int64_t first_step_ = 0;
    std::vector<Measures> rows_;
    double measures_s_ = 0.0;
    double output_s_ = 0.0;
    bool draws_;
    std::set<std::string_view> warned_of_; ///< kinds that the terminal has heard of
};

} // namespace corticle
