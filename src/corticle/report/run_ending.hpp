// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace corticle::report
{

/// The lines with which `corticle run` ends: where the folder is, how the run stands, the measures that matter, and
/// what to open.
std::string run_ending(const std::filesystem::path& folder);

} // namespace corticle::report
