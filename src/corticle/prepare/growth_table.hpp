// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue_growth.hpp"
#include "corticle/prepare/options.hpp"

#include <filesystem>

namespace corticle::prepare
{

/// Reads a table (parse_text_table) with the columns week, tissue, tangential and radial, in any order.
/// @throws InputError, one line naming file and line
std::vector<material::GrowthRow> read_growth_table(const std::filesystem::path& file);

/// The rows of growth.law, "fetal" or "table".
std::vector<material::GrowthRow> growth_rows(const PreparationOptions& options);

} // namespace corticle::prepare
