// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/contact_term.hpp"

#include "corticle/base/gather.hpp"
#include "corticle/base/parallel.hpp"

#include <algorithm>

namespace corticle::contact
{

namespace
{

std::vector<std::int32_t> sorted(std::vector<std::int32_t> numbers)
{
    std::ranges::sort(numbers);
    return numbers;
}

/// Contact of the body's surface, whose vertices are numbered as in `particles`.
SurfaceContact contact_of(const Cloud& cloud, const TriangleMesh& surface, std::span<const std::int32_t> particles,
                          std::vector<double> masses, double frequency, const ContactOptions& options)
{
    const auto vertex_of = [&](std::int32_t vertex)
    {
        const std::int32_t particle = cloud.surface_particles[static_cast<std::size_t>(vertex)];
        return static_cast<std::int32_t>(std::ranges::lower_bound(particles, particle) - particles.begin());
    };
    std::vector<Triangle> triangles;
    triangles.reserve(cloud.surface_triangles.size());
    for (const auto& [a, b, c] : cloud.surface_triangles)
    {
        triangles.push_back({vertex_of(a), vertex_of(b), vertex_of(c)});
    }
    std::vector<Vec3> rest(particles.size());
    for (std::int32_t vertex = 0; vertex < std::ssize(rest); ++vertex)
    {
        rest[static_cast<std::size_t>(vertex_of(vertex))] = surface.vertices[static_cast<std::size_t>(vertex)];
    }
    return {
        triangles, rest, std::move(masses), cloud.spacing, frequency, options, {particles.begin(), particles.end()}};
}

} // namespace

ContactTerm::ContactTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses,
                         double frequency, const ContactOptions& options, bool fixed_step)
    : particles_(sorted(cloud.surface_particles)), masses_(gather<double>(masses, particles_)),
      contact_(contact_of(cloud, surface, particles_, masses_, frequency, options)), fixed_step_(fixed_step)
{
}

mechanics::Contribution ContactTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    response_ = contact_.evaluate(context.x, forces);
    mechanics::Contribution contribution;
    if (!fixed_step_)
    {
        contribution.stable_step = dynamics::contact_step(context.cfl, response_.largest_rate);
    }
    return contribution;
}

/// Shortens the step where the surface would come too close to itself.
mechanics::TravelTaken ContactTerm::limit_travel(const dynamics::Motion& from, double dt, double longest,
                                                 dynamics::Motion& to)
{
    if (contact_.stays_apart({to.v, dt, longest}))
    {
        return {};
    }
    displacement_.resize(particles_.size());
    parallel_runs(each(std::ssize(particles_), [&](std::int64_t k) { displacement_[k] = dt * to.v[particles_[k]]; }));
    mechanics::TravelTaken taken;
    for (const std::int32_t vertex : contact_.hold_apart(displacement_))
    {
        const std::int32_t i = particles_[static_cast<std::size_t>(vertex)];
        const Vec3 displacement = displacement_[static_cast<std::size_t>(vertex)];
        const Vec3 velocity = displacement / dt;
        taken.energy +=
            0.5 * masses_[static_cast<std::size_t>(vertex)] * (squared_norm(to.v[i]) - squared_norm(velocity));
        ++taken.vertex_steps;
        to.v[i] = velocity;
        to.x[i] = from.x[i] + displacement;
    }
    return taken;
}

} // namespace corticle::contact
