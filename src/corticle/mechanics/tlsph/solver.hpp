// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/parallel.hpp"
#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/tlsph/pair_sums.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"

#include <memory>

namespace corticle::tlsph
{

class DeformationPass;

/// Total-Lagrangian SPH: internal forces of the particles for given positions and growth time.
/// Particles are nodes and material points at once.
class TlsphSolver final : public mechanics::Discretization
{
  public:
    /// Keeps references to the first and to what the tissue refers to: they must outlive the solver. The law is
    /// material::tissue_law.
    TlsphSolver(const Particles& particles, const material::Tissue& tissue);
    /// With another law: see deformation_pass.hpp.
    TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                std::unique_ptr<const DeformationPass> deformation);
    ~TlsphSolver() override;

    mechanics::InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) override;

    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const override;

    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override;

  private:
    const Particles& particles_;
    material::Tissue tissue_;
    std::unique_ptr<const DeformationPass> deformation_;
    LargeVector<ForceRecord> records_;
    LargeVector<ProductTerms> products_;
    PerThread<BlockTerms> terms_; ///< of the block at hand
};

} // namespace corticle::tlsph
