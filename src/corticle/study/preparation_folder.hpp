// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"

#include <filesystem>
#include <string>

namespace corticle::study
{

/// What `corticle prepare` was asked for.
struct PrepareRequest
{
    config::Options options;
    std::filesystem::path out;
    int threads = 0;             ///< 0: all cores
    bool overwrite = false;      ///< replace what an earlier preparation left there
    bool compare_thesis = false; ///< also measure the thesis's own choices beside the exact answer
};

/// Prepares the body of a case and writes it: body.h5 (for `corticle run --body`), case.toml, particles.vtu,
/// surface.vtp, preparation.json and pictures. Returns the report as text for people.
/// @throws InputError before anything is written; RunError when something cannot be written
std::string prepare(const PrepareRequest& request);

} // namespace corticle::study
