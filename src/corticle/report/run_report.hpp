// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/page.hpp"
#include "corticle/report/report.hpp"

namespace corticle::report
{

/// The page of a run folder. @throws InputError when it is no run, or has no output time
Page run_page(const ReportRequest& request);

} // namespace corticle::report
