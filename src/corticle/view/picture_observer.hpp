// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measuring.hpp"
#include "corticle/record/recorder.hpp"

#include <vector>

namespace corticle::view
{

/// Draws the pictures of a run, at the outputs that get some and of the measures at its end.
class PictureObserver final : public model::Observer
{
  public:
    /// @param flags     of every output by its number: whether it gets pictures
    /// @param recorder  records the same outputs, before this
    PictureObserver(record::ResultFolder& folder, std::vector<bool> flags, const metrics::Measuring& measuring,
                    record::Recorder& recorder)
        : folder_(folder), flags_(std::move(flags)), measuring_(measuring), recorder_(recorder)
    {
    }

    void on_output(const model::OutputView& view) override;
    void on_end(const model::Simulation& simulation, model::RunStatus status) override;

  private:
    record::ResultFolder& folder_;
    std::vector<bool> flags_;
    const metrics::Measuring& measuring_;
    record::Recorder& recorder_;
};

} // namespace corticle::view
