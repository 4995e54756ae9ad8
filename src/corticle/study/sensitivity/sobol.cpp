// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sensitivity/sobol.hpp"

#include <algorithm>
#include <cmath>

namespace corticle::sensitivity
{

namespace
{

constexpr std::size_t groups = 10; // of the jackknife
constexpr double normal_90 = 1.645;

using Function = std::function<double(std::span<const double>)>;

SobolIndices indices_of(const fit::GaussianProcess& process, std::size_t dimensions, std::size_t samples,
                        std::uint64_t seed)
{
    return sobol_indices([&](std::span<const double> u) { return process.mean(u); }, dimensions, samples, seed);
}

/// Half of the 90 % interval from values that each lack a group of the runs.
std::vector<double> jackknife_errors(const std::vector<std::vector<double>>& by_group)
{
    const auto count = static_cast<double>(by_group.size());
    std::vector<double> errors(by_group.front().size());
    for (std::size_t k = 0; k < errors.size(); ++k)
    {
        double mean = 0.0;
        for (const std::vector<double>& values : by_group)
        {
            mean += values[k] / count;
        }
        double squares = 0.0;
        for (const std::vector<double>& values : by_group)
        {
            squares += (values[k] - mean) * (values[k] - mean);
        }
        errors[k] = normal_90 * std::sqrt(squares * (count - 1.0) / count);
    }
    return errors;
}

} // namespace

SobolIndices sobol_indices(const Function& function, std::size_t dimensions, std::size_t samples, std::uint64_t seed)
{
    const std::vector<fit::Point> pairs = fit::even_points(samples, 2 * dimensions, seed);
    const auto count = static_cast<double>(samples);
    std::vector<fit::Point> a;
    std::vector<fit::Point> b;
    std::vector<double> of_a;
    std::vector<double> of_b;
    double mean = 0.0;
    for (const fit::Point& pair : pairs)
    {
        a.emplace_back(pair.begin(), pair.begin() + static_cast<std::ptrdiff_t>(dimensions));
        b.emplace_back(pair.begin() + static_cast<std::ptrdiff_t>(dimensions), pair.end());
        of_a.push_back(function(a.back()));
        of_b.push_back(function(b.back()));
        mean += (of_a.back() + of_b.back()) / (2.0 * count);
    }
    SobolIndices result;
    for (std::size_t i = 0; i < samples; ++i)
    {
        of_a[i] -= mean; // smaller products, smaller errors
        of_b[i] -= mean;
        result.variance += (of_a[i] * of_a[i] + of_b[i] * of_b[i]) / (2.0 * count);
    }
    for (std::size_t k = 0; k < dimensions; ++k)
    {
        double first = 0.0;
        double total = 0.0;
        for (std::size_t i = 0; i < samples; ++i)
        {
            fit::Point mixed = a[i];
            mixed[k] = b[i][k];
            const double of_mixed = function(mixed) - mean;
            first += of_b[i] * (of_mixed - of_a[i]) / count;
            total += (of_a[i] - of_mixed) * (of_a[i] - of_mixed) / (2.0 * count);
        }
        result.first.push_back(result.variance > 0.0 ? first / result.variance : 0.0);
        result.total.push_back(result.variance > 0.0 ? total / result.variance : 0.0);
    }
    return result;
}

EmulatedIndices emulated_indices(std::span<const fit::Point> points, std::span<const double> values,
                                 std::size_t samples, std::uint64_t seed)
{
    const std::size_t dimensions = points.front().size();
    const fit::GaussianProcess process(points, values);
    EmulatedIndices result;
    result.indices = indices_of(process, dimensions, samples, seed);
    result.predictivity = process.predictivity();
    const double scatter = process.scatter() * process.scatter();
    result.scatter_share = scatter > 0.0 ? scatter / (scatter + result.indices.variance) : 0.0;
    std::vector<std::vector<double>> first;
    std::vector<std::vector<double>> total;
    for (std::size_t group = 0; group < groups; ++group)
    {
        std::vector<fit::Point> kept;
        std::vector<double> of_kept;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            if (i % groups != group)
            {
                kept.push_back(points[i]);
                of_kept.push_back(values[i]);
            }
        }
        const SobolIndices without = indices_of(fit::GaussianProcess(kept, of_kept), dimensions, samples, seed);
        first.push_back(without.first);
        total.push_back(without.total);
    }
    result.first_error = jackknife_errors(first);
    result.total_error = jackknife_errors(total);
    return result;
}

} // namespace corticle::sensitivity
