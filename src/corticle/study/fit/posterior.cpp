// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/posterior.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/study/surrogate/minimize.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace corticle::fit
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{

constexpr int chains = 4;
constexpr int learning_interval = 100;
constexpr double best_scale = 2.38;        // over the root of the dimension (Gelman, Roberts & Gilks 1996)
constexpr std::uint64_t chain_seed = 7919; // between the seeds of chains
constexpr double least_variance = 1e-8;
constexpr double difference_step = 0.02;
constexpr int most_redraws = 1000;
constexpr int direct_evaluations = 400; // times the dimension
constexpr int local_evaluations = 200;

bool is_in_cube(const VectorXd& u)
{
    return (u.array() >= 0.0).all() && (u.array() <= 1.0).all();
}

double value_at(const LogDensity& density, const VectorXd& u)
{
    return density({u.data(), static_cast<std::size_t>(u.size())});
}

Point point_of(const VectorXd& u)
{
    return {u.data(), u.data() + u.size()};
}

VectorXd vector_of(const Point& u)
{
    return Eigen::Map<const VectorXd>(u.data(), static_cast<Index>(u.size()));
}

MatrixXd covariance_of(const std::vector<VectorXd>& points)
{
    const Index dimensions = points.front().size();
    VectorXd mean = VectorXd::Zero(dimensions);
    for (const VectorXd& point : points)
    {
        mean += point / static_cast<double>(points.size());
    }
    MatrixXd covariance = MatrixXd::Zero(dimensions, dimensions);
    for (const VectorXd& point : points)
    {
        covariance += (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
    }
    covariance.diagonal().array() += least_variance;
    return covariance;
}

VectorXd normals(Index count, Random& random)
{
    VectorXd result(count);
    for (double& one : result)
    {
        one = random.normal();
    }
    return result;
}

struct Chain
{
    std::vector<VectorXd> draws;
    int accepted = 0;
};

/// @param spread  times its transpose, the covariance that is expected
Chain one_chain(const LogDensity& density, const Point& mode, const MatrixXd& spread, int kept, Random random)
{
    const auto dimensions = static_cast<Index>(mode.size());
    const double scale = best_scale / std::sqrt(static_cast<double>(dimensions));
    MatrixXd step = scale * spread;
    VectorXd at = (vector_of(mode) + spread * normals(dimensions, random)).cwiseMax(0.0).cwiseMin(1.0);
    double value = value_at(density, at);
    const int learning = std::max(2 * learning_interval, kept / 3);
    std::vector<VectorXd> seen;
    Chain chain;
    for (int i = 0; i < learning + kept; ++i)
    {
        const VectorXd proposed = at + step * normals(dimensions, random);
        const double chance = random.uniform();
        const double proposed_value =
            is_in_cube(proposed) ? value_at(density, proposed) : -std::numeric_limits<double>::infinity();
        if (chance < std::exp(proposed_value - value))
        {
            at = proposed;
            value = proposed_value;
            chain.accepted += i >= learning ? 1 : 0;
        }
        (i < learning ? seen : chain.draws).push_back(at);
        if (i < learning && (i + 1) % learning_interval == 0)
        {
            const std::vector<VectorXd> later(seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2), seen.end());
            step = scale * MatrixXd(Eigen::LLT<MatrixXd>(covariance_of(later)).matrixL());
        }
    }
    return chain;
}

/// Of one coordinate of parts of chains of equal length.
double split_r_hat(const std::vector<std::vector<double>>& parts)
{
    const auto length = static_cast<double>(parts.front().size());
    const auto count = static_cast<double>(parts.size());
    std::vector<double> means;
    double within = 0.0;
    double all = 0.0;
    for (const std::vector<double>& part : parts)
    {
        double mean = 0.0;
        for (const double value : part)
        {
            mean += value / length;
        }
        double squares = 0.0;
        for (const double value : part)
        {
            squares += (value - mean) * (value - mean);
        }
        within += squares / (length - 1.0) / count;
        means.push_back(mean);
        all += mean / count;
    }
    double between = 0.0;
    for (const double mean : means)
    {
        between += (mean - all) * (mean - all) / (count - 1.0);
    }
    return within > 0.0 ? std::sqrt((length - 1.0) / length + between / within) : 1.0;
}

std::vector<double> mixing_of(const std::vector<Chain>& runs)
{
    std::vector<double> mixing;
    for (Index k = 0; k < runs.front().draws.front().size(); ++k)
    {
        std::vector<std::vector<double>> parts;
        for (const Chain& run : runs)
        {
            const std::size_t half = run.draws.size() / 2;
            for (const std::size_t begin : {std::size_t{0}, half})
            {
                std::vector<double>& part = parts.emplace_back();
                for (std::size_t i = begin; i < begin + half; ++i)
                {
                    part.push_back(run.draws[i](k));
                }
            }
        }
        mixing.push_back(split_r_hat(parts));
    }
    return mixing;
}

/// The negative of the second derivatives.
MatrixXd curvature(const LogDensity& density, const VectorXd& mode)
{
    const Index dimensions = mode.size();
    // Moved off the bounds, so that the differences stay within.
    const VectorXd centre = mode.cwiseMax(difference_step).cwiseMin(1.0 - difference_step);
    const auto at = [&](Index i, double a, Index j, double b)
    {
        VectorXd u = centre;
        u(i) += a * difference_step;
        u(j) += b * difference_step;
        return value_at(density, u);
    };
    MatrixXd result(dimensions, dimensions);
    for (Index i = 0; i < dimensions; ++i)
    {
        for (Index j = 0; j < i; ++j)
        {
            result(i, j) = -(at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) / 4.0;
            result(j, i) = result(i, j);
        }
        result(i, i) = -(at(i, 1, i, 0) - 2.0 * value_at(density, centre) + at(i, -1, i, 0));
    }
    return result / (difference_step * difference_step);
}

/// A root of the covariance of the normal density with that curvature: principal axes by their deviations.
MatrixXd normal_spread(const LogDensity& density, const VectorXd& mode)
{
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(curvature(density, mode));
    const VectorXd deviations = eigen.eigenvalues().cwiseMax(1.0 / even_variance).cwiseInverse().cwiseSqrt();
    return eigen.eigenvectors() * deviations.asDiagonal();
}

} // namespace

