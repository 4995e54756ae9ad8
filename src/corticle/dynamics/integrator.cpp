// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/integrator.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::dynamics
{

StepEnergies advance(const Motion& from, std::span<const double> mass, double dt, double damping, Motion& to)
{
    const double decay = std::exp(-damping * dt);
    const auto count = static_cast<std::int64_t>(mass.size());
    StepEnergies energies = parallel_reduce(
        count, StepEnergies{},
        [&](std::int64_t begin, std::int64_t end)
        {
            StepEnergies sum;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            {
                const double half_mass = 0.5 * mass[i];
                const Vec3 driven = from.v[i] + (dt / mass[i]) * from.force[i];
                const Vec3 velocity = decay * driven;
                const double squared_speed = squared_norm(velocity);
                const double kinetic = half_mass * squared_speed;
                sum.damped += half_mass * squared_norm(driven) - kinetic;
                sum.kinetic += kinetic;
                sum.longest = std::max(sum.longest, squared_speed);
                to.v[i] = velocity;
                to.x[i] = from.x[i] + dt * velocity;
            }
            return sum;
        },
        [](StepEnergies& total, const StepEnergies& part)
        {
            total.kinetic += part.kinetic;
            total.damped += part.damped;
            total.longest = std::max(total.longest, part.longest);
        });
    energies.longest = dt * std::sqrt(energies.longest);
    return energies;
}

} // namespace corticle::dynamics
