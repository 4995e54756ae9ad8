// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/prepare/options.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace corticle::config
{

/// Whether pictures are drawn, or a report written.
enum class PictureRule
{
    on,
    off
};

struct OutputOptions
{
    std::int64_t count = 10;   ///< evenly spaced in t, besides t = 0
    std::vector<double> times; ///< instead of count
    std::vector<double> weeks; ///< instead of count, with a clock
    PictureRule pictures = PictureRule::on;
    std::vector<double> picture_times;    ///< output times that get pictures (the nearest); empty: the last
    PictureRule report = PictureRule::on; ///< report.html at the end of the run
    double checkpoint_minutes = 5.0;
};

/// All that a case file says.
struct Options : prepare::PreparationOptions
{
    OutputOptions output;
    std::map<std::string, std::string, std::less<>> inputs; ///< SHA-256 of the file that a key ("geometry.file") names
};

} // namespace corticle::config
