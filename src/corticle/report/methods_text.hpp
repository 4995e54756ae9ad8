// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/report/page.hpp"

namespace corticle::report
{

/// What a methods section needs to say of a run: {"paragraphs": [...], "references": [...]}, in sentences ready to
/// copy, with the numbers of this case.
Json methods_text(const config::Options& options, const Json& summary);

} // namespace corticle::report
