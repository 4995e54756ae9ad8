// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measuring.hpp"
#include "corticle/prepare/prepare.hpp"
#include "corticle/record/frames.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_request.hpp"
#include "corticle/record/summary.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace corticle::record
{

/// Writes a run into its folder: frames and measures at output times, lines in run.log, and the summary.
class Recorder final : public model::Observer
{
  public:
    using Clock = std::chrono::steady_clock;

    /// @param made       how the body was made
    /// @param folder     locked; learns of every file before it is written
    /// @param versions   of the program, see versions_after()
    /// @param measuring  measures the same outputs, before the recorder
    Recorder(const RunRequest& request, const prepare::PreparationReport& made, ResultFolder& folder,
             std::string versions, std::shared_ptr<spdlog::logger> log, Clock::time_point start,
             const metrics::Measuring& measuring);

    /// Goes on with the wall time and the steps of an earlier session.
    void resume(std::int64_t steps);

    void on_step(const model::Simulation& /*simulation*/) override { frame_ = {}; }
    void on_output(const model::OutputView& view) override;

    /// The frame of the last output, until the next step: it holds a copy of the body.
    const Frame& frame() const { return frame_; }
    /// Wall time spent in files and pictures [s]; those who write beside the recorder add to it.
    double& output_seconds() { return output_s_; }

    void summarize(const model::Simulation& simulation, const std::string& status, const std::string& reason = {});
    /// The failure of a run; without a simulation one that failed before its first state.
    void record_failure(const model::Simulation* simulation, const std::string& reason);

  private:
    RunInfo run_info(const std::string& status, const std::string& reason, std::int64_t steps) const;
    void log_output(const model::OutputView& view);

    const RunRequest& request_;
    const prepare::PreparationReport& made_;
    ResultFolder& folder_;
    std::string versions_;
    std::shared_ptr<spdlog::logger> log_;
    Clock::time_point start_;
    const metrics::Measuring& measuring_;
    double wall_before_ = 0.0; ///< of earlier sessions [s]
    std::int64_t first_step_ = 0;
    Frame frame_;
    double output_s_ = 0.0;
    std::set<std::string_view> warned_of_; ///< kinds that the terminal has heard of
};

} // namespace corticle::record
