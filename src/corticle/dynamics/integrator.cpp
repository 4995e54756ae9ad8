// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/integrator.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::dynamics
{

StepEnergies advance(const Motion& from, std::span<const double> mass, double dt, const Medium& medium,
                     const Share& share, Motion& to)
{
    const double decay = std::exp(-medium.damping * dt);
    StepEnergies energies = share.reduce(
        StepEnergies{},
        [&](std::int64_t begin, std::int64_t end)
        {
            StepEnergies sum;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            {
                const double half_mass = 0.5 * mass[i];
                const Vec3 carried = medium.velocity(from.x[i]);
                const Vec3 driven = from.v[i] + (dt / mass[i]) * from.force[i] - carried;
                const Vec3 relative = decay * driven;
                const Vec3 velocity = relative + carried;
                const double squared_speed = squared_norm(velocity);
                const double kinetic = half_mass * squared_norm(relative);
                sum.damped += half_mass * squared_norm(driven) - kinetic;
                sum.carried += mass[i] * dot(carried, relative - driven);
                sum.relative += kinetic;
                sum.kinetic += half_mass * squared_speed;
                sum.longest = std::max(sum.longest, squared_speed);
                to.v[i] = velocity;
                to.x[i] = from.x[i] + dt * velocity;
            }
            return sum;
        },
        [](StepEnergies& total, const StepEnergies& part)
        {
            total.kinetic += part.kinetic;
            total.relative += part.relative;
            total.damped += part.damped;
            total.carried += part.carried;
            total.longest = std::max(total.longest, part.longest);
        });
    energies.longest = dt * std::sqrt(energies.longest);
    return energies;
}

KineticEnergies kinetic_energies(const Motion& motion, std::span<const double> mass, const Medium& medium,
                                 const Share& share)
{
    const auto sum = [&](auto velocity)
    { return share.sum([&](std::int64_t i) { return 0.5 * mass[i] * squared_norm(velocity(i)); }); };
    return {sum([&](std::int64_t i) { return motion.v[i]; }),
            sum([&](std::int64_t i) { return motion.v[i] - medium.velocity(motion.x[i]); })};
}

} // namespace corticle::dynamics
