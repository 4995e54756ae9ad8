// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/fit/fit_file.hpp"

namespace corticle::sensitivity
{

/// What a sensitivity file says.
struct SensitivityFile
{
    fit::StudyBase study;
    fit::ParameterSpace space;
    std::vector<fit::Quantity> measures;
    std::size_t paths = 8;  ///< of the screening; 0: none
    std::size_t levels = 4; ///< of its grid
    std::size_t points = 0; ///< runs for the Sobol indices; 0: none
    std::size_t samples = 8192;
};

/// Reads a sensitivity analysis (TOML): base, title, seed, [set], [[parameter]], measures, [morris], [sobol].
/// @throws InputError, one line
SensitivityFile read_sensitivity(const std::filesystem::path& file, std::span<const std::string> overrides);
SensitivityFile parse_sensitivity(std::string_view text, const std::string& name,
                                  const std::filesystem::path& directory, std::span<const std::string> overrides);

} // namespace corticle::sensitivity
