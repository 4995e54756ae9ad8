// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace corticle::fit
{

/// How a function of the unit cube is minimised.
struct Minimization
{
    std::string method = "LN_BOBYQA"; ///< NLopt's name, see find_method
    int evaluations = 200;            ///< at most
    double tolerance = 1e-4;          ///< ends when the coordinates change by less
    double step = 0.2;                ///< first step, of local methods
    std::uint64_t seed = 1;           ///< of methods that draw numbers
};

struct Minimum
{
    std::vector<double> at;
    double value = 0.0;
};

using Objective = std::function<double(std::span<const double>)>;

/// NLopt's own name of a method without derivatives: "BOBYQA", "ln_bobyqa" and "LN_BOBYQA" are LN_BOBYQA, "DIRECT" is
/// GN_DIRECT, "CRS" GN_CRS2_LM. Empty where there is none.
std::string find_method(const std::string& name);

/// The names that find_method gives, sorted.
std::vector<std::string> method_names();

/// Minimises within the unit cube by NLopt. The same arguments give the same sequence of evaluations. What the
/// function throws ends it and is thrown.
Minimum minimize(const Objective& function, std::span<const double> start, const Minimization& how);

} // namespace corticle::fit
