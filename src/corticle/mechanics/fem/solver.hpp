// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/fem/passes.hpp"

#include <memory>

namespace corticle::fem
{

class ForcePass;

/// Linear tetrahedra with the volumetric energy on nodal averages of the volume ratio (Tallinen et al. 2016, in the
/// form that is a gradient; see docs/theory/fem.md):
/// E = sum_e V J_g W_dev(F_e) + sum_n V_n K_n U(Ja_n), U(Ja) = (Ja - 1)²/2 and the barrier, with V_n the grown volume
/// of the node, Ja_n its volume now over that, K_n the mean of its tets. Forces are the exact negative gradient of E.
/// Flat and inverted elements survive: see extrapolation.hpp.
class FemSolver final : public mechanics::Discretization
{
  public:
    /// Keeps references to the first and to what the tissue refers to: they must outlive the solver. The law is
    /// material::tissue_law. @param tissue  of the tets, at their centroids
    FemSolver(const TetElements& elements, const material::Tissue& tissue);
    /// With another law: see force_pass.hpp.
    FemSolver(const TetElements& elements, const material::Tissue& tissue, std::unique_ptr<const ForcePass> forces);
    ~FemSolver() override;

    mechanics::InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) override;

    /// Mean of F over the adjacent tets, weighted with their volume.
    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const override;

    std::int64_t node_of(std::int64_t tet) const override { return elements_.tets[static_cast<std::size_t>(tet)][0]; }
    Vec3 place_of(std::int64_t tet, std::span<const Vec3> x) const override
    {
        return centroids(x, std::span(elements_.tets).subspan(static_cast<std::size_t>(tet), 1)).front();
    }

    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override;

  private:
    /// Volumes and pressures of the nodes. @return energy, barrier_count and invalid_at
    mechanics::InternalResponse evaluate_volumes(std::span<const Vec3> x, double t);

    const TetElements& elements_;
    material::Tissue tissue_;
    std::unique_ptr<const ForcePass> force_pass_;
    std::vector<NodalVolume> volume_parts_;  ///< per entry of chunk_node
    std::vector<Vec3> force_parts_;          ///< the same; the lane sums the stiffness
    std::vector<NodalPressure> node_values_; ///< per node
};

} // namespace corticle::fem
