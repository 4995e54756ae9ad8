// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace corticle
{

/// Numbers for each region label.
struct LabelTable
{
    std::vector<std::string> columns;                 ///< names of the numbers
    std::map<std::int64_t, std::vector<double>> rows; ///< label -> a number for each column

    /// Position of a column; -1 when there is none.
    std::int64_t column(const std::string& name) const;
};

/// Reads a CSV table whose header holds "label" and the names of further columns of numbers; lines that begin with #
/// are comments.
/// @throws InputError, one line naming file and line, on a missing header, a wrong number of fields, a label that is no
/// whole number or is there twice, or a value that is not finite
LabelTable read_label_table(const std::filesystem::path& file);

} // namespace corticle
