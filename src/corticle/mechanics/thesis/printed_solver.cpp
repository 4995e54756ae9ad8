// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/thesis/printed_solver.hpp"
#include "corticle/material/tissue_law.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/thesis/printed_law.hpp"
#include "corticle/mechanics/tlsph/particle_law.hpp"
#include "corticle/mechanics/tlsph/response.hpp"
#include "corticle/mesh/sizes.hpp"

#include <limits>

namespace corticle::thesis
{

namespace
{

struct PassInput
{
    const tlsph::Particles& particles;
    const material::Tissue& tissue;
    const ThesisOptions& options;
    const NeighborGroups& groups;
    Vec3 origin;
    const SumRecord* positions;
    const Vec3* x;
    double t;
};

struct PassOutput
{
    SumRecord* stresses;
    Mat3* stress; ///< null where nobody asks for it
    Vec3* forces;
};

/// C_i, with which the sum of w_ij x_ij X_ij^T becomes F_i.
CORTICLE_INLINE Mat3 gradient_matrix(const tlsph::Particles& particles, KernelGradient gradient, std::int64_t i)
{
    return gradient == KernelGradient::corrected ? particles.correction[i]
                                                 : (1.0 / particles.volume[i]) * Mat3::identity();
}

/// F_i from sum_j w_ij x_ij X_ij^T.
CORTICLE_INLINE Mat3 deformation_gradient(const tlsph::Particles& particles, KernelGradient gradient, std::int64_t i,
                                          const Mat3& moment, const Mat3& C)
{
    return gradient == KernelGradient::displacement ? Mat3::identity() + (moment - inverse(particles.correction[i])) * C
                                                    : moment * C;
}

/// sum_j w_ij x_ij X_ij^T from the sums of positions.
CORTICLE_INLINE Mat3 moment_of(const NeighborSum& sum, const Vec3& x_i, const Vec3& X_i, const Vec3& weighted_sum)
{
    return sum.matrix - outer(sum.vector, X_i) - outer(x_i, weighted_sum);
}

/// Stress, energies and the record of particle i; its own part of its force.
CORTICLE_INLINE void respond(const PassInput& in, std::int64_t i, const NeighborSum& sum, const PassOutput& out,
                             mechanics::InternalResponse& total)
{
    const tlsph::Particles& particles = in.particles;
    const Vec3 x_i = in.x[i] - in.origin;
    const Vec3 X_i = particles.X[i] - in.origin;
    const Vec3 b_i = particles.weighted_sum[i];
    const double volume = particles.volume[i];
    const Mat3 moment = moment_of(sum, x_i, X_i, b_i);
    const Mat3 C = gradient_matrix(particles, in.options.gradient, i);
    const Mat3 F = deformation_gradient(particles, in.options.gradient, i, moment, C);
    const Mat3 cofactor_F = cofactor(F);
    const double J = dot(F.column[0], cofactor_F.column[0]);
    if (J < total.smallest_J)
    {
        total.smallest_J = J;
        total.smallest_J_at = i;
    }
    if (!(J > 0.0) || !(J < std::numeric_limits<double>::max()))
    {
        total.invalid_at = total.invalid_at < 0 ? i : total.invalid_at;
        return;
    }

    const material::MaterialPoint point = in.tissue.point(i, in.t);
    const auto law = material::tissue_law(in.tissue.options);
    const Vec3 n = in.tissue.growth_normal(i, F);
    const material::Response grown = in.options.growth == GrowthEntry::multiplied ? respond_multiplied(law, point, n, F)
                                                                                  : material::respond(law, point, n, F);
    const double grown_volume = volume * grown.growth_volume;
    const double zeta = tlsph::control_stiffness(particles.options.zeta, point);
    const Mat3 best_F = moment * particles.correction[i];
    const Vec3 summed_x = sum.vector - b_i.lane * x_i;
    const double squares =
        sum.scalar - 2.0 * dot(x_i, sum.vector) + b_i.lane * squared_norm(x_i) - contract(moment, best_F);

    total.elastic_energy += grown_volume * grown.energy;
    total.zero_mode_energy += 0.5 * zeta * squares;
    total.growth_power += grown_volume * grown.power + 0.5 * zeta * squares * tlsph::control_stiffening(point);
    total.stiffest_rate = std::max(total.stiffest_rate, grown.wave_speed * tlsph::largest_compression(cofactor_F, J));
    total.barrier_count += grown.J_e < law.barrier_J ? 1 : 0;

    Mat3 M = (-zeta) * best_F;
    Vec3 own = M * b_i + zeta * summed_x;
    const Mat3 scaled_C = volume * C;
    if (in.options.force == ForceForm::conservative)
    {
        const Mat3 spread = grown.P * scaled_C;
        M += spread;
        own += spread * b_i;
    }
    else
    {
        own -= grown.P * (scaled_C * b_i);
        if (out.stress != nullptr)
        {
            out.stress[i] = grown.P;
        }
        else
        {
            M += grown.P;
        }
    }
    out.stresses[i].set(M * X_i + zeta * x_i, M, zeta);
    out.forces[i] = own;
}

CORTICLE_EVERY_ISA void deformation_block(const PassInput& in, std::int64_t begin, std::int64_t end,
                                          const PassOutput& out, mechanics::InternalResponse& total)
{
    constexpr std::int64_t size = NeighborGroups::size;
    for (std::int64_t first = begin; first < end; first += size)
    {
        GroupSum sum;
        sum_records(in.groups, first / size, in.positions, sum);
        for (std::int64_t i = first; i < std::min(first + size, end); ++i)
        {
            respond(in, i, sum.at(i - first), out, total);
        }
    }
}

CORTICLE_EVERY_ISA void force_block(const PassInput& in, std::int64_t begin, std::int64_t end,
                                    const SumRecord* stresses, Vec3* forces)
{
    constexpr std::int64_t size = NeighborGroups::size;
    for (std::int64_t first = begin; first < end; first += size)
    {
        GroupSum group;
        sum_records(in.groups, first / size, stresses, group);
        for (std::int64_t i = first; i < std::min(first + size, end); ++i)
        {
            const NeighborSum sum = group.at(i - first);
            forces[i] += sum.vector - sum.matrix * (in.particles.X[i] - in.origin) - sum.scalar * (in.x[i] - in.origin);
        }
    }
}

/// Sums of one group over records.
CORTICLE_EVERY_ISA void sum_block(const NeighborGroups& groups, std::int64_t group, const SumRecord* records,
                                  GroupSum& sum)
{
    sum_records(groups, group, records, sum);
}

std::vector<double> wave_speeds(const material::Tissue& tissue)
{
    std::vector<double> speeds(tissue.state.theta.size());
    for (std::size_t i = 0; i < speeds.size(); ++i)
    {
        speeds[i] = std::sqrt(material::longitudinal_modulus(tissue.point(i, 0.0)));
    }
    return speeds;
}

Vec3 mean_position(std::span<const Vec3> X)
{
    Vec3 sum;
    for (const Vec3& position : X)
    {
        sum += position;
    }
    return sum / static_cast<double>(X.size());
}

} // namespace

PrintedSolver::PrintedSolver(const tlsph::Particles& particles, const material::Tissue& tissue,
                             const ThesisOptions& options)
    : particles_(particles), tissue_(tissue), options_(options), origin_(mean_position(particles.X)),
      groups_(group_neighbors(particles.pairs)), positions_(particles.X.size()), stresses_(particles.X.size())
{
    if (options.force == ForceForm::difference && options.gradient == KernelGradient::corrected)
    {
        stress_.resize(particles.X.size());
    }
    if (options.has_viscosity())
    {
        viscosity_.emplace(options, wave_speeds(tissue), tlsph::support_mm(particles.options, particles.spacing),
                           origin_);
    }
}

void PrintedSolver::fill_positions(std::span<const Vec3> x, std::vector<SumRecord>& records) const
{
    parallel_for(std::ssize(x),
                 [&](std::int64_t j)
                 {
                     const Vec3 x_j = x[j] - origin_;
                     records[j].set(x_j, outer(x_j, particles_.X[j] - origin_), squared_norm(x_j));
                 });
}

mechanics::InternalResponse PrintedSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    require_size("positions", x.size(), particles_.X.size());
    require_size("forces", forces.size(), particles_.X.size());
    fill_positions(x, positions_);
    const PassInput in{particles_, tissue_, options_, groups_, origin_, positions_.data(), x.data(), t};
    const PassOutput out{stresses_.data(), stress_.empty() ? nullptr : stress_.data(), forces.data()};
    mechanics::InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    mechanics::InternalResponse total = parallel_reduce(
        std::ssize(x), initial,
        [&](std::int64_t begin, std::int64_t end)
        {
            mechanics::InternalResponse part = initial;
            deformation_block(in, begin, end, out, part);
            return part;
        },
        mechanics::join);
    if (total.invalid_at >= 0)
    {
        return total;
    }
    parallel_blocks(std::ssize(x), [&](std::int64_t begin, std::int64_t end)
                    { force_block(in, begin, end, stresses_.data(), forces.data()); });
    if (!stress_.empty())
    {
        add_corrected_differences(forces);
    }
    // A non-finite position spreads into its neighbours' J, which the test above sees; energies and the rate, which the
    // step follows, see the rest.
    if (!std::isfinite(total.elastic_energy + total.zero_mode_energy + total.stiffest_rate))
    {
        total.invalid_at = total.smallest_J_at;
    }
    return total;
}

