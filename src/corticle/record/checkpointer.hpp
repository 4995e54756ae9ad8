// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measuring.hpp"

#include <chrono>
#include <filesystem>
#include <string>

namespace corticle::record
{

/// Keeps the checkpoint of a run up to date: at output times, every so many minutes, and where a run is interrupted.
/// Comes last of the observers: what a checkpoint counts as written must have been written.
class Checkpointer final : public model::Observer
{
  public:
    /// @param folder     of the run
    /// @param case_text  the case as to_toml() writes it
    /// @param versions   of the program, see versions_after()
    /// @param minutes    between checkpoints
    /// @param seconds    to which the wall time it takes is added
    Checkpointer(std::filesystem::path folder, std::string case_text, std::string versions, double minutes,
                 const metrics::Measuring& measuring, double& seconds);

    bool wants_state() override;
    void on_step(const model::Simulation& simulation) override;
    void on_output(const model::OutputView& view) override { save(view.simulation); }
    void on_end(const model::Simulation& simulation, model::RunStatus status) override;

  private:
    void save(const model::Simulation& simulation);

    using Clock = std::chrono::steady_clock;
    std::filesystem::path folder_;
    std::string case_text_;
    std::string versions_;
    double minutes_;
    const metrics::Measuring& measuring_;
    double& seconds_;
    Clock::time_point saved_at_;
    bool is_due_ = false;
};

} // namespace corticle::record
