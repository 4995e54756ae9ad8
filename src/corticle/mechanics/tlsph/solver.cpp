// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/tlsph/deformation_pass.hpp"
#include "corticle/mechanics/tlsph/remodelled_pass.hpp"
#include "corticle/mechanics/tlsph/response.hpp"
#include "corticle/mesh/sizes.hpp"

#include <limits>

namespace corticle::tlsph
{

namespace
{

/// What the second pass reads.
struct Records
{
    const ForceRecord* all;
    const ProductTerms* products; ///< as PassOutput has them
};

CORTICLE_INLINE void fill_force_terms(const Block& block, const Records& records, BlockTerms& terms)
{
    const auto table = block.table();
    const Particles& particles = block.particles;
    const bool has_products = block.farthest() != EnrichedGradients::Reach::none;
    terms.linear.resize(table.size());
    terms.products.resize(has_products ? table.size() : 0);
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const std::int32_t soon = ahead_of(table, m);
        read_soon(&particles.X[soon]);
        read_soon(&records.all[soon].M);
        read_soon(&records.all[soon].M.column[2]);
        const Vec3 X = particles.X[j] - block.X_origin;
        const ForceRecord& record = records.all[j];
        terms.linear[m] = force_terms(record.M, record.x.lane, X, record.x - block.x_origin);
        if (has_products && particles.enriched.reach[j] == EnrichedGradients::Reach::itself)
        {
            enrich_force_terms(records.products[particles.enriched.place(j)], record.M, X, terms.linear[m],
                               terms.products[m]);
        }
    }
}

CORTICLE_EVERY_ISA void force_block(const Block& block, const Records& records, BlockTerms& terms, Vec3* forces)
{
    fill_force_terms(block, records, terms);
    const Particles& particles = block.particles;
    for (std::int64_t i = block.begin; i < block.end; ++i)
    {
        const Vec3 X = particles.X[i] - block.X_origin;
        const Vec3 x = records.all[i].x - block.x_origin;
        if (const std::int64_t end = particles.pairs.enriched_end[i]; end > particles.pairs.begin[i])
        {
            EnrichedTerms sum;
            sum_terms(particles.pairs, i, end, terms, sum);
            forces[i] += neighbors_force(sum, X, x);
        }
        else
        {
            PairTerms sum;
            sum_terms(particles.pairs, i, terms, sum);
            forces[i] += neighbors_force(sum, X, x);
        }
    }
}

CORTICLE_EVERY_ISA void gradient_block(const Block& block, const Vec3* x, BlockTerms& terms, Mat3* F)
{
    fill_deformation_terms(block, x, terms);
    for (std::int64_t i = block.begin; i < block.end; i += wide_lanes)
    {
        const WideGroup group{i, std::min(wide_lanes, block.end - i)};
        WideMat3 local;
        if (block.particles.enriched.group[i / wide_lanes] < 0)
        {
            const LinearFit fit = linear_fit(block, x, group, terms);
            local = fit.gradient(fit.coefficients());
        }
        else
        {
            const QuadraticFit fit = quadratic_fit(block, x, group, terms);
            local = fit.gradient(fit.coefficients());
        }
        for (int c = 0; c < 3; ++c)
        {
            group.scatter_vectors(local.column[c], [&](std::int64_t k) -> Vec3& { return F[k].column[c]; });
        }
    }
}

} // namespace

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue)
    : TlsphSolver(particles, tissue,
                  tissue.remodelling == nullptr ? deformation_pass(material::tissue_law(tissue.options))
                                                : remodelled_deformation_pass(tissue.options))
{
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                         std::unique_ptr<const DeformationPass> deformation)
    : particles_(particles), tissue_(tissue), deformation_(std::move(deformation)), records_(particles.X.size()),
      products_(particles.enriched.fits.size() * wide_lanes)
{
}

TlsphSolver::~TlsphSolver() = default;

mechanics::InternalResponse TlsphSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    require_size("positions", x.size(), particles_.X.size());
    require_size("forces", forces.size(), particles_.X.size());
    const PassInput in{tissue_, t, x.data()};
    const PassOutput out{records_.data(), products_.data(), forces.data()};
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
                force_block(block, {records_.data(), products_.data()}, terms_.local(), forces.data());
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
    PerThread<BlockTerms> terms;
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
