// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/spherical_harmonics.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <numbers>

namespace corticle::metrics
{

namespace
{

/// Factors of the recurrence P_l^m = a (z P_{l-1}^m - b P_{l-2}^m), by row l and column m.
struct Recurrence
{
    explicit Recurrence(int largest) : width(largest + 1), a(width * width), b(width * width)
    {
        for (int m = 0; m < width; ++m)
        {
            for (int l = m + 1; l < width; ++l)
            {
                const double ll = static_cast<double>(l) * l;
                const double mm = static_cast<double>(m) * m;
                const double before = static_cast<double>(l - 1) * (l - 1);
                a[l * width + m] = std::sqrt((4.0 * ll - 1.0) / (ll - mm));
                b[l * width + m] = std::sqrt((before - mm) / (4.0 * before - 1.0));
            }
        }
    }

    int width;
    std::vector<double> a;
    std::vector<double> b;
};

/// Adds value Y_lm of a direction to the coefficients: cosine parts, then sine parts.
void add_harmonics(const Recurrence& factors, const Vec3& direction, double value, std::vector<double>& sums)
{
    const int width = factors.width;
    double sectoral = value * std::sqrt(0.25 / std::numbers::pi); // Y_mm without its angle
    double real = 1.0;
    double imaginary = 0.0; // (x + iy)^m
    for (int m = 0; m < width; ++m)
    {
        double before = 0.0;
        double now = sectoral;
        for (int l = m; l < width; ++l)
        {
            if (l > m)
            {
                const double next = factors.a[l * width + m] * (direction.z * now - factors.b[l * width + m] * before);
                before = now;
                now = next;
            }
            sums[l * width + m] += now * real;
            sums[(width + l) * width + m] += now * imaginary;
        }
        const double turned = direction.x * real - direction.y * imaginary;
        imaginary = direction.x * imaginary + direction.y * real;
        real = turned;
        sectoral *= std::sqrt((2.0 * m + 3.0) / (2.0 * m + 2.0)) * (m == 0 ? std::numbers::sqrt2 : 1.0);
    }
}

} // namespace

std::vector<double> power_by_degree(std::span<const Vec3> directions, std::span<const double> values,
                                    std::span<const double> areas, int largest_degree)
{
    const Recurrence factors(largest_degree);
    const double total = parallel_sum(std::ssize(areas), [&](std::int64_t i) { return areas[i]; });
    const std::vector<double> none(2 * factors.width * factors.width, 0.0);
    const std::vector<double> coefficients = parallel_reduce(
        std::ssize(directions), none,
        [&](std::int64_t begin, std::int64_t end)
        {
            std::vector<double> sums = none;
            for (std::int64_t i = begin; i < end; ++i)
            {
                add_harmonics(factors, directions[i], values[i] * areas[i] / total, sums);
            }
            return sums;
        },
        [](std::vector<double>& all, const std::vector<double>& part)
        { std::transform(all.begin(), all.end(), part.begin(), all.begin(), std::plus<>{}); });
    std::vector<double> power(factors.width, 0.0);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
    {
        power[k / factors.width % factors.width] += 4.0 * std::numbers::pi * coefficients[k] * coefficients[k];
    }
    return power;
}

int dominant_degree(std::span<const double> power)
{
    int degree = 0;
    double most = 0.0;
    for (std::size_t l = 1; l < power.size(); ++l)
    {
        if (power[l] > most)
        {
            most = power[l];
            degree = static_cast<int>(l);
        }
    }
    return degree;
}

} // namespace corticle::metrics
