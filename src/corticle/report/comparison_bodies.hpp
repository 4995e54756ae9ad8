// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/body.hpp"

#include <array>

namespace corticle::report
{

/// Both runs at their common output times, each with its distance to the other, "distance" [mm].
/// @param frames  of comparison.json
std::vector<Body> bodies_of_runs(const std::array<std::filesystem::path, 2>& folders,
                                 const std::array<std::string, 2>& names, const Json& frames);

/// A real surface and the run at the output time nearest to it, moved to the same middle.
struct RealPair
{
    std::string label;
    Json distance; ///< {"mean", "p95", "hausdorff"} [mm]
    std::vector<Body> bodies;
};
using RealPairs = std::vector<RealPair>;

/// One pair for each real surface that the run reaches.
/// @param comparison  comparison.json, of kind "real"
RealPairs bodies_of_reals(const std::filesystem::path& folder, const Json& comparison, std::vector<std::string>& notes);

} // namespace corticle::report
