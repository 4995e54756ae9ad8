// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// A column of a table of numbers.
struct NumberColumn
{
    std::string key;
    std::string unit; ///< empty where the header names none
    std::vector<double> values;
};

/// A table of numbers whose columns are found by name.
struct NumberTable
{
    std::vector<NumberColumn> columns;

    std::size_t row_count() const { return columns.empty() ? 0 : columns.front().values.size(); }
    /// The column of this key; null where there is none.
    const NumberColumn* find(std::string_view key) const;
};

/// Reads a table (parse_text_table) of numbers under a header of "key [unit]" or "key", whatever the keys. Empty cells
/// are NaN, and so is text in columns other than `used`; without any, all columns must hold numbers.
/// @throws InputError, one line naming the file, when it is missing, has no header, the same key twice, a row of
/// another length, or a cell that is not a number
NumberTable read_number_table(const std::filesystem::path& file, std::span<const std::string_view> used = {});

/// The same from text already in memory; `name` is used in messages.
NumberTable parse_number_table(std::string_view text, const std::string& name,
                               std::span<const std::string_view> used = {});

} // namespace corticle::formats
