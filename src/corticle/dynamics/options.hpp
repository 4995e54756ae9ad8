// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace corticle::dynamics
{

enum class Integrator
{
    symplectic_euler,
    rk4
};

struct DynamicsOptions
{
    Integrator integrator = Integrator::symplectic_euler;
    double time_step = 0.0;        ///< fixed step [t]; 0: as large as the state allows
    double cfl = 0.6;              ///< safety factor of the step
    double loading_time = 50.0;    ///< c_p T / R: time given to t = 0..1, in crossings of the body by a pressure wave
    double fastest_loading = 3.0;  ///< at most, once folds have appeared and while they move slowly [1/T]
    double slowest_loading = 0.25; ///< while growth passes what a flat cortex folds at, until folds appear [1/T]
    double damping = 50.0;         ///< gamma T
    std::int64_t max_halvings = 8; ///< consecutive halvings of the step before a run gives up
};

/// Steps of a fold over those with a constant rate of loading, about: slowed before the onset, quickened after it.
inline double quickened_steps(const DynamicsOptions& options)
{
    return options.fastest_loading > 1.0 ? 0.7 : 1.0;
}

} // namespace corticle::dynamics
