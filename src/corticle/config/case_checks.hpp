// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <array>
#include <functional>
#include <span>
#include <string_view>

namespace corticle::config
{

/// Checks that concern several parameters. `place(key)` says where a key was given: " (case.toml:4)", or "".
/// @throws InputError
void check_case(const Options& options, const std::function<std::string(std::string_view)>& place);

/// Volume of the built-in shapes [mm³]; 0 for a file.
double shape_volume(const prepare::GeometryOptions& geometry);

/// What is allowed but probably not meant, one line each.
std::vector<std::string> case_warnings(const Options& options);

/// A line for each of output.times, output.weeks and output.picture_times that names times which a run from growth
/// time `from` on does not reach. @param recorded  output times that an earlier part of the run has written
std::vector<std::string> dropped_outputs(const Options& options, double from, std::span<const double> recorded = {});

} // namespace corticle::config
