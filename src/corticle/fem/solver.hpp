// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/fem/elements.hpp"
#include "corticle/tissue/discretization.hpp"
#include "corticle/tissue/tissue.hpp"

namespace corticle
{

/// Volume of a node, or the part of it that one chunk of tets gives: sums of a quarter of the adjacent tets.
struct alignas(32) NodalVolume
{
    double current = 0.0; ///< [mm³]
    double grown = 0.0;   ///< sum of J_g V / 4 [mm³]
    double bulk = 0.0;    ///< sum of K J_g V / 4 [mu_w mm³]
    double lane = 0.0;    ///< fills the register
};

/// What the volume ratio Ja of a node gives to its tets.
struct alignas(32) NodalPressure
{
    double pressure = 0.0; ///< K U'(Ja) [mu_w]
    double density = 0.0;  ///< U(Ja) [-]
    double work = 0.0;     ///< K U'(Ja) Ja [mu_w]
    double lane = 0.0;     ///< fills the register
};

/// Linear tetrahedra with the volumetric energy on nodal averages of the volume ratio (Tallinen et al. 2016, in the
/// form that is a gradient; see docs/theory/fem.md):
/// E = sum_e V J_g W_dev(F_e) + sum_n V_n K_n U(Ja_n), U(Ja) = (Ja - 1)²/2 and the barrier, with V_n the grown volume
/// of the node, Ja_n its volume now over that, K_n the mean of its tets. Forces are the exact negative gradient of E.
/// Flat and inverted elements survive: see extrapolation.hpp.
class FemSolver final : public Discretization
{
  public:
    /// Keeps references to both: they must outlive the solver. @param tissue  of the tets, at their centroids
    FemSolver(const TetElements& elements, const Tissue& tissue);

    InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) override;

    /// Mean of F over the adjacent tets, weighted with their volume.
    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const override;

    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override;

  private:
    /// Volumes and pressures of the nodes. @return energy, barrier_count and invalid_at
    InternalResponse evaluate_volumes(std::span<const Vec3> x, double t);

    const TetElements& elements_;
    const Tissue& tissue_;
    std::vector<NodalVolume> volume_parts_;  ///< per entry of chunk_node
    std::vector<Vec3> force_parts_;          ///< the same; the lane sums the stiffness
    std::vector<NodalPressure> node_values_; ///< per node
};

} // namespace corticle
