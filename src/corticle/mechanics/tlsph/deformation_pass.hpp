// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/wide_remodelling.hpp"
#include "corticle/mechanics/discretization.hpp"
#include "corticle/mechanics/tlsph/block.hpp"
#include "corticle/mechanics/tlsph/particle_law.hpp"

#include <cmath>
#include <limits>
#include <memory>

// The first of the two passes: it reads positions and tissue, applies the law of the material and writes what the
// second pass, the sum of forces, reads.

namespace corticle::tlsph
{

/// What a pass over a block reads.
struct PassInput
{
    const material::Tissue& tissue;
    double t;
    const Vec3* x;
};

/// What it writes: of every particle the record that its neighbours read, and its own part of its force.
struct PassOutput
{
    ForceRecord* records;
    ProductTerms* products; ///< of the particles of EnrichedGradients::fits, but for T_azz, which is in the records
    Vec3* own_force;
};

/// The pass with some law.
class DeformationPass
{
  public:
    DeformationPass() = default;
    DeformationPass(const DeformationPass&) = delete;
    DeformationPass& operator=(const DeformationPass&) = delete;
    virtual ~DeformationPass() = default;

    /// @param terms  scratch memory   @param total  what the block finds is added to it
    virtual void run(const Block& block, const PassInput& in, BlockTerms& terms, const PassOutput& out,
                     mechanics::InternalResponse& total) const = 0;
};

/// What a block of particles adds up, lane by lane.
struct LaneSums
{
    WideLanes elastic_energy{};
    WideLanes zero_mode_energy{};
    WideLanes growth_power{};
    WideLanes released{};
    WideLanes stiffest_rate{};
    WideLanes barrier_count{};
};

/// Notes the smallest J, and the first particle whose J no body can have: not positive, or not finite.
CORTICLE_INLINE void note_volumes(const WideGroup& group, WideLanes J, mechanics::InternalResponse& total)
{
    for_lanes(J < total.smallest_J,
              [&](int lane)
              {
                  if (at_lane(J, lane) < total.smallest_J)
                  {
                      total.smallest_J = at_lane(J, lane);
                      total.smallest_J_at = group.at(lane);
                  }
              });
    const WideIntegers sound = (J > 0.0) & (J < std::numeric_limits<double>::max());
    for_lanes(~sound, [&](int lane) { total.invalid_at = total.invalid_at < 0 ? group.at(lane) : total.invalid_at; });
}

/// Writes the pulls by products of eight particles. @param Z  of Fit   @param M  that of their records
CORTICLE_INLINE void write_products(const QuadraticFit::Vectors& Z, const WideGroup& at, ProductTerms* products,
                                    WideMat3& M)
{
    // Z q(X) = T X X: what is off the diagonal counts twice.
    WideVec3 column[4] = {Z[3], 0.5 * Z[4], 0.5 * Z[5], Z[6]};
    const WideVec3 yz = 0.5 * Z[7];
    column[0].lane = yz.x;
    column[1].lane = yz.y;
    column[2].lane = yz.z;
    for (int p = 0; p < 4; ++p)
    {
        at.scatter_vectors(column[p], [&](std::int64_t i) -> Vec3& { return products[i].column[p]; });
    }
    set_lanes(Z[8], M);
}

/// Stress, energies and force records of eight particles.
template <bool plain, class Law, int functions>
CORTICLE_INLINE void respond_in_lanes(const Law& law, const Block& block, const PassInput& in, const WideGroup& group,
                                      const Fit<WideLanes, functions>& fit, const PassOutput& out, LaneSums& sum,
                                      mechanics::InternalResponse& total)
{
    const Particles& particles = block.particles;
    const auto coefficients = fit.coefficients();
    const ParticleDeformation<WideLanes> deformation = particle_deformation(fit.gradient(coefficients));
    note_volumes(group, deformation.J, total);
    material::WideTissue tissue = plain ? material::plain_tissue(in.tissue, in.t, group)
                                  : material::HasHistory<Law>
                                      ? material::unstressed_tissue(in.tissue, in.t, group, deformation.F)
                                      : material::any_tissue(in.tissue, in.t, group, deformation.F);
    const auto& local = material::law_at(law, in.tissue, group, deformation.F, tissue);
    const ParticleResponse<WideLanes> particle =
        particle_response<plain>(local, tissue.point, tissue.normal, group.gather(particles.volume.data()),
                                 particles.options.zeta, deformation, fit.residual(coefficients));
    sum.elastic_energy += group.counted(particle.elastic_energy);
    sum.zero_mode_energy += group.counted(particle.zero_mode_energy);
    sum.growth_power += group.counted(particle.growth_power);
    if constexpr (requires { local.released; })
    {
        // The zero-energy control stiffens as the tissue grows in length.
        const WideLanes control = particle.zero_mode_energy * (inverse_cube_root(1.0 + local.growth_step) - 1.0);
        sum.released += group.counted(group.gather(particles.volume.data()) * local.released + control);
    }
    sum.stiffest_rate = larger<WideLanes>(sum.stiffest_rate, particle.rate);
    sum.barrier_count += group.counted(particle.J_e < law.barrier_J ? broadcast<WideLanes>(1.0) : WideLanes{});
    const auto Z = fit.pulls(particle.stress, particle.zeta);
    WideMat3 M{{Z[0], Z[1], Z[2]}};
    if constexpr (functions == quadratic_functions)
    {
        write_products(Z, {particles.enriched.place(group.first), group.count}, out.products, M);
    }
    WideVec3 x = gather(group, in.x);
    x.lane = particle.zeta;
    for (int c = 0; c < 3; ++c)
    {
        group.scatter_vectors(M.column[c], [&](std::int64_t i) -> Vec3& { return out.records[i].M.column[c]; });
    }
    group.scatter_vectors(x, [&](std::int64_t i) -> Vec3& { return out.records[i].x; });
    group.scatter_vectors(fit.own_force(Z, particle.zeta), [&](std::int64_t i) -> Vec3& { return out.own_force[i]; });
}

/// `plain`: growth is that of Tissue::grows_plainly.
template <bool plain, class Law>
CORTICLE_EVERY_ISA void deform(const Law& law, const Block& block, const PassInput& in, BlockTerms& terms,
                               const PassOutput& out, mechanics::InternalResponse& total)
{
    fill_deformation_terms(block, in.x, terms);
    LaneSums sum;
    for (std::int64_t i = block.begin; i < block.end; i += wide_lanes)
    {
        const WideGroup group{i, std::min(wide_lanes, block.end - i)};
        if (block.particles.enriched.group[i / wide_lanes] >= 0)
        {
            respond_in_lanes<plain>(law, block, in, group, quadratic_fit(block, in.x, group, terms), out, sum, total);
        }
        else
        {
            respond_in_lanes<plain>(law, block, in, group, linear_fit(block, in.x, group, terms), out, sum, total);
        }
    }
    total.elastic_energy += sum_of_lanes(sum.elastic_energy);
    total.zero_mode_energy += sum_of_lanes(sum.zero_mode_energy);
    total.growth_power += sum_of_lanes(sum.growth_power);
    total.released += sum_of_lanes(sum.released);
    total.stiffest_rate = std::max(total.stiffest_rate, largest_of_lanes(sum.stiffest_rate));
    total.barrier_count += std::llround(sum_of_lanes(sum.barrier_count));
}

/// The pass with one law, compiled for it.
template <material::Material<WideLanes> Law>
class LawPass final : public DeformationPass
{
  public:
    explicit LawPass(const Law& law) : law_(law) {}

    void run(const Block& block, const PassInput& in, BlockTerms& terms, const PassOutput& out,
             mechanics::InternalResponse& total) const override
    {
        if constexpr (!material::HasHistory<Law>)
        {
            if (in.tissue.grows_plainly())
            {
                return deform<true>(law_, block, in, terms, out, total);
            }
        }
        deform<false>(law_, block, in, terms, out, total);
    }

  private:
    Law law_;
};

/// All that a material needs to be simulated: hand the result to TlsphSolver.
template <material::Material<WideLanes> Law>
std::unique_ptr<const DeformationPass> deformation_pass(const Law& law)
{
    return std::make_unique<LawPass<Law>>(law);
}

} // namespace corticle::tlsph
