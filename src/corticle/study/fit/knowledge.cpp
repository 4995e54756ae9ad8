// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/fit_result.hpp"

#include <cmath>
#include <limits>

namespace corticle::fit
{

namespace
{

constexpr std::size_t band_draws = 1000;
constexpr double share_within = 0.9; // of the draws, of every interval
constexpr int prior_points = 2000;

/// @param level  of the values within the interval
Interval interval_of(const std::vector<double>& values, double level = share_within)
{
    double mean = 0.0;
    for (const double value : values)
    {
        mean += value / static_cast<double>(values.size());
    }
    double squares = 0.0;
    for (const double value : values)
    {
        squares += (value - mean) * (value - mean);
    }
    return {quantile(values, 0.5), quantile(values, 0.5 - 0.5 * level), quantile(values, 0.5 + 0.5 * level),
            std::sqrt(squares / static_cast<double>(values.size()))};
}

/// Standard deviation of a coordinate under the prior.
double prior_sd(const ParameterSpace& space, std::size_t k)
{
    Point u = space.start();
    double weight = 0.0;
    double mean = 0.0;
    double square = 0.0;
    for (int i = 0; i < prior_points; ++i)
    {
        u[k] = (i + 0.5) / prior_points;
        const double one = std::exp(space.log_prior(u));
        weight += one;
        mean += one * u[k];
        square += one * u[k] * u[k];
    }
    mean /= weight;
    return std::sqrt(std::max(square / weight - mean * mean, std::numeric_limits<double>::min()));
}

void add_bands(Knowledge& knowledge, std::uint64_t seed)
{
    const std::vector<Point>& points = knowledge.draws.points;
    const std::size_t stride = std::max<std::size_t>(1, points.size() / band_draws);
    const std::size_t count = knowledge.emulator.processes().size();
    std::vector<std::vector<double>> certain(count);
    std::vector<std::vector<double>> expected(count);
    Random random(seed + 17);
    for (std::size_t i = 0; i < points.size(); i += stride)
    {
        const Emulator::Predictions one = knowledge.emulator.predict(points[i]);
        for (std::size_t q = 0; q < count; ++q)
        {
            const auto row = static_cast<Eigen::Index>(q);
            certain[q].push_back(one.mean(row));
            expected[q].push_back(one.mean(row) + std::sqrt(one.variance(row)) * random.normal());
        }
    }
    for (std::size_t q = 0; q < count; ++q)
    {
        knowledge.certain.push_back(interval_of(certain[q]));
        knowledge.expected.push_back(interval_of(expected[q]));
    }
}

} // namespace

Knowledge learn(const FitFile& fit, Emulator emulator, std::span<const Point> starts)
{
    const LogDensity density = [&](std::span<const double> u)
    { return emulator.log_likelihood(u) + fit.space.log_prior(u); };
    const Point mode = find_mode(density, starts);
    Draws draws = fit.posterior.is_laplace ? laplace(density, mode, fit.posterior.samples, fit.study.seed)
                                           : walk(density, mode, fit.posterior.samples, fit.study.seed);
    Knowledge knowledge{std::move(emulator), mode, std::move(draws), {}, {}, {}, {}, {}, {}, {}};
    const double together = level_of_each(knowledge.draws.points, share_within);
    knowledge.of_emulator = knowledge.emulator.variance_shares(mode);
    for (std::size_t k = 0; k < fit.space.size(); ++k)
    {
        std::vector<double> values;
        std::vector<double> coordinates;
        for (const Point& u : knowledge.draws.points)
        {
            const FreeParameter& parameter = fit.space.parameters[k];
            coordinates.push_back(u[k]);
            values.push_back(parameter.is_log ? parameter.low * std::pow(parameter.high / parameter.low, u[k])
                                              : parameter.low + u[k] * (parameter.high - parameter.low));
        }
        knowledge.parameters.push_back(interval_of(values));
        knowledge.together.push_back(interval_of(values, together));
        knowledge.narrowed.push_back(interval_of(coordinates).sd / prior_sd(fit.space, k));
    }
    knowledge.correlations = correlations(knowledge.draws.points);
    add_bands(knowledge, fit.study.seed);
    return knowledge;
}

double misfit(const FitFile& fit, const Evaluation& evaluation)
{
    if (!evaluation.failure.empty())
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return chi_square(evaluation.predicted, fit.targets) - 2.0 * fit.space.log_prior(evaluation.u);
}

std::optional<std::size_t> best_evaluation(const FitFile& fit, std::span<const Evaluation> evaluations)
{
    std::optional<std::size_t> best;
    bool is_best_dear = false;
    for (std::size_t i = 0; i < evaluations.size(); ++i)
    {
        const bool is_dear = evaluations[i].stage == "dear";
        const bool is_better =
            !best || (is_dear && !is_best_dear) ||
            (is_dear == is_best_dear && misfit(fit, evaluations[i]) < misfit(fit, evaluations[*best]));
        if (evaluations[i].failure.empty() && is_better)
        {
            best = i;
            is_best_dear = is_dear;
        }
    }
    return best;
}

} // namespace corticle::fit
