// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/markdown.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::study
{

namespace
{

std::string table_line(const std::vector<std::string>& cells)
{
    std::string line = "|";
    for (const std::string& cell : cells)
    {
        line += " " + cell + " |";
    }
    return line + "\n";
}

} // namespace

std::string markdown_cell(std::string_view text)
{
    constexpr std::string_view special = "\\`*_[]<>|#";
    std::string cell;
    for (const char c : text)
    {
        if (special.find(c) != std::string_view::npos)
        {
            cell += '\\';
        }
        cell += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return cell;
}

std::string markdown_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows)
{
    std::string text = table_line(header) + "|";
    for (std::size_t i = 0; i < header.size(); ++i)
    {
        text += "---|";
    }
    text += "\n";
    for (const std::vector<std::string>& row : rows)
    {
        text += table_line(row);
    }
    return text + "\n";
}

std::string table_number(double value)
{
    return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

std::string table_percent(double value)
{
    if (std::isnan(value))
    {
        return "-";
    }
    return std::abs(value) < 1e-9 ? "0 %" : fmt::format("{:+.3g} %", value);
}

std::string table_difference(double value)
{
    if (std::isnan(value))
    {
        return "-";
    }
    return std::abs(value) < 1e-12 ? "0" : fmt::format("{:+.3g}", value);
}

} // namespace corticle::study
