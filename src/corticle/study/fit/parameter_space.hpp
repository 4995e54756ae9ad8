// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/study/fit/table_reader.hpp"
#include "corticle/study/surrogate/design.hpp"

#include <string>

namespace corticle::fit
{

/// A number of the case that is to be found, between two bounds.
struct FreeParameter
{
    std::string key;            ///< of the case; "map.modes.3" is the third number of the list map.modes
    std::string list;           ///< the key of that list; empty: no number of a list
    std::size_t place = 0;      ///< in the list, from 0
    std::vector<double> others; ///< the list in the base, as long as it needs to be
    std::string unit;
    double low = 0.0;
    double high = 1.0;
    bool is_log = false;    ///< its logarithm is what is evenly divided, and what the prior speaks of
    bool is_whole = false;  ///< a count, rounded
    bool is_normal = false; ///< the prior: normal within the bounds, else even
    double mean = 0.0;      ///< of a normal prior
    double sd = 1.0;        ///< of a normal prior; of the natural logarithm where is_log
    double start = 0.5;     ///< where a search begins

    std::string name() const;     ///< the key without its section
    double value(double u) const; ///< at a coordinate of the unit cube
    double unit_of(double value) const;
};

/// The free parameters; a point of the unit cube is a value of each.
class ParameterSpace
{
  public:
    std::vector<FreeParameter> parameters;

    std::size_t size() const { return parameters.size(); }
    std::vector<double> values(std::span<const double> u) const;
    Point start() const;
    /// Logarithm of the prior density over the cube, but for a constant.
    double log_prior(std::span<const double> u) const;
    /// "section.key=value" for each.
    std::vector<std::string> overrides(std::span<const double> u) const;
};

/// The [[parameter]] tables. A key is a number of the case, or one of the numbers of a list.
/// @param base  where starts are taken from that are not given
/// @throws InputError for what is no number of the case, bounds outside its range or in wrong order, a start outside
/// the bounds
ParameterSpace read_parameters(const config::TomlNode& list, const sweep::SweepPlace& place,
                               const config::Options& base);

} // namespace corticle::fit
