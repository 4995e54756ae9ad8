// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/page.hpp"
#include "corticle/report/report.hpp"

namespace corticle::report
{

/// Whether `corticle sweep` wrote its results into the folder.
bool is_sweep(const std::filesystem::path& folder);

/// The page of a sweep. @throws InputError when sweep.json is damaged
Page sweep_page(const ReportRequest& request);

} // namespace corticle::report
