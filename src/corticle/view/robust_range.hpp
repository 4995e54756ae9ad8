// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace corticle::view
{

/// From where to where a colour scale or an axis reaches.
struct Range
{
    double low = 0.0;
    double high = 1.0;
};

/// Least and largest of the finite values; 0 to 1 without any.
Range full_range(std::span<const double> values);

/// Where 2 % of the finite values lie below and 2 % above, but not farther from the quartiles than 1.5 times their
/// distance, widened to round numbers: neither one deep cleft nor the walls of the fissure between the hemispheres
/// decide for the rest. Values that hardly differ are given a range in whose middle they lie, so that they get one
/// colour and not the colours of round-off.
Range robust_range(std::span<const double> values);

/// Round numbers from low to high, about `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

/// 1, 2 or 5 times a power of ten, near `length` / `count`.
double round_step(double length, int count);

} // namespace corticle::view
