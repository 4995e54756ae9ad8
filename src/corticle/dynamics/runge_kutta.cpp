// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/dynamics/runge_kutta.hpp"

namespace corticle::dynamics
{

std::optional<StepEnergies> RungeKutta4::advance(const Motion& from, std::span<const double> mass, double dt,
                                                 const Medium& medium, const Share& share, const Evaluate& evaluate,
                                                 Motion& to)
{
    const auto rate_of = [&](const Motion& motion, std::int64_t i)
    { return motion.force[i] / mass[i] - medium.damping * (motion.v[i] - medium.velocity(motion.x[i])); };
    constexpr double parts[] = {0.5, 0.5, 1.0}; // of the step, where stages two to four lie
    constexpr double weights[] = {1.0, 2.0, 2.0};
    velocity_sum_.assign(mass.size(), Vec3{});
    rate_sum_.assign(mass.size(), Vec3{});
    for (int stage = 0; stage < 3; ++stage)
    {
        const Motion& last = stage == 0 ? from : to;
        share.each(
            [&](std::int64_t i)
            {
                const Vec3 velocity = last.v[i];
                const Vec3 rate = rate_of(last, i);
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
    share.each(
        [&](std::int64_t i)
        {
            const Vec3 rate = rate_of(to, i);
            to.x[i] = from.x[i] + (dt / 6.0) * (velocity_sum_[i] + to.v[i]);
            to.v[i] = from.v[i] + (dt / 6.0) * (rate_sum_[i] + rate);
        });
    const KineticEnergies before = kinetic_energies(from, mass, medium, share);
    const KineticEnergies after = kinetic_energies(to, mass, medium, share);
    StepEnergies energies{after.whole, after.relative};
    energies.damped = medium.damping * dt * (before.relative + after.relative);
    const auto drag_power = [&](const Motion& motion)
    {
        return share.sum(
            [&](std::int64_t i)
            {
                const Vec3 u = medium.velocity(motion.x[i]);
                return mass[i] * dot(u, u - motion.v[i]);
            });
    };
    energies.carried = 0.5 * medium.damping * dt * (drag_power(from) + drag_power(to));
    return energies;
}

} // namespace corticle::dynamics
