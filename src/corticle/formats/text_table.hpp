// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// A table of text: cells in rows, every row with as many as the first.
struct TextTable
{
    struct Row
    {
        std::int64_t line = 0; ///< in the file, from 1
        std::vector<std::string> cells;
    };
    std::string name; ///< of the file, for messages
    std::vector<Row> rows;
    /// What separates the cells: a comma, a semicolon, a tab, or white space (' '); 0 where there is one column.
    char separator = 0;

    /// May numbers have a decimal comma? Not where commas separate cells.
    bool allows_decimal_commas() const { return separator == ';' || separator == '\t' || separator == ' '; }
};

/// Cuts text into cells. The first row decides what separates them: semicolons, else tabs, else commas, else white
/// space. Quotes and white space about a cell are taken off; a mark of byte order, blank lines and lines that begin
/// with # are passed over. Numbers written with decimal commas, as spreadsheets do where semicolons separate, get
/// points.
/// @throws InputError, one line naming file and line, for a row of another length than the first, a quote that does not
/// close, and a table with both decimal commas and decimal points
TextTable parse_text_table(std::string_view text, const std::string& name);

} // namespace corticle::formats
