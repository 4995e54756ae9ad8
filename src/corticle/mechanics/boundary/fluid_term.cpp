// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/fluid_term.hpp"

#include "corticle/base/gather.hpp"
#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::boundary
{

FluidTerm::FluidTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses,
                     const TiedSurface& ventricles, std::shared_ptr<Skull> skull, const BoundaryOptions& options,
                     double start)
    : options_(options), start_(start), particles_(cloud.surface_particles),
      masses_(gather<double>(masses, particles_)), at_(surface.vertices),
      brain_(cloud.surface_triangles, particles_.size()), ventricles_(ventricles), wall_(ventricles.nodes.size()),
      inner_(ventricles.triangles, ventricles.nodes.size()), skull_(std::move(skull))
{
    if (skull_)
    {
        outer_.emplace(skull_->triangles(), skull_->positions().size());
    }
    measure(cloud.positions);
    first_volume_ = fluid_volume();
    first_inner_ = inner_.volume();
}

/// Volumes and their gradients.
void FluidTerm::measure(std::span<const Vec3> x)
{
    parallel_for(std::ssize(particles_), [&](std::int64_t k) { at_[k] = x[particles_[k]]; });
    brain_.evaluate(at_);
    parallel_for(std::ssize(wall_),
                 [&](std::int64_t k)
                 {
                     Vec3 sum;
                     for (std::size_t m = 0; m < 4; ++m)
                     {
                         sum += ventricles_.weights[k][m] * x[ventricles_.nodes[k][m]];
                     }
                     wall_[k] = sum;
                 });
    inner_.evaluate(wall_);
    if (outer_)
    {
        outer_->evaluate(skull_->positions());
        skull_volume_ = outer_->volume();
    }
}

/// A pressure rises from 0 at the start.
double FluidTerm::ramp(double t) const
{
    return std::clamp((t - start_) / options_.pressure_time, 0.0, 1.0);
}

void FluidTerm::set_pressure(double t)
{
    const double more = fluid_volume() - first_volume_;
    pressure_ = 0.0;
    energy_ = 0.0;
    if (options_.fluid == Fluid::constant)
    {
        pressure_ = ramp(t) * options_.pressure;
        energy_ = -pressure_ * more;
    }
    else if (options_.fluid == Fluid::conserved)
    {
        pressure_ = -options_.bulk_modulus * more / first_volume_;
        energy_ = -0.5 * pressure_ * more;
    }
    energy_ -= ramp(t) * options_.ventricle_pressure * (inner_.volume() - first_inner_);
}

void FluidTerm::push_skull()
{
    if (outer_)
    {
        const std::span<Vec3> forces = skull_->forces();
        const std::span<const Vec3> gradient = outer_->gradient();
        for (std::size_t k = 0; k < forces.size(); ++k)
        {
            forces[k] += pressure_ * gradient[k];
        }
    }
}

void FluidTerm::push_ventricles(double pressure, std::span<Vec3> forces) const
{
    // Vertices share nodes, so they are taken in order.
    for (std::size_t k = 0; k < wall_.size(); ++k)
    {
        for (std::size_t m = 0; m < 4; ++m)
        {
            forces[static_cast<std::size_t>(ventricles_.nodes[k][m])] +=
                pressure * ventricles_.weights[k][m] * inner_.gradient()[k];
        }
    }
}

/// Largest frequency of the nodes of the brain's surface on the fluid, a spring of the whole volume:
/// w² = K / V sum |dV/dx_i|² / m_i.
double FluidTerm::largest_rate() const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < particles_.size(); ++k)
    {
        sum += squared_norm(brain_.gradient()[k]) / masses_[k];
    }
    for (std::size_t k = 0; outer_ && k < outer_->gradient().size(); ++k)
    {
        sum += squared_norm(outer_->gradient()[k]) / skull_->mass_in_contact();
    }
    return std::sqrt(options_.bulk_modulus / first_volume_ * sum);
}

mechanics::Contribution FluidTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    measure(context.x);
    set_pressure(context.t);
    parallel_for(std::ssize(particles_),
                 [&](std::int64_t k) { forces[particles_[k]] -= pressure_ * brain_.gradient()[k]; });
    push_skull();
    mechanics::Contribution contribution;
    const double t = context.t;
    const double rise = t >= start_ && t < start_ + options_.pressure_time ? 1.0 / options_.pressure_time : 0.0;
    if (options_.fluid == Fluid::constant)
    {
        contribution.growth_power -= rise * options_.pressure * (fluid_volume() - first_volume_);
    }
    if (options_.fluid == Fluid::conserved)
    {
        constexpr double share = 1.6; // beside tissue and contact: squares add up to less than 2²
        contribution.stable_step = share * context.cfl / largest_rate();
    }
    if (options_.ventricle_pressure != 0.0)
    {
        contribution.growth_power -= rise * options_.ventricle_pressure * (inner_.volume() - first_inner_);
        push_ventricles(ramp(t) * options_.ventricle_pressure, forces);
    }
    return contribution;
}

} // namespace corticle::boundary
