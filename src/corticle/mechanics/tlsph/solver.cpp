// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/tlsph/deformation_pass.hpp"
#include "corticle/mechanics/tlsph/records.hpp"
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

/// Calls of_block(begin, end) for the particles of some blocks, concurrently.
template <class OfBlock>
void TlsphSolver::for_blocks(std::span<const std::int64_t> blocks, OfBlock&& of_block) const
{
    const std::int64_t size = particles_.pairs.block_size;
    parallel_blocks(
        std::ssize(blocks),
        [&](std::int64_t k, std::int64_t)
        {
            const std::int64_t begin = blocks[static_cast<std::size_t>(k)] * size;
            of_block(begin, std::min(begin + size, share_.end()));
        },
        1);
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue)
    : TlsphSolver(particles, tissue, Share(std::ssize(particles.X)))
{
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue, const Share& share)
    : TlsphSolver(particles, tissue,
                  tissue.remodelling == nullptr ? deformation_pass(material::tissue_law(tissue.options))
                                                : remodelled_deformation_pass(tissue.options),
                  share)
{
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                         std::unique_ptr<const DeformationPass> deformation)
    : TlsphSolver(particles, tissue, std::move(deformation), Share(std::ssize(particles.X)))
{
}

TlsphSolver::TlsphSolver(const Particles& particles, const material::Tissue& tissue,
                         std::unique_ptr<const DeformationPass> deformation, const Share& share)
    : particles_(particles), tissue_(tissue), share_(share), halo_(halo_of(particles.pairs, share)),
      positions_(halo_, share.ranks(), [](std::int64_t) { return position_numbers; }),
      force_records_(halo_, share.ranks(), [&](std::int64_t i) { return record_numbers(particles.enriched, i); }),
      deformation_(std::move(deformation)), records_(particles.X.size()),
      products_(static_cast<std::size_t>(particles.enriched.groups()) * wide_lanes)
{
    const std::int64_t size = particles.pairs.block_size;
    for (std::int64_t block = share.begin() / size; block < block_count(share.end(), size); ++block)
    {
        const auto table = particles.pairs.table_of(block);
        const bool is_inner = table.empty() || (share.has(table.front()) && share.has(table.back()));
        (is_inner ? inner_blocks_ : outer_blocks_).push_back(block);
    }
}

TlsphSolver::~TlsphSolver() = default;

void TlsphSolver::exchange_positions(std::span<Vec3> x)
{
    exchanged_ = x;
    positions_.start([x](std::int32_t i, double* at) { return put(x[i], at); });
}

void TlsphSolver::finish_positions()
{
    if (!exchanged_.empty())
    {
        positions_.finish([x = exchanged_](std::int32_t i, const double* at) { return take(at, x[i]); });
        exchanged_ = {};
    }
}

void TlsphSolver::start_records()
{
    force_records_.start(
        [this](std::int32_t i, double* at)
        {
            const bool is_enriched = particles_.enriched.reach[i] == EnrichedGradients::Reach::itself;
            return put_record(records_[i], is_enriched ? &products_[particles_.enriched.place(i)] : nullptr, at);
        });
}

/// Of ghosts, whose positions are here already.
void TlsphSolver::finish_records(std::span<const Vec3> x)
{
    force_records_.finish(
        [this, x](std::int32_t i, const double* at)
        {
            const bool is_enriched = particles_.enriched.reach[i] == EnrichedGradients::Reach::itself;
            return take_record(at, x[i], records_[i], is_enriched ? &products_[particles_.enriched.place(i)] : nullptr);
        });
}

mechanics::InternalResponse TlsphSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    require_size("positions", x.size(), particles_.X.size());
    require_size("forces", forces.size(), particles_.X.size());
    const PassInput in{tissue_, t, x.data()};
    const PassOutput out{records_.data(), products_.data(), forces.data()};
    mechanics::InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    terms_.fit();
    BlockValues<mechanics::InternalResponse> responses(share_, initial, particles_.pairs.block_size);
    const auto deform = [&](std::int64_t begin, std::int64_t end)
    {
        mechanics::InternalResponse part = initial;
        deformation_->run(block_of(particles_, x, begin, end), in, terms_.local(), out, part);
        return part;
    };
    responses.find(inner_blocks_, deform); // while positions are under way
    finish_positions();
    responses.find(outer_blocks_, deform);
    start_records();
    mechanics::InternalResponse total = responses.joined(mechanics::join);
    const auto add_forces = [&](std::int64_t begin, std::int64_t end)
    {
        force_block(block_of(particles_, x, begin, end), {records_.data(), products_.data()}, terms_.local(),
                    forces.data());
    };
    if (total.invalid_at < 0)
    {
        for_blocks(inner_blocks_, add_forces);
    }
    finish_records(x);
    if (total.invalid_at < 0)
    {
        for_blocks(outer_blocks_, add_forces);
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
    const auto find_gradients = [&](std::int64_t begin, std::int64_t end)
    { gradient_block(block_of(particles_, x, begin, end), x.data(), terms.local(), F.data()); };
    for_blocks(inner_blocks_, find_gradients);
    for_blocks(outer_blocks_, find_gradients);
    share_.gather_at_root(std::span(F));
    return F;
}

std::string TlsphSolver::diagnosis(std::int64_t node, std::span<const Vec3> x) const
{
    return describe_particle(particles_, tissue_, node, x[node], deformation_gradients(x)[node]);
}

} // namespace corticle::tlsph
