// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/observer.hpp"

#include <algorithm>

namespace corticle::model
{

namespace
{

constexpr unsigned stop_flag = 1;
constexpr unsigned state_flag = 2;

/// What ranks have to agree on after a step. The whole state is brought to those who look at it.
bool is_stopped(Simulation& simulation, std::span<Observer* const> observers, const std::function<bool()>& stop)
{
    const bool wanted = std::ranges::any_of(observers, [](Observer* observer) { return observer->wants_state(); });
    const unsigned flags = simulation.share().ranks().any((stop() ? stop_flag : 0) | (wanted ? state_flag : 0));
    if (flags != 0)
    {
        simulation.complete();
    }
    return (flags & stop_flag) != 0;
}

RunStatus tell_end(const Simulation& simulation, RunStatus status, std::span<Observer* const> observers)
{
    for (Observer* observer : observers)
    {
        observer->on_end(simulation, status);
    }
    return status;
}

} // namespace

RunStatus fold(Simulation& simulation, std::span<const double> times, std::size_t first,
               std::span<Observer* const> observers, const std::function<bool()>& stop)
{
    for (std::size_t k = 0; k < times.size(); ++k)
    {
        if (times[k] < simulation.state().t - same_output_time)
        {
            continue;
        }
        while (simulation.state().t < times[k])
        {
            simulation.step(times[k]);
            if (simulation.state().t >= times[k])
            {
                break; // it is put out at once
            }
            const bool stops = is_stopped(simulation, observers, stop);
            for (Observer* observer : observers)
            {
                observer->on_step(simulation);
            }
            if (stops)
            {
                return tell_end(simulation, RunStatus::interrupted, observers);
            }
        }
        simulation.complete();
        const OutputView view = output_view(simulation, first + k);
        for (Observer* observer : observers)
        {
            observer->on_output(view);
        }
    }
    return tell_end(simulation, RunStatus::completed, observers);
}

} // namespace corticle::model
