// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/boundary/skull.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"
#include "corticle/mechanics/force_term.hpp"
#include "corticle/mesh/cloud.hpp"

#include <memory>
#include <optional>

namespace corticle::contact
{

/// Contact of the body's surface with itself, and with a skull around it, among the forces of a simulation. Both are
/// one surface to the travel limit, so that neither kind of contact undoes the other.
class ContactTerm final : public mechanics::ForceTerm
{
  public:
    /// @param surface    its reference surface, whose vertices are cloud.surface_particles
    /// @param masses     of the nodes
    /// @param frequency  see SurfaceContact
    /// @param fixed_step whether the step is given and contact does not shorten it
    /// @param share      of the nodes: contact of the surface with itself is shared, that with a skull is not
    /// @param skull      may be null
    ContactTerm(const Cloud& cloud, const TriangleMesh& surface, std::span<const double> masses, double frequency,
                const ContactOptions& options, bool fixed_step, const Share& share,
                std::shared_ptr<boundary::Skull> skull = nullptr);

    std::string_view name() const override { return "contact"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override;
    std::vector<mechanics::NamedEnergy> energies() const override;
    void complete() override { energy_ = contact_.energy(); }
    mechanics::TravelTaken limit_travel(const dynamics::Motion& from, const dynamics::StepPlan& plan, double& longest,
                                        dynamics::Motion& to) override;
    std::string cause_of_short_step(std::span<const Vec3> /*x*/) const override
    {
        return "stiffest contact: " + contact_.stiffest_pair();
    }

    /// Of the last evaluation.
    const ContactResponse& response() const { return response_; }
    /// With the skull, by vertices of the body's surface.
    WallContact wall_contact() const;

  private:
    mechanics::TravelTaken hold_apart(const dynamics::Motion& from, double dt, dynamics::Motion& to);
    void gather_surfaces(std::span<const Vec3> of_body, std::span<const Vec3> of_skull, std::vector<Vec3>& both) const;

    std::vector<std::int32_t> particles_; ///< of the surface, ascending: neighbours stand near each other
    std::vector<double> masses_;          ///< of the particles of the surface
    std::vector<std::int32_t> vertex_at_; ///< of each vertex of the body's surface its number here
    std::shared_ptr<boundary::Skull> skull_;
    SurfaceContact contact_;
    bool fixed_step_;
    ContactResponse response_;
    std::optional<double> energy_;   ///< of all ranks, once completed [mu_w mm³]
    std::vector<Vec3> displacement_; ///< of the vertices of the surface, then of the skull, in the step [mm]
    std::vector<Vec3> positions_;    ///< of both, where there is a skull [mm]
    std::vector<Vec3> forces_;       ///< on both [mu_w mm²]
};

} // namespace corticle::contact
