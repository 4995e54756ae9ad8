// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/tlsph/solver.hpp"

#include "corticle/tissue/growth.hpp"
#include "corticle/tissue/neo_hookean.hpp"

#include <limits>

namespace corticle
{

namespace
{

/// A block of particles: its place in the pairs, and the origin of its primed positions.
struct Block
{
    const Particles& particles;
    std::int64_t begin; ///< first particle
    std::int64_t end;
    Vec3 X_origin;
    Vec3 x_origin;

    CORTICLE_INLINE NeighborRange neighbors(std::int64_t i) const
    {
        const PairBlocks& pairs = particles.pairs;
        const std::int64_t first = pairs.begin[i];
        return {pairs.place.data() + first, pairs.weight.data() + first, pairs.begin[i + 1] - first};
    }
    std::span<const std::int32_t> table() const { return particles.pairs.table_of(begin / particles.pairs.block_size); }
};

Block block_of(const Particles& particles, std::span<const Vec3> x, std::int64_t begin, std::int64_t end)
{
    const std::int64_t middle = begin + (end - begin) / 2;
    return {particles, begin, end, particles.X[middle], x[middle]};
}

struct PassInput
{
    const Tissue& tissue;
    double t;
    const Vec3* x;
};

CORTICLE_INLINE void fill_deformation_terms(const Block& block, const Vec3* x, std::vector<PairTerms>& terms)
{
    const auto table = block.table();
    terms.resize(table.size());
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        terms[m] = deformation_terms(block.particles.X[j] - block.X_origin, x[j] - block.x_origin);
    }
}

CORTICLE_INLINE DeformationSums sum_deformation(const Block& block, const Vec3* x, std::int64_t i,
                                                const std::vector<PairTerms>& terms)
{
    PairTerms sum;
    sum_terms(block.neighbors(i), terms.data(), sum);
    return deformation_sums(sum, block.particles.X[i] - block.X_origin, x[i] - block.x_origin,
                            block.particles.weighted_sum[i]);
}

/// An upper bound of 1 / (smallest singular value of F): sqrt of the bound m + sqrt(2) s of the largest eigenvalue
/// of F^-T F^-1 by its mean m and deviation s (Wolkowicz & Styan 1980); exact for isotropic and for uniaxial
/// compression.
CORTICLE_INLINE double largest_compression(const Mat3& cofactor_F, double J)
{
    const Mat3 B = transpose(cofactor_F) * cofactor_F;
    const double mean = trace(B) / 3.0;
    const double variance = std::max(0.0, contract(B, B) / 3.0 - mean * mean);
    return std::sqrt(mean + std::sqrt(2.0 * variance)) / J;
}

/// Stress, energies and the force record of one particle. Writes to `own_force` the part of its force that its own
/// state makes. `plain`: growth is that of Tissue::grows_plainly, which the compiler then gets to see.
template <bool plain>
CORTICLE_INLINE void respond(const Particles& particles, const PassInput& in, std::int64_t signed_i,
                             const DeformationSums& sums, ForceRecord& record, Vec3& own_force, InternalResponse& sum)
{
    const auto i = static_cast<std::size_t>(signed_i);
    const Tissue& tissue = in.tissue;
    const Mat3 F = sums.moment * particles.correction[i];
    const Mat3 cofactor_F = cofactor(F);
    const double J = dot(F.column[0], cofactor_F.column[0]);
    if (J < sum.smallest_J)
    {
        sum.smallest_J = J;
        sum.smallest_J_at = signed_i;
    }
    if (!(J > 0.0) || !(J < std::numeric_limits<double>::max()))
    {
        sum.invalid_at = sum.invalid_at < 0 ? signed_i : sum.invalid_at;
        return;
    }

    const MaterialPoint point =
        plain ? material_point(tissue.options, tissue.theta[i], tissue.regional_rate[i], in.t) : tissue.point(i, in.t);
    const double g = point.growth;
    const double g_r = plain ? 1.0 : point.radial_growth;
    const Vec3 n = plain ? tissue.normal[i] : tissue.growth_normal(i, F);
    const Mat3 inverse_G = inverse_growth_tensor(g, n, g_r);
    const Mat3 F_e = F * inverse_G;
    const NeoHookean law{point.shear_modulus, point.bulk_modulus, tissue.options.barrier_J};
    const ElasticResponse elastic = law.respond(F_e);
    const double volume = particles.volume[i];
    // Growth stiffens the tangent pulled back to the reference by det G / (smallest growth)²: g_t² where g_r = 1.
    const bool flat = plain || g_r <= g;
    const double ratio = flat ? g / g_r : 1.0;
    const double zeta = particles.options.zeta * point.shear_modulus * ratio * ratio * g_r;

    const double density = elastic.deviatoric_energy + elastic.volumetric_energy;
    const double zero_mode = 0.5 * zeta * (sums.squared_lengths - contract(sums.moment, F));
    sum.elastic_energy += volume * g * g * g_r * density;
    sum.zero_mode_energy += zero_mode;
    // dPsi/dg at fixed F and n, times dg/dt; the zero-energy term follows zeta.
    const double radial_work = dot(elastic.stress * n, F_e * n);
    const double tangential_work = contract(elastic.stress, F_e) - radial_work;
    sum.growth_power += point.growth_rate *
                        (volume * g_r * (2.0 * g * density - g * tangential_work) + (flat ? 2.0 / g : 0.0) * zero_mode);
    if (!plain)
    {
        sum.growth_power += point.radial_growth_rate *
                            (volume * g * g * (density - radial_work) + (flat ? -1.0 : 1.0) / g_r * zero_mode);
        sum.growth_power +=
            point.shear_rate / point.shear_modulus * (volume * g * g * g_r * elastic.deviatoric_energy + zero_mode);
        sum.growth_power += point.bulk_rate / point.bulk_modulus * volume * g * g * g_r * elastic.volumetric_energy;
    }
    sum.stiffest_rate =
        std::max(sum.stiffest_rate, ratio * std::sqrt(g_r * (point.bulk_modulus + 4.0 / 3.0 * point.shear_modulus)) *
                                        largest_compression(cofactor_F, J));
    sum.barrier_count += J < tissue.options.barrier_J * g * g * g_r ? 1 : 0;

    const Mat3 P = (g * g * g_r) * (elastic.stress * inverse_G);
    record.M = volume * (P * particles.correction[i]) - zeta * F;
    record.x = in.x[i];
    record.x.lane = zeta;
    own_force = record.M * particles.weighted_sum[i] + zeta * sums.weighted_sum;
}

template <bool plain>
CORTICLE_INLINE void deform(const Block& block, const PassInput& in, std::vector<PairTerms>& terms,
                            ForceRecord* records, Vec3* forces, InternalResponse& sum)
{
    fill_deformation_terms(block, in.x, terms);
    for (std::int64_t i = block.begin; i < block.end; ++i)
    {
        const DeformationSums sums = sum_deformation(block, in.x, i, terms);
        respond<plain>(block.particles, in, i, sums, records[i], forces[i], sum);
    }
}

CORTICLE_EVERY_ISA void deformation_block(const Block& block, const PassInput& in, std::vector<PairTerms>& terms,
                                          ForceRecord* records, Vec3* forces, InternalResponse& sum)
{
    deform<true>(block, in, terms, records, forces, sum);
}

CORTICLE_EVERY_ISA void general_deformation_block(const Block& block, const PassInput& in,
                                                  std::vector<PairTerms>& terms, ForceRecord* records, Vec3* forces,
                                                  InternalResponse& sum)
{
    deform<false>(block, in, terms, records, forces, sum);
}

CORTICLE_EVERY_ISA void force_block(const Block& block, std::vector<PairTerms>& terms, const ForceRecord* records,
                                    Vec3* forces)
{
    const auto table = block.table();
    const std::vector<Vec3>& X = block.particles.X;
    terms.resize(table.size());
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const ForceRecord& record = records[j];
        terms[m] = force_terms(record.M, record.x.lane, X[j] - block.X_origin, record.x - block.x_origin);
    }
    for (std::int64_t i = block.begin; i < block.end; ++i)
    {
        PairTerms sum;
        sum_terms(block.neighbors(i), terms.data(), sum);
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

void join(InternalResponse& total, const InternalResponse& part)
{
    total.elastic_energy += part.elastic_energy;
    total.zero_mode_energy += part.zero_mode_energy;
    total.growth_power += part.growth_power;
    total.stiffest_rate = std::max(total.stiffest_rate, part.stiffest_rate);
    total.barrier_count += part.barrier_count;
    if (part.smallest_J < total.smallest_J)
    {
        total.smallest_J = part.smallest_J;
        total.smallest_J_at = part.smallest_J_at;
    }
    total.invalid_at = total.invalid_at < 0 ? part.invalid_at : total.invalid_at;
}

} // namespace

TlsphSolver::TlsphSolver(const Particles& particles, const Tissue& tissue)
    : particles_(particles), tissue_(tissue), records_(particles.X.size())
{
}

InternalResponse TlsphSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    const PassInput in{tissue_, t, x.data()};
    const auto deformation = tissue_.grows_plainly() ? deformation_block : general_deformation_block;
    InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    const std::int64_t count = std::ssize(x);
    terms_.fit();
    InternalResponse total = parallel_reduce(
        count, initial,
        [&](std::int64_t begin, std::int64_t end)
        {
            InternalResponse part = initial;
            const Block block = block_of(particles_, x, begin, end);
            deformation(block, in, terms_.local(), records_.data(), forces.data(), part);
            return part;
        },
        join, particles_.pairs.block_size);
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
        // A non-finite position spreads into its neighbours' J, which the test above sees; energies see the rest.
        if (!std::isfinite(total.elastic_energy + total.zero_mode_energy))
        {
            total.invalid_at = total.smallest_J_at;
        }
    }
    return total;
}

std::vector<Mat3> TlsphSolver::deformation_gradients(std::span<const Vec3> x) const
{
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

} // namespace corticle
