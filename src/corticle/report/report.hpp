// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace corticle::report
{

inline constexpr const char* report_file = "report.html";

/// How large a page may be: beyond that output times, and then vertices, are left out.
inline constexpr double default_megabytes = 40.0;

/// What `corticle report` was asked for.
struct ReportRequest
{
    std::filesystem::path folder; ///< of a run, a comparison or a sweep
    double megabytes = default_megabytes;
};

/// Writes report.html into the folder, whole or not at all. Returns its path.
/// @throws InputError for a folder that is none of a run, a comparison or a sweep; RunError when three.js is missing or
/// the file cannot be written
std::filesystem::path write_report(const ReportRequest& request);

} // namespace corticle::report