/// sum_j w_ij P_j C_i X_ij, whose C_i is that of the particle and not of the neighbour: by the columns of C_i.
void PrintedSolver::add_corrected_differences(std::span<Vec3> forces)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        parallel_for(std::ssize(forces),
                     [&](std::int64_t j)
                     {
                         const double X_j = particles_.X[j][axis] - origin_[axis];
                         stresses_[j].set(stress_[j].column[axis], X_j * stress_[j], 0.0);
                     });
        parallel_blocks(std::ssize(forces),
                        [&](std::int64_t begin, std::int64_t end)
                        {
                            for (std::int64_t first = begin; first < end; first += NeighborGroups::size)
                            {
                                GroupSum group;
                                sum_block(groups_, first / NeighborGroups::size, stresses_.data(), group);
                                for (std::int64_t i = first; i < std::min(first + NeighborGroups::size, end); ++i)
                                {
                                    const NeighborSum sum = group.at(i - first);
                                    const Mat3 C = particles_.volume[i] * particles_.correction[i];
                                    forces[i] += sum.matrix * C.column[axis] -
                                                 (C * (particles_.X[i] - origin_))[axis] * sum.vector;
                                }
                            }
                        });
    }
}

double PrintedSolver::add_viscous_forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> forces)
{
    return viscosity_ ? viscosity_->add_forces(groups_, particles_.X, x, v, forces) : 0.0;
}

std::vector<Mat3> PrintedSolver::deformation_gradients(std::span<const Vec3> x) const
{
    require_size("positions", x.size(), particles_.X.size());
    std::vector<SumRecord> records(x.size());
    fill_positions(x, records);
    std::vector<Mat3> F(x.size());
    parallel_blocks(std::ssize(x),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        for (std::int64_t first = begin; first < end; first += NeighborGroups::size)
                        {
                            GroupSum group;
                            sum_block(groups_, first / NeighborGroups::size, records.data(), group);
                            for (std::int64_t i = first; i < std::min(first + NeighborGroups::size, end); ++i)
                            {
                                const Mat3 moment = moment_of(group.at(i - first), x[i] - origin_,
                                                              particles_.X[i] - origin_, particles_.weighted_sum[i]);
                                F[i] = deformation_gradient(particles_, options_.gradient, i, moment,
                                                            gradient_matrix(particles_, options_.gradient, i));
                            }
                        }
                    });
    return F;
}

std::string PrintedSolver::diagnosis(std::int64_t node, std::span<const Vec3> x) const
{
    return tlsph::describe_particle(particles_, tissue_, node, x[node], deformation_gradients(x)[node]);
}

} // namespace corticle::thesis
