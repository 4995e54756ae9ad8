// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/solver.hpp"

#include "corticle/material/growth.hpp"
#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/wide_tissue.hpp"
#include "corticle/mechanics/tlsph/pair_sums.hpp"
#include "corticle/mechanics/tlsph/response.hpp"

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

/// The particle some rows of a table further on, to be asked for now.
CORTICLE_INLINE std::int32_t ahead_of(std::span<const std::int32_t> table, std::size_t row)
{
    constexpr std::size_t rows_ahead = 32;
    return table[std::min(row + rows_ahead, table.size() - 1)];
}

CORTICLE_INLINE void fill_deformation_terms(const Block& block, const Vec3* x, std::vector<PairTerms>& terms)
{
    const auto table = block.table();
    terms.resize(table.size());
    for (std::size_t m = 0; m < table.size(); ++m)
    {
        const std::int32_t j = table[m];
        const std::int32_t soon = ahead_of(table, m);
        read_soon(&block.particles.X[soon]);
        read_soon(&x[soon]);
        terms[m] = deformation_terms(block.particles.X[j] - block.X_origin, x[j] - block.x_origin);
    }
}

CORTICLE_INLINE DeformationSums<double> sum_deformation(const Block& block, const Vec3* x, std::int64_t i,
                                                        const std::vector<PairTerms>& terms)
{
    PairTerms sum;
    sum_terms(block.particles.pairs, i, terms.data(), sum);
    return deformation_sums(sum, block.particles.X[i] - block.X_origin, x[i] - block.x_origin,
                            block.particles.weighted_sum[i]);
}

CORTICLE_INLINE WideVec3 gather(const WideGroup& group, const Vec3* values)
{
    return group.gather_vectors([&](std::int64_t i) -> const Vec3& { return values[i]; });
}

/// The same for eight particles.
CORTICLE_INLINE DeformationSums<WideLanes> sum_deformation(const Block& block, const Vec3* x, const WideGroup& group,
                                                           const std::vector<PairTerms>& terms)
{
    PairTerms sums[wide_lanes];
    for (std::int64_t lane = 0; lane < group.count; ++lane)
    {
        sum_terms(block.particles.pairs, group.first + lane, terms.data(), sums[lane]);
    }
    const WideGroup among{0, group.count};
    const BasicPairTerms<WideLanes> sum{
        among.gather_matrices([&](std::int64_t i) -> const Mat3& { return sums[i].matrix; }),
        among.gather_vectors([&](std::int64_t i) -> const Vec3& { return sums[i].vector; })};
    return deformation_sums(sum, gather(group, block.particles.X.data()) - broadcast(block.X_origin),
                            gather(group, x) - broadcast(block.x_origin),
                            gather(group, block.particles.weighted_sum.data()));
}

/// What a block of particles adds up, lane by lane.
struct LaneSums
{
    WideLanes elastic_energy{};
    WideLanes zero_mode_energy{};
    WideLanes growth_power{};
    WideLanes stiffest_rate{};
    WideLanes barrier_count{};
};

