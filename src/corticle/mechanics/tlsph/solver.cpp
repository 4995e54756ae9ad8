// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/tlsph/deformation_pass.hpp"
#include "corticle/mechanics/tlsph/response.hpp"
#include "corticle/mesh/sizes.hpp"

#include <limits>

namespace corticle::tlsph
{

namespace
{

CORTICLE_EVERY_ISA void force_block(const Block& block, std::vector<PairTerms>& terms, const ForceRecord* records,
                                    Vec3* forces)
{
    const auto table = block.table();
    const std::vector<Vec3>& X = block.particles.X;
    terms.resize(table.size());
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const std::int32_t soon = ahead_of(table, m);
        read_soon(&X[soon]);
        read_soon(&records[soon].M);
        read_soon(&records[soon].M.column[2]);
        const ForceRecord& record = records[j];
        terms[m] = force_terms(record.M, record.x.lane, X[j] - block.X_origin, record.x - block.x_origin);
    }
    for (std::int64_t i = block.begin; i < block.end; ++i)
    {
        PairTerms sum;
        sum_terms(block.particles.pairs, i, terms.data(), sum);
        forces[i] += neighbors_force(sum, X[i] - block.X_origin, records[i].x - block.x_origin);
    }
}

CORTICLE_EVERY_ISA void gradient_block(const Block& block, const Vec3* x, std::vector<PairTerms>& terms, Mat3* F)
{
    fill_deformation_terms(block, x, terms);
    for (std::int64_t i = block.begin; i < block.end; ++i)
    {
        F[i] = sum_deformation(block, x, i, terms).moment * block.particles.correction[i];
    }
}

} // namespace

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue)
    : TlsphSolver(particles, tissue, deformation_pass(material::tissue_law(tissue.options)))
{
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                         std::unique_ptr<const DeformationPass> deformation)
    : particles_(particles), tissue_(tissue), deformation_(std::move(deformation)), records_(particles.X.size())
{
}

TlsphSolver::~TlsphSolver() = default;

mechanics::InternalResponse TlsphSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    require_size("positions", x.size(), particles_.X.size());
    require_size("forces", forces.size(), particles_.X.size());
    const PassInput in{tissue_, t, x.data()};
    const PassOutput out{records_.data(), forces.data()};
    mechanics::InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    const std::int64_t count = std::ssize(x);
    terms_.fit();
    mechanics::InternalResponse total = parallel_reduce(
        count, initial,
        [&](std::int64_t begin, std::int64_t end)
        {
            mechanics::InternalResponse part = initial;
            const Block block = block_of(particles_, x, begin, end);
            deformation_->run(block, in, terms_.local(), out, part);
            return part;
        },
        mechanics::join, particles_.pairs.block_size);
    if (total.invalid_at < 0)
    {
        parallel_blocks(
            count,
            [&](std::int64_t begin, std::int64_t end)
            {
                const Block block = block_of(particles_, x, begin, end);
                force_block(block, terms_.local(), records_.data(), forces.data());
            },
            particles_.pairs.block_size);
        // A non-finite position spreads into its neighbours' J, which the test above sees; energies and the
        // rate, which the step follows, see the rest.
        if (!std::isfinite(total.elastic_energy + total.zero_mode_energy + total.stiffest_rate))
        {
            total.invalid_at = total.smallest_J_at;
        }
    }
    return total;
}

std::vector<Mat3> TlsphSolver::deformation_gradients(std::span<const Vec3> x) const
{
    require_size("positions", x.size(), particles_.X.size());
    std::vector<Mat3> F(x.size());
    PerThread<std::vector<PairTerms>> terms;
    terms.fit();
    parallel_blocks(
        std::ssize(x),
        [&](std::int64_t begin, std::int64_t end)
        {
            const Block block = block_of(particles_, x, begin, end);
            gradient_block(block, x.data(), terms.local(), F.data());
        },
        particles_.pairs.block_size);
    return F;
}

std::string TlsphSolver::diagnosis(std::int64_t node, std::span<const Vec3> x) const
{
    return describe_particle(particles_, tissue_, node, x[node], deformation_gradients(x)[node]);
}

} // namespace corticle::tlsph
