// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/thesis/viscosity.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <optional>

namespace corticle::thesis
{

/// The thesis's total-Lagrangian equations as printed, each of which ThesisOptions can put right; with all put right
/// the forces are those of TlsphSolver. As printed they are: F_i = (1/V_i) sum_j w_ij x_ij X_ij^T (eq. 10), stress
/// P(F_i G_i) (eqs. 22 and 23), f_i = sum_j w_ij (P_j - P_i - Pi_ij) X_ij (eq. 9 times the mass of the particle,
/// viscosity of eq. 7). Made for hundreds of neighbours each.
class PrintedSolver final : public mechanics::Discretization
{
  public:
    /// Keeps references to the first and to what the tissue refers to: they must outlive the solver.
    PrintedSolver(const tlsph::Particles& particles, const material::Tissue& tissue, const ThesisOptions& options);

    /// As printed the forces are the gradient of no energy; elastic_energy is then that of the stress.
    mechanics::InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) override;

    double add_viscous_forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> forces) override;

    /// F as the formulation has it: as printed without growth (eq. 10), and not I in the body at rest.
    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const override;

    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override;

  private:
    void fill_positions(std::span<const Vec3> x, std::vector<SumRecord>& records) const;
    void add_corrected_differences(std::span<Vec3> forces);

    const tlsph::Particles& particles_;
    material::Tissue tissue_;
    ThesisOptions options_;
    Vec3 origin_; ///< amid the body; records hold positions from here [mm]
    NeighborGroups groups_;
    std::vector<SumRecord> positions_; ///< x_j, x_j X_j^T, |x_j|²
    std::vector<SumRecord> stresses_;  ///< M_j X_j + zeta_j x_j, M_j, zeta_j
    std::vector<Mat3> stress_;         ///< P_j, where corrected gradients need it once more
    std::optional<ArtificialViscosity> viscosity_;
};

} // namespace corticle::thesis
