// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <filesystem>

namespace corticle::record
{

/// What `corticle run` was asked for.
struct RunRequest
{
    config::Options options;
    std::filesystem::path out;  ///< run folder
    std::filesystem::path body; ///< body file of `corticle prepare`; empty: prepare the body now
    int threads = 0;            ///< 0: all cores
    bool resume = false;
    bool overwrite = false; ///< remove an earlier run of the same folder first
    bool quiet = false;
};

} // namespace corticle::record
