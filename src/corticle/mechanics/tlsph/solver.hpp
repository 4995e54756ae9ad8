// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/tlsph/pair_sums.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/halo.hpp"

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
    /// The part of one of several ranks; positions and forces are of all particles.
    TlsphSolver(const Particles& particles, const material::Tissue& tissue, const Share& share);
    /// With another law: see deformation_pass.hpp.
    TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                std::unique_ptr<const DeformationPass> deformation);
    TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                std::unique_ptr<const DeformationPass> deformation, const Share& share);
    ~TlsphSolver() override;

    void exchange_positions(std::span<Vec3> x) override;

    mechanics::InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) override;

    std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const override;

    std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const override;

    /// What other ranks read, and are read of.
    std::span<const HaloPart> halo() const { return halo_; }

  private:
    void finish_positions();
    void start_records();
    void finish_records(std::span<const Vec3> x);
    template <class OfBlock>
    void for_blocks(std::span<const std::int64_t> blocks, OfBlock&& of_block) const;

    const Particles& particles_;
    material::Tissue tissue_;
    Share share_;
    std::vector<std::int64_t> inner_blocks_; ///< own blocks that read own particles alone
    std::vector<std::int64_t>
        outer_blocks_; ///< the others, which read ghosts, and whose particles are ghosts elsewhere
    std::vector<HaloPart> halo_;
    Halo positions_;
    Halo force_records_;
    std::span<Vec3> exchanged_; ///< positions that are under way
    std::unique_ptr<const DeformationPass> deformation_;
    LargeVector<ForceRecord> records_;
    LargeVector<ProductTerms> products_;
    PerThread<BlockTerms> terms_; ///< of the block at hand
};

} // namespace corticle::tlsph
