// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/support_term.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::boundary
{

namespace
{

constexpr double plane_in_spacings = 0.25; ///< nodes closer than this to a face of the body are on it

bool holds(Axes axes, std::int32_t axis)
{
    const char letter = "xyz"[axis];
    return axes != Axes::none &&
           std::string_view(axes_names[static_cast<std::size_t>(axes)]).find(letter) != std::string_view::npos;
}

/// The normal of a face.
Axes normal_of(Face face)
{
    constexpr std::array normals{Axes::none, Axes::x, Axes::x, Axes::y, Axes::y, Axes::z, Axes::z};
    return normals[static_cast<std::size_t>(face)];
}

Axes held_axes(const SupportOptions& support)
{
    if (support.kind == SupportKind::fixed)
    {
        return Axes::xyz;
    }
    return support.axes != Axes::none ? support.axes : normal_of(support.plane);
}

/// The region in which a support holds nodes.
Box region_of(const SupportOptions& support, const Box& body, double spacing)
{
    Box region;
    region.low = {support.low_mm[0], support.low_mm[1], support.low_mm[2]};
    region.high = {support.high_mm[0], support.high_mm[1], support.high_mm[2]};
    if (support.plane != Face::none)
    {
        const auto face = static_cast<std::int32_t>(support.plane) - 1;
        const std::int32_t axis = face / 2;
        const double depth = plane_in_spacings * spacing;
        double& low = region.low[axis];
        double& high = region.high[axis];
        low = face % 2 == 0 ? low : std::max(low, body.high[axis] - depth);
        high = face % 2 == 1 ? high : std::min(high, body.low[axis] + depth);
    }
    return region;
}

bool lies_in(const Box& region, const Vec3& p)
{
    return p.x >= region.low.x && p.x <= region.high.x && p.y >= region.low.y && p.y <= region.high.y &&
           p.z >= region.low.z && p.z <= region.high.z;
}

/// How far a support moves along an axis at growth time t, as a share of the whole way; and its rate [1/t].
double ramp(const SupportOptions& support, double t)
{
    return std::clamp((t - support.start) / (support.end - support.start), 0.0, 1.0);
}
double ramp_rate(const SupportOptions& support, double t)
{
    return t >= support.start && t < support.end ? 1.0 / (support.end - support.start) : 0.0;
}

double way(const SupportOptions& support, std::int32_t axis)
{
    return support.kind == SupportKind::displacement ? support.displacement_mm[static_cast<std::size_t>(axis)] : 0.0;
}

bool agree(const SupportOptions& a, const SupportOptions& b, std::int32_t axis)
{
    const double of_a = way(a, axis);
    return of_a == way(b, axis) && (of_a == 0.0 || (a.start == b.start && a.end == b.end));
}

} // namespace

std::vector<HeldDegree> held_degrees(const Cloud& cloud, std::span<const SupportOptions> supports)
{
    const Box body = bounding_box(cloud.positions);
    std::vector<HeldDegree> held;
    std::vector<std::int32_t> holder(3 * cloud.positions.size(), -1);
    for (std::int32_t k = 0; k < std::ssize(supports); ++k)
    {
        const SupportOptions& support = supports[static_cast<std::size_t>(k)];
        const Box region = region_of(support, body, cloud.spacing);
        const Axes axes = held_axes(support);
        std::int64_t nodes = 0;
        for (std::int32_t i = 0; i < std::ssize(cloud.positions); ++i)
        {
            const Vec3& X = cloud.positions[static_cast<std::size_t>(i)];
            if (!lies_in(region, X))
            {
                continue;
            }
            ++nodes;
            for (std::int32_t axis = 0; axis < 3; ++axis)
            {
                std::int32_t& other = holder[static_cast<std::size_t>(3 * i + axis)];
                if (holds(axes, axis) && other < 0)
                {
                    other = k;
                }
                else if (holds(axes, axis) && !agree(support, supports[static_cast<std::size_t>(other)], axis))
                {
                    throw InputError(fmt::format("supports {} and {} both hold the node at ({:.4g}, {:.4g}, {:.4g}) mm "
                                                 "along {}, but differ in where it goes",
                                                 other + 1, k + 1, X.x, X.y, X.z, "xyz"[axis]));
                }
            }
        }
        if (nodes == 0)
        {
            throw InputError(fmt::format("support {} holds no node: the body lies in ({:.4g}, {:.4g}, {:.4g}) to "
                                         "({:.4g}, {:.4g}, {:.4g}) mm",
                                         k + 1, body.low.x, body.low.y, body.low.z, body.high.x, body.high.y,
                                         body.high.z));
        }
    }
    for (std::int32_t degree = 0; degree < std::ssize(holder); ++degree)
    {
        if (const std::int32_t support = holder[static_cast<std::size_t>(degree)]; support >= 0)
        {
            held.push_back({degree / 3, degree % 3, support});
        }
    }
    return held;
}

SupportTerm::SupportTerm(const Cloud& cloud, std::span<const double> masses, std::span<const SupportOptions> supports)
    : supports_(supports.begin(), supports.end()), held_(held_degrees(cloud, supports)), states_(supports.size())
{
    std::vector<std::int32_t> last(supports.size(), -1);
    for (const auto& [node, axis, support] : held_)
    {
        rest_.push_back(cloud.positions[static_cast<std::size_t>(node)][axis]);
        masses_.push_back(masses[static_cast<std::size_t>(node)]);
        std::int32_t& before = last[static_cast<std::size_t>(support)];
        states_[static_cast<std::size_t>(support)].nodes += before != node ? 1 : 0;
        before = node;
    }
}

mechanics::Contribution SupportTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
        const double share = ramp(supports_[k], context.t);
        states_[k].reaction = {};
        states_[k].displacement = {share * way(supports_[k], 0), share * way(supports_[k], 1),
                                   share * way(supports_[k], 2)};
    }
    mechanics::Contribution contribution;
    for (const auto& [node, axis, k] : held_)
    {
        double& force = forces[static_cast<std::size_t>(node)][axis];
        const auto support = static_cast<std::size_t>(k);
        states_[support].reaction[axis] -= force;
        contribution.growth_power -= force * way(supports_[support], axis) * ramp_rate(supports_[support], context.t);
        force = 0.0;
    }
    return contribution;
}

/// Puts the nodes where they are to be at the end of the step.
mechanics::TravelTaken SupportTerm::limit_travel(const dynamics::Motion& from, const dynamics::StepPlan& plan,
                                                 double& longest, dynamics::Motion& to)
{
    mechanics::TravelTaken taken;
    for (std::size_t d = 0; d < held_.size(); ++d)
    {
        const auto& [node, axis, k] = held_[d];
        const SupportOptions& support = supports_[static_cast<std::size_t>(k)];
        const auto i = static_cast<std::size_t>(node);
        const double x = rest_[d] + ramp(support, plan.t) * way(support, axis);
        const double v = (x - from.x[i][axis]) / plan.dt;
        const double before = to.v[i][axis];
        taken.supplied += 0.5 * masses_[d] * (v * v - before * before);
        to.x[i][axis] = x;
        to.v[i][axis] = v;
        longest = std::max(longest, norm(to.x[i] - from.x[i]));
    }
    return taken;
}

} // namespace corticle::boundary
