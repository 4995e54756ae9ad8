// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/particles.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/tlsph/kernel.hpp"
#include "corticle/mesh/partition.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace corticle::tlsph
{

namespace
{

void require_well_conditioned(const Particles& particles, std::span<const double> condition)
{
    std::size_t worst = 0;
    std::int64_t bad = 0;
    for (std::size_t i = 0; i < condition.size(); ++i)
    {
        worst = condition[i] > condition[worst] ? i : worst;
        bad += condition[i] > largest_condition ? 1 : 0;
    }
    if (bad > 0)
    {
        const Vec3& X = particles.X[worst];
        throw InputError(fmt::format("cloud: ill-conditioned shape matrix at {} of {} particles, worst particle {} at "
                                     "({:.4g}, {:.4g}, {:.4g}) mm "
                                     "with {} neighbours: got condition {:.3g}, expected at most {}; use a finer "
                                     "spacing or a larger solver.support",
                                     bad, particles.X.size(), worst, X.x, X.y, X.z, particles.pairs.size(worst),
                                     condition[worst], largest_condition));
    }
}

} // namespace

double condition_number(const Mat3& symmetric)
{
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            matrix(i, j) = symmetric(i, j);
        }
    }
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues(); // ascending
    return values[0] > 0.0 ? values[2] / values[0] : std::numeric_limits<double>::infinity();
}

std::vector<double> block_costs(const Particles& particles)
{
    constexpr double of_quadratic_fit = 70.0;
    const std::int64_t count = std::ssize(particles.X);
    std::vector<double> costs;
    for (std::int64_t begin = 0; begin < count; begin += partition_block)
    {
        const std::int64_t end = std::min(begin + partition_block, count);
        const auto quadratic = std::count(particles.enriched.reach.begin() + begin,
                                          particles.enriched.reach.begin() + end, EnrichedGradients::Reach::itself);
        costs.push_back(static_cast<double>(particles.pairs.begin[end] - particles.pairs.begin[begin]) +
                        of_quadratic_fit * static_cast<double>(quadratic));
    }
    return costs;
}

Particles make_particles(const Cloud& cloud, const Neighbors& neighbors, const TlsphOptions& options)
{
    Particles particles{cloud.positions, cloud.volumes, make_pair_blocks(neighbors), {}, {}, {},
                        options,         cloud.spacing};
    const std::size_t count = particles.X.size();
    std::vector<double> supports;
    for (std::size_t i = 0; i < count; ++i)
    {
        supports.push_back(support_mm(options, cloud.spacing_at(i)));
    }
    particles.correction.resize(count);
    particles.weighted_sum.resize(count);
    std::vector<double> condition(count);
    parallel_for(std::ssize(particles.X),
                 [&](std::int64_t i)
                 {
                     Mat3 shape;
                     Vec3 sum;
                     double weights = 0.0;
                     for (std::int64_t k = neighbors.begin[i]; k < neighbors.begin[i + 1]; ++k)
                     {
                         const std::int32_t j = neighbors.index[k];
                         const Vec3 X_ij = particles.X[j] - particles.X[i];
                         const double volumes = particles.volume[i] * particles.volume[j];
                         const auto rounded =
                             static_cast<float>(volumes * pair_weight(norm(X_ij), 0.5 * (supports[i] + supports[j])));
                         particles.pairs.weight[k] = rounded;
                         const auto w = static_cast<double>(rounded);
                         shape += w * outer(X_ij, X_ij);
                         sum += w * X_ij;
                         weights += w;
                     }
                     condition[i] = condition_number(shape);
                     particles.correction[i] = inverse(shape);
                     sum.lane = weights;
                     particles.weighted_sum[i] = sum;
                 });
    require_well_conditioned(particles, condition);
    particles.enriched = enrich_gradients(cloud, particles.correction, supports, particles.pairs);
    return particles;
}

} // namespace corticle::tlsph