Point find_mode(const LogDensity& density, std::span<const Point> starts)
{
    const auto dimensions = static_cast<int>(starts.front().size());
    const Objective objective = [&](std::span<const double> u) { return -density(u); };
    const Minimum whole =
        minimize(objective, starts.front(), {"GN_DIRECT_L", direct_evaluations * dimensions, 1e-4, 0.2, 1});
    std::vector<Point> all{whole.at};
    all.insert(all.end(), starts.begin(), starts.end());
    Minimum best{whole.at, whole.value};
    for (const Point& start : all)
    {
        const Minimum found = minimize(objective, start, {"LN_SBPLX", local_evaluations * dimensions, 1e-5, 0.05, 1});
        best = found.value < best.value ? found : best;
    }
    return best.at;
}

Draws walk(const LogDensity& density, const Point& mode, int count, std::uint64_t seed)
{
    const MatrixXd spread = normal_spread(density, vector_of(mode));
    std::vector<Chain> runs(chains);
    parallel_blocks(
        chains,
        [&](std::int64_t chain, std::int64_t)
        {
            const Random random(seed + static_cast<std::uint64_t>(chain) * chain_seed);
            runs[static_cast<std::size_t>(chain)] = one_chain(density, mode, spread, count / chains, random);
        },
        1);
    Draws draws;
    int accepted = 0;
    for (const Chain& run : runs)
    {
        accepted += run.accepted;
        for (const VectorXd& u : run.draws)
        {
            draws.points.push_back(point_of(u));
        }
    }
    draws.acceptance = static_cast<double>(accepted) / static_cast<double>(draws.points.size());
    draws.mixing = mixing_of(runs);
    return draws;
}

Draws laplace(const LogDensity& density, const Point& mode, int count, std::uint64_t seed)
{
    const VectorXd centre = vector_of(mode);
    const MatrixXd spread = normal_spread(density, centre);
    Random random(seed);
    Draws draws;
    draws.is_laplace = true;
    draws.mixing.assign(mode.size(), 1.0);
    for (int i = 0; i < count; ++i)
    {
        VectorXd u = centre;
        for (int tries = 0; tries < most_redraws; ++tries)
        {
            u = centre + spread * normals(centre.size(), random);
            if (is_in_cube(u))
            {
                break;
            }
        }
        draws.points.push_back(point_of(u.cwiseMax(0.0).cwiseMin(1.0)));
    }
    return draws;
}

double quantile(std::vector<double> values, double level)
{
    std::ranges::sort(values);
    const double place = level * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double level_of_each(std::span<const Point> points, double level)
{
    // How far out each draw is: the largest of its coordinates' ranks from the nearer end, as a share from 0 to 1.
    std::vector<double> outermost(points.size());
    std::vector<std::size_t> order(points.size());
    for (std::size_t k = 0; k < points.front().size(); ++k)
    {
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i][k]; });
        for (std::size_t rank = 0; rank < order.size(); ++rank)
        {
            const double place = (static_cast<double>(rank) + 0.5) / static_cast<double>(order.size());
            double& far = outermost[order[rank]];
            far = std::max(far, std::abs(2.0 * place - 1.0));
        }
    }
    return quantile(std::move(outermost), level);
}

MatrixXd correlations(std::span<const Point> points)
{
    std::vector<VectorXd> vectors;
    for (const Point& point : points)
    {
        vectors.push_back(vector_of(point));
    }
    const MatrixXd covariance = covariance_of(vectors);
    const VectorXd inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
    return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

} // namespace corticle::fit
