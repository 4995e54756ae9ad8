// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measures.hpp"
#include "corticle/model/observer.hpp"

namespace corticle::metrics
{

/// Measures a run at its output times. Comes before the observers that write or draw what it finds.
class Measuring final : public model::Observer
{
  public:
    /// @param earlier  rows of an earlier session of the run
    explicit Measuring(std::vector<Measures> earlier = {}) : rows_(std::move(earlier)) {}

    void on_output(const model::OutputView& view) override;

    /// One row for every output so far.
    const std::vector<Measures>& rows() const { return rows_; }
    /// Of the surface at the last output.
    const SurfaceArrays& arrays() const { return arrays_; }
    /// Wall time it took [s].
    double seconds() const { return seconds_; }

  private:
    std::vector<Measures> rows_;
    SurfaceArrays arrays_;
    double seconds_ = 0.0;
};

} // namespace corticle::metrics
