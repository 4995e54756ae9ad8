// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measuring.hpp"
#include "corticle/record/recorder.hpp"

#include <vector>

namespace corticle
{

/// Draws the pictures of a run, at the outputs that get some and of the measures at its end.
class PictureObserver final : public Observer
{
  public:
    /// @param flags     of every output by its number: whether it gets pictures
    /// @param recorder  records the same outputs, before this
    PictureObserver(ResultFolder& folder, std::vector<bool> flags, const Measuring& measuring, Recorder& recorder)
        : folder_(folder), flags_(std::move(flags)), measuring_(measuring), recorder_(recorder)
    {
    }

    void on_output(const OutputView& view) override;
    void on_end(const Simulation& simulation, RunStatus status) override;

  private:
    ResultFolder& folder_;
    std::vector<bool> flags_;
    const Measuring& measuring_;
    Recorder& recorder_;
};

} // namespace corticle
