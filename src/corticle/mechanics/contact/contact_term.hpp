// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mechanics/force_term.hpp"
#include "corticle/mesh/cloud.hpp"

namespace corticle::contact
{

/// Contact of the body's surface with itself, among the forces of a simulation.
class ContactTerm final : public mechanics::ForceTerm
{
  public:
    /// @param surface    its reference surface, whose vertices are cloud.surface_particles
    /// @param masses     of the nodes
    /// @param frequency  see SurfaceContact
    /// @param fixed_step whether the step is given and contact does not shorten it
    ContactTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses, double frequency,
                const ContactOptions& options, bool fixed_step);

    std::string_view name() const override { return "contact"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    std::vector<mechanics::NamedEnergy> energies() const override { return {{"contact", contact_.energy()}}; }
    mechanics::TravelTaken limit_travel(const dynamics::Motion& from, double dt, double longest,
                                        dynamics::Motion& to) override;
    std::string cause_of_short_step(std::span<const Vec3> /*x*/) const override
    {
        return "stiffest contact: " + contact_.stiffest_pair();
    }

    /// Of the last evaluation.
    const ContactResponse& response() const { return response_; }

  private:
    std::vector<std::int32_t> particles_; ///< of the surface, ascending: neighbours stand near each other
    std::vector<double> masses_;          ///< of the particles of the surface
    SurfaceContact contact_;
    bool fixed_step_;
    ContactResponse response_;
    std::vector<Vec3> displacement_; ///< of the vertices of the surface in the step [mm]
};

} // namespace corticle::contact
