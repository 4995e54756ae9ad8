// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/physical_scale.hpp"

#include <algorithm>

namespace corticle::model
{

namespace
{

double extent(std::span<const Vec3> positions, int axis)
{
    const auto [low, high] = std::minmax_element(positions.begin(), positions.end(),
                                                 [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    return (*high)[axis] - (*low)[axis];
}

/// Length of the body now over its length at the start, along the axis in which it was longest.
double lengthening(const Simulation& simulation)
{
    const std::vector<Vec3>& X = simulation.model().surface.vertices;
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
        longest = extent(X, axis) > extent(X, longest) ? axis : longest;
    }
    return extent(simulation.surface_positions(), longest) / extent(X, longest);
}

} // namespace

PhysicalScale physical_scale(const Simulation& simulation)
{
    const SimulationOptions& options = simulation.options();
    const material::GestationalClock clock = options.time.clock;
    if (clock == material::GestationalClock::none)
    {
        return {};
    }
    PhysicalScale scale;
    // The start of the cubic clock, rounded to 0, lies before its own 22 weeks.
    const double t = simulation.state().t;
    scale.week = t <= options.time.start ? *options.time.start_week : material::gestational_week(clock, t);
    if (options.size.scaled && options.size.law != material::LengthLaw::none)
    {
        scale.length = material::brain_length(options.size.law, clock, scale.week) /
                       material::brain_length(options.size.law, clock, *options.time.start_week);
        scale.length /= options.size.applies_to == material::SizedState::body ? lengthening(simulation) : 1.0;
    }
    return scale;
}

std::vector<Vec3> scaled(std::span<const Vec3> positions, double factor)
{
    std::vector<Vec3> result(positions.begin(), positions.end());
    for (Vec3& x : result)
    {
        x *= factor;
    }
    return result;
}

} // namespace corticle::model
