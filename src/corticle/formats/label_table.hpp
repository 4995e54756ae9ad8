// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// Numbers for each region label.
struct LabelTable
{
    std::vector<std::string> columns;                 ///< names of the numbers: those asked for that are there
    std::map<std::int64_t, std::vector<double>> rows; ///< label -> a number for each column
    std::vector<std::string> unused;                  ///< names of the other columns

    /// Position of a column; -1 when there is none.
    std::int64_t column(std::string_view name) const;
};

/// Reads a table (parse_text_table) whose header holds "label" and the names of further columns, of which those in
/// `used` are read; what stands in the others is left alone.
/// @throws InputError, one line naming file and line, on a missing header, the same column twice, a wrong number of
/// cells, a label that is not a whole number or is there twice, or a value that is not finite
LabelTable read_label_table(const std::filesystem::path& file, std::span<const std::string_view> used);

} // namespace corticle::formats
