// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/tridiagonal.hpp"

#include <cmath>
#include <limits>

namespace corticle
{

namespace
{

constexpr int most_sweeps = 60; ///< per eigenvalue; two or three are usual

/// One implicit QL sweep over the block first..last, with Wilkinson's shift; `row` is the first row of the product of
/// the rotations.
void sweep(std::vector<double>& d, std::vector<double>& e, std::vector<double>& row, std::size_t first,
           std::size_t last)
{
    const double half = (d[first + 1] - d[first]) / (2.0 * e[first]);
    double g = d[last] - d[first] + e[first] / (half + std::copysign(std::hypot(half, 1.0), half));
    double sine = 1.0;
    double cosine = 1.0;
    double shift = 0.0;
    for (std::size_t i = last; i-- > first;)
    {
        const double f = sine * e[i];
        const double b = cosine * e[i];
        const double r = std::hypot(f, g);
        e[i + 1] = r;
        if (r == 0.0)
        {
            d[i + 1] -= shift;
            e[last] = 0.0;
            return;
        }
        sine = f / r;
        cosine = g / r;
        g = d[i + 1] - shift;
        const double turned = (d[i] - g) * sine + 2.0 * cosine * b;
        shift = sine * turned;
        d[i + 1] = g + shift;
        g = cosine * turned - b;
        const double above = row[i + 1];
        row[i + 1] = sine * row[i] + cosine * above;
        row[i] = cosine * row[i] - sine * above;
    }
    d[first] -= shift;
    e[first] = g;
    e[last] = 0.0;
}

} // namespace

Quadrature gauss_quadrature(std::vector<double> diagonal, std::vector<double> below)
{
    const std::size_t count = diagonal.size();
    below.resize(count, 0.0);
    std::vector<double> row(count, 0.0);
    if (count > 0)
    {
        row[0] = 1.0;
    }
    for (std::size_t first = 0; first < count; ++first)
    {
        for (int sweeps = 0; sweeps < most_sweeps; ++sweeps)
        {
            std::size_t last = first;
            while (last + 1 < count &&
                   std::abs(below[last]) > std::numeric_limits<double>::epsilon() *
                                               (std::abs(diagonal[last]) + std::abs(diagonal[last + 1])))
            {
                ++last;
            }
            if (last == first)
            {
                break;
            }
            sweep(diagonal, below, row, first, last);
        }
    }
    for (double& component : row)
    {
        component *= component;
    }
    return {std::move(diagonal), std::move(row)};
}

} // namespace corticle
