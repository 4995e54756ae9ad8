// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/boundary/enclosing_surface.hpp"
#include "corticle/mechanics/boundary/skull.hpp"
#include "corticle/mechanics/boundary/tied_surface.hpp"
#include "corticle/mesh/cloud.hpp"

#include <memory>
#include <optional>

namespace corticle::boundary
{

/// Cerebrospinal fluid: a pressure on the surface of the brain, on the skull where there is one, and on the walls of
/// the ventricles.
class FluidTerm final : public mechanics::ForceTerm
{
  public:
    /// @param surface     of the brain at rest; its vertices are cloud.surface_particles
    /// @param ventricles  without triangles: none
    /// @param skull       may be null
    /// @param start       growth time at which the pressure begins to rise [t]
    FluidTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses,
              const TiedSurface& ventricles, std::shared_ptr<Skull> skull, const BoundaryOptions& options,
              double start);

    std::string_view name() const override { return "fluid"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    std::vector<mechanics::NamedEnergy> energies() const override { return {{"fluid", energy_}}; }
    std::string cause_of_short_step(std::span<const Vec3> /*x*/) const override
    {
        return "stiffness of the fluid between brain and skull (boundary.bulk_modulus)";
    }

    /// On the surface of the brain [mu_w].
    double pressure() const { return pressure_; }
    /// Between brain and skull; 0 without a skull [mm³].
    double outer_volume() const { return skull_ ? skull_volume_ - brain_.volume() : 0.0; }
    double ventricle_volume() const { return inner_.volume(); }

  private:
    double fluid_volume() const { return skull_volume_ - brain_.volume(); }
    void measure(std::span<const Vec3> x);
    void set_pressure(double t);
    double ramp(double t) const;
    void push_skull();
    void push_ventricles(double pressure, std::span<Vec3> forces) const;
    double largest_rate() const;

    BoundaryOptions options_;
    double start_;
    std::vector<std::int32_t> particles_; ///< of the brain's surface
    std::vector<double> masses_;          ///< of these
    std::vector<Vec3> at_;                ///< positions of these [mm]
    EnclosingSurface brain_;
    TiedSurface ventricles_;
    std::vector<Vec3> wall_; ///< positions of their vertices [mm]
    EnclosingSurface inner_;
    std::shared_ptr<Skull> skull_;
    std::optional<EnclosingSurface> outer_;
    double skull_volume_ = 0.0;
    double first_volume_ = 0.0; ///< of the fluid outside, at rest [mm³]
    double first_inner_ = 0.0;  ///< of the ventricles, at rest [mm³]
    double pressure_ = 0.0;
    double energy_ = 0.0;
};

} // namespace corticle::boundary
