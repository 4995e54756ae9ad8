// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/observer.hpp"

namespace corticle::model
{

namespace
{

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
            for (Observer* observer : observers)
            {
                observer->on_step(simulation);
            }
            if (stop())
            {
                return tell_end(simulation, RunStatus::interrupted, observers);
            }
        }
        const OutputView view = output_view(simulation, first + k);
        for (Observer* observer : observers)
        {
            observer->on_output(view);
        }
    }
    return tell_end(simulation, RunStatus::completed, observers);
}

} // namespace corticle::model
