// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/output_view.hpp"

#include <functional>
#include <span>

namespace corticle::model
{

/// How a run ended.
enum class RunStatus
{
    completed,
    interrupted
};

/// Something that looks at a simulation as it goes on: a recorder, a progress line, pictures, a callback. Observers are
/// called in the order of their list; what one throws ends the run.
class Observer
{
  public:
    Observer() = default;
    Observer(const Observer&) = delete;
    Observer& operator=(const Observer&) = delete;
    virtual ~Observer() = default;

    /// Asked before on_step: whether it is to see the whole state there, and not only what all ranks know.
    virtual bool wants_state() { return false; }
    /// A step was taken that did not reach an output time.
    virtual void on_step(const Simulation& /*simulation*/) {}
    virtual void on_output(const OutputView& /*view*/) {}
    virtual void on_end(const Simulation& /*simulation*/, RunStatus /*status*/) {}
};

/// Steps a simulation from output time to output time.
/// @param times   growth times of the outputs, ascending; those before the present state are passed over
/// @param first   number of the first of them
/// @param stop    asked after every step; true ends the run there
/// Of several ranks all call it, and rank 0 alone has observers; any rank can stop the run.
RunStatus fold(Simulation& simulation, std::span<const double> times, std::size_t first,
               std::span<Observer* const> observers, const std::function<bool()>& stop);

} // namespace corticle::model
