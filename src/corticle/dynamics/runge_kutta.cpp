// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/runge_kutta.hpp"

#include "corticle/base/parallel.hpp"

namespace corticle::dynamics
{

namespace
{

double kinetic_energy(const Motion& motion, std::span<const double> mass)
{
    return parallel_sum(std::ssize(mass), [&](std::int64_t i) { return 0.5 * mass[i] * squared_norm(motion.v[i]); });
}

} // namespace

std::optional<StepEnergies> RungeKutta4::advance(const Motion& from, std::span<const double> mass, double dt,
                                                 double damping, const Evaluate& evaluate, Motion& to)
{
    constexpr double parts[] = {0.5, 0.5, 1.0}; // of the step, where stages two to four lie
    constexpr double weights[] = {1.0, 2.0, 2.0};
    velocity_sum_.assign(mass.size(), Vec3{});
    rate_sum_.assign(mass.size(), Vec3{});
    for (int stage = 0; stage < 3; ++stage)
    {
        const Motion& last = stage == 0 ? from : to;
        parallel_for(std::ssize(mass),
                     [&](std::int64_t i)
                     {
                         const Vec3 velocity = last.v[i];
                         const Vec3 rate = last.force[i] / mass[i] - damping * velocity;
                         velocity_sum_[i] += weights[stage] * velocity;
                         rate_sum_[i] += weights[stage] * rate;
                         to.x[i] = from.x[i] + (parts[stage] * dt) * velocity;
                         to.v[i] = from.v[i] + (parts[stage] * dt) * rate;
                     });
        if (!evaluate(to, parts[stage]))
        {
            return std::nullopt;
        }
    }
    parallel_for(std::ssize(mass),
                 [&](std::int64_t i)
                 {
                     const Vec3 rate = to.force[i] / mass[i] - damping * to.v[i];
                     to.x[i] = from.x[i] + (dt / 6.0) * (velocity_sum_[i] + to.v[i]);
                     to.v[i] = from.v[i] + (dt / 6.0) * (rate_sum_[i] + rate);
                 });
    StepEnergies energies;
    energies.kinetic = kinetic_energy(to, mass);
    energies.damped = damping * dt * (kinetic_energy(from, mass) + energies.kinetic);
    return energies;
}

} // namespace corticle::dynamics
