// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace corticle::study
{

/// Text that stands for itself in a cell of a Markdown table.
std::string markdown_cell(std::string_view text);

/// A table: the header, then the rows, each as long as the header. Cells are taken as they are. Ends with an empty
/// line.
std::string markdown_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

/// Five significant digits; "-" for NaN.
std::string table_number(double value);

/// "+1.23 %"; "0 %" below 1e-9 % (round-off), "-" for NaN.
std::string table_percent(double value);

/// A difference of shares, with its sign; a dash for NaN.
std::string table_difference(double value);

} // namespace corticle::study