/// Stress, energies and force records of eight particles. Writes to `own_force` the part of their forces that their own
/// states make.
template <bool plain>
CORTICLE_INLINE void respond(const Block& block, const PassInput& in, const WideGroup& group,
                             const std::vector<PairTerms>& terms, ForceRecord* records, Vec3* own_force, LaneSums& sum,
                             InternalResponse& total)
{
    const Particles& particles = block.particles;
    const DeformationSums<WideLanes> sums = sum_deformation(block, in.x, group, terms);
    const WideMat3 L = group.gather_matrices([&](std::int64_t i) -> const Mat3& { return particles.correction[i]; });
    const WideMat3 F = sums.moment * L;
    const WideMat3 cofactor_F = cofactor(F);
    WideLanes J = dot(F.column[0], cofactor_F.column[0]);
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

    const WideTissue tissue = plain ? plain_tissue(in.tissue, in.t, group) : any_tissue(in.tissue, in.t, group, F);
    const auto& point = tissue.point;
    const WideLanes one = broadcast<WideLanes>(1.0);
    const WideLanes g = point.growth;
    const WideLanes g_r = plain ? one : point.radial_growth;
    const WideVec3 n = tissue.normal;
    const WideMat3 inverse_G = inverse_growth_tensor(g, n, g_r);
    const WideMat3 F_e = F * inverse_G;
    const double barrier_J = in.tissue.options.barrier_J;
    const BasicNeoHookean<WideLanes> law{point.shear_modulus, point.bulk_modulus, barrier_J};
    const BasicElasticResponse<WideLanes> elastic = law.respond(F_e);
    const WideLanes volume = group.gather(particles.volume.data());
    const WideLanes J_g = g * g * g_r;
    // Growth stiffens the tangent pulled back to the reference by det G / (smallest growth)²: g_t² where g_r = 1.
    const WideIntegers flat = g_r <= g;
    const WideLanes ratio = plain ? g : (flat ? g / g_r : one);
    const WideLanes zeta = particles.options.zeta * point.shear_modulus * ratio * ratio * g_r;

    const WideLanes density = elastic.deviatoric_energy + elastic.volumetric_energy;
    const WideLanes zero_mode = 0.5 * zeta * (sums.squared_lengths - contract(sums.moment, F));
    sum.elastic_energy += group.counted(volume * J_g * density);
    sum.zero_mode_energy += group.counted(zero_mode);
    // dPsi/dg at fixed F and n, times dg/dt; the zero-energy term follows zeta.
    const WideLanes radial_work = dot(elastic.stress * n, F_e * n);
    const WideLanes tangential_work = contract(elastic.stress, F_e) - radial_work;
    const WideLanes zeta_slope = plain ? 2.0 / g : (flat ? 2.0 / g : WideLanes{});
    WideLanes power =
        point.growth_rate * (volume * g_r * (2.0 * g * density - g * tangential_work) + zeta_slope * zero_mode);
    if constexpr (!plain)
    {
        power += point.radial_growth_rate *
                 (volume * g * g * (density - radial_work) + (flat ? -one : one) / g_r * zero_mode);
        power += point.shear_rate / point.shear_modulus * (volume * J_g * elastic.deviatoric_energy + zero_mode);
        power += point.bulk_rate / point.bulk_modulus * volume * J_g * elastic.volumetric_energy;
    }
    sum.growth_power += group.counted(power);
    sum.stiffest_rate = larger<WideLanes>(
        sum.stiffest_rate, ratio * square_root(g_r * (point.bulk_modulus + 4.0 / 3.0 * point.shear_modulus)) *
                               largest_compression(cofactor_F, J));
    sum.barrier_count += group.counted(J < barrier_J * J_g ? one : WideLanes{});

    const WideMat3 P = J_g * (elastic.stress * inverse_G);
    const WideMat3 M = volume * (P * L) - zeta * F;
    WideVec3 x = gather(group, in.x);
    x.lane = zeta;
    for (int c = 0; c < 3; ++c)
    {
        group.scatter_vectors(M.column[c], [&](std::int64_t i) -> Vec3& { return records[i].M.column[c]; });
    }
    group.scatter_vectors(x, [&](std::int64_t i) -> Vec3& { return records[i].x; });
    group.scatter_vectors(M * gather(group, particles.weighted_sum.data()) + zeta * sums.weighted_sum,
                          [&](std::int64_t i) -> Vec3& { return own_force[i]; });
}

template <bool plain>
CORTICLE_INLINE void deform(const Block& block, const PassInput& in, std::vector<PairTerms>& terms,
                            ForceRecord* records, Vec3* forces, InternalResponse& total)
{
    fill_deformation_terms(block, in.x, terms);
    LaneSums sum;
    for (std::int64_t i = block.begin; i < block.end; i += wide_lanes)
    {
        const WideGroup group{i, std::min(wide_lanes, block.end - i)};
        respond<plain>(block, in, group, terms, records, forces, sum, total);
    }
    total.elastic_energy += sum_of_lanes(sum.elastic_energy);
    total.zero_mode_energy += sum_of_lanes(sum.zero_mode_energy);
    total.growth_power += sum_of_lanes(sum.growth_power);
    total.stiffest_rate = std::max(total.stiffest_rate, largest_of_lanes(sum.stiffest_rate));
    total.barrier_count += std::llround(sum_of_lanes(sum.barrier_count));
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

} // namespace corticle
