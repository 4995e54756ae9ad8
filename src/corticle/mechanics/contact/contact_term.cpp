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

/// The number of each vertex of the surface in ascending order of their particles.
std::vector<std::int32_t> places_of_vertices(const Cloud& cloud, std::span<const std::int32_t> particles)
{
    std::vector<std::int32_t> places;
    places.reserve(cloud.surface_particles.size());
    for (const std::int32_t particle : cloud.surface_particles)
    {
        places.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(particles, particle) - particles.begin()));
    }
    return places;
}

/// Contact of the body's surface, whose vertices are numbered as in `particles`, and of the skull behind it.
SurfaceContact contact_of(const Cloud& cloud, const TriangleMesh& surface, std::span<const std::int32_t> particles,
                          std::span<const std::int32_t> vertex_at, std::vector<double> masses, double frequency,
                          const ContactOptions& options, const Share& share, const boundary::Skull* skull)
{
    std::vector<Triangle> triangles;
    triangles.reserve(cloud.surface_triangles.size());
    for (const auto& [a, b, c] : cloud.surface_triangles)
    {
        triangles.push_back({vertex_at[a], vertex_at[b], vertex_at[c]});
    }
    std::vector<Vec3> rest(particles.size());
    for (std::int32_t vertex = 0; vertex < std::ssize(rest); ++vertex)
    {
        rest[vertex_at[vertex]] = surface.vertices[vertex];
    }
    if (skull == nullptr)
    {
        return {triangles,
                rest,
                std::move(masses),
                cloud.spacing,
                frequency,
                options,
                {particles.begin(), particles.end()},
                no_wall,
                SurfaceShare(share, particles)};
    }
    const auto wall = static_cast<std::int32_t>(rest.size());
    rest.insert(rest.end(), skull->positions().begin(), skull->positions().end());
    masses.resize(rest.size(), skull->mass_in_contact());
    for (const auto& [a, b, c] : skull->triangles())
    {
        triangles.push_back({wall + a, wall + b, wall + c});
    }
    return {triangles, rest, std::move(masses), cloud.spacing, frequency, options, {}, wall};
}

} // namespace

ContactTerm::ContactTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses,
                         double frequency, const ContactOptions& options, bool fixed_step, const Share& share,
                         std::shared_ptr<boundary::Skull> skull)
    : particles_(sorted(cloud.surface_particles)), masses_(gather<double>(masses, particles_)),
      vertex_at_(places_of_vertices(cloud, particles_)), skull_(std::move(skull)),
      contact_(contact_of(cloud, surface, particles_, vertex_at_, masses_, frequency, options, share, skull_.get())),
      fixed_step_(fixed_step)
{
}

/// Vectors of the vertices of the body's surface, then of the skull.
void ContactTerm::gather_surfaces(std::span<const Vec3> of_body, std::span<const Vec3> of_skull,
                                  std::vector<Vec3>& both) const
{
    both.resize(particles_.size() + of_skull.size());
    parallel_runs(each(std::ssize(particles_), [&](std::int64_t k) { both[k] = of_body[particles_[k]]; }));
    std::ranges::copy(of_skull, both.begin() + std::ssize(particles_));
}

mechanics::Contribution ContactTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    mechanics::Contribution contribution;
    energy_.reset();
    if (skull_)
    {
        gather_surfaces(context.x, skull_->positions(), positions_);
        forces_.assign(positions_.size(), {});
        response_ = contact_.evaluate(positions_, forces_);
        parallel_runs(each(std::ssize(particles_), [&](std::int64_t k) { forces[particles_[k]] += forces_[k]; }));
        for (std::size_t k = 0; k < skull_->forces().size(); ++k)
        {
            skull_->forces()[k] += forces_[particles_.size() + k];
        }
        contribution = skull_->finish(context);
    }
    else
    {
        response_ = contact_.evaluate(context.x, forces);
    }
    if (!fixed_step_)
    {
        contribution.stable_step =
            std::min(contribution.stable_step, dynamics::contact_step(context.cfl, response_.largest_rate));
    }
    return contribution;
}

std::vector<mechanics::NamedEnergy> ContactTerm::energies() const
{
    const double all = energy_ ? *energy_ : contact_.energy();
    if (!skull_)
    {
        return {{"contact", all}};
    }
    const double of_skull = contact_.wall_contact().energy;
    return {{"contact", all - of_skull}, {"skull_contact", of_skull}};
}

WallContact ContactTerm::wall_contact() const
{
    WallContact contact = contact_.wall_contact();
    if (skull_)
    {
        const std::vector<std::uint8_t> pushed = contact.is_pushed;
        for (std::size_t vertex = 0; vertex < vertex_at_.size(); ++vertex)
        {
            contact.is_pushed[vertex] = pushed[static_cast<std::size_t>(vertex_at_[vertex])];
        }
    }
    return contact;
}

/// Shortens the step where the surface would come too close to itself, or to the skull.
mechanics::TravelTaken ContactTerm::limit_travel(const dynamics::Motion& from, const dynamics::StepPlan& plan,
                                                 double& longest, dynamics::Motion& to)
{
    const double dt = plan.dt;
    if (!skull_)
    {
        if (contact_.stays_apart({to.v, dt, longest}))
        {
            return {};
        }
        displacement_.resize(particles_.size());
        parallel_runs(
            each(std::ssize(particles_), [&](std::int64_t k) { displacement_[k] = dt * to.v[particles_[k]]; }));
        return hold_apart(from, dt, to);
    }
    displacement_.resize(particles_.size() + skull_->positions().size());
    parallel_runs(each(std::ssize(particles_), [&](std::int64_t k) { displacement_[k] = dt * to.v[particles_[k]]; }));
    const std::span<Vec3> of_skull = std::span(displacement_).subspan(particles_.size());
    skull_->propose(plan, of_skull);
    double farthest = longest;
    for (const Vec3& way : of_skull)
    {
        farthest = std::max(farthest, norm(way));
    }
    mechanics::TravelTaken taken;
    if (!contact_.stays_apart({displacement_, 1.0, farthest}))
    {
        taken = hold_apart(from, dt, to);
    }
    skull_->move(of_skull, dt);
    return taken;
}

mechanics::TravelTaken ContactTerm::hold_apart(const dynamics::Motion& from, double dt, dynamics::Motion& to)
{
    mechanics::TravelTaken taken;
    for (const std::int32_t vertex : contact_.hold_apart(displacement_))
    {
        if (vertex >= std::ssize(particles_))
        {
            break; // of the skull, which takes its ways from the displacements
        }
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
