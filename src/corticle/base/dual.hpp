// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace corticle
{

/// A number that carries its derivative along (forward differentiation), with what the laws ask of a number.
struct Dual
{
    double value = 0.0;
    double slope = 0.0;

    constexpr Dual() = default;
    constexpr Dual(double v, double s = 0.0) : value(v), slope(s) {} // a constant is a number too

    friend constexpr Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
    friend constexpr Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
    friend constexpr Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
    friend constexpr Dual operator*(const Dual& a, const Dual& b)
    {
        return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    }
    friend constexpr Dual operator/(const Dual& a, const Dual& b)
    {
        return {a.value / b.value, (a.slope - a.value / b.value * b.slope) / b.value};
    }
    friend constexpr Dual& operator+=(Dual& a, const Dual& b) { return a = a + b; }
    friend constexpr Dual& operator*=(Dual& a, const Dual& b) { return a = a * b; }
    friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
    friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }

    friend Dual sqrt(const Dual& a) { return {std::sqrt(a.value), 0.5 / std::sqrt(a.value) * a.slope}; }
    friend Dual cbrt(const Dual& a)
    {
        const double root = std::cbrt(a.value);
        return {root, a.slope / (3.0 * root * root)};
    }
    friend Dual log(const Dual& a) { return {std::log(a.value), a.slope / a.value}; }
};

} // namespace corticle
