// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/page.hpp"
#include "corticle/report/report.hpp"

namespace corticle::report
{

/// Whether `corticle compare` wrote a comparison into the folder.
bool is_comparison(const std::filesystem::path& folder);

/// The page of a comparison: of two runs, or of a run and real surfaces.
/// @throws InputError when comparison.json is damaged, or a folder or file that it names is not found
Page comparison_page(const ReportRequest& request);

} // namespace corticle::report
