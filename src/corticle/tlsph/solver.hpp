// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/tissue/tissue.hpp"
#include "corticle/tlsph/pair_law.hpp"
#include "corticle/tlsph/particles.hpp"

namespace corticle
{

/// What one evaluation of the internal forces tells about the whole body.
struct InternalResponse
{
    double elastic_energy = 0.0;   ///< sum_i V_i Psi(F_i) [mu_w mm³]
    double zero_mode_energy = 0.0; ///< [mu_w mm³]
    double growth_power = 0.0;     ///< dE/dt at fixed positions: work of growth per unit of growth time [mu_w mm³]
    double stiffest_rate = 0.0;    ///< largest wave speed at density 1 over smallest principal stretch, growth included
    double smallest_J = 0.0;       ///< smallest det F
    std::int64_t smallest_J_at = -1; ///< its particle
    std::int64_t barrier_count = 0;  ///< particles whose barrier acts
    std::int64_t invalid_at = -1; ///< first particle with det F <= 0 or a non-finite value; -1 when the state is sound
};

/// Total-Lagrangian SPH: internal forces of the particles for given positions and growth time.
/// Forces are the exact negative gradient of elastic_energy + zero_mode_energy.
class TlsphSolver
{
  public:
    /// Keeps references to both: they must outlive the solver.
    TlsphSolver(const Particles& particles, const Tissue& tissue);

    /// @param x  current positions [mm]   @param t  growth time [-]   @param forces  out [mu_w mm²]; not set when the
    /// state is invalid
    InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces);

    /// F at every particle for given positions.
    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const;

    const Particles& particles() const { return particles_; }
    const Tissue& tissue() const { return tissue_; }

  private:
    const Particles& particles_;
    const Tissue& tissue_;
    std::vector<ForceRecord> records_;
};

} // namespace corticle
