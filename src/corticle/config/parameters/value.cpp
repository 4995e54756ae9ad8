// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/value.hpp"

#include <fmt/format.h>

namespace corticle::config
{

namespace
{

std::string real_text(double value)
{
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos)
    {
        text += ".0";
    }
    return text;
}

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
        {
            result += '\\';
            result += c;
        }
        else if (code < 0x20 || code == 0x7f)
        {
            result += fmt::format("\\u{:04X}", code);
        }
        else
        {
            result += c;
        }
    }
    return result + '"';
}

struct TomlText
{
    std::string operator()(const Unsupported&) const { return ""; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return real_text(value); }
    std::string operator()(const std::string& value) const { return quoted(value); }
    std::string operator()(const std::vector<double>& values) const
    {
        std::string result = "[";
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            result += (i == 0 ? "" : ", ") + real_text(values[i]);
        }
        return result + "]";
    }
};

} // namespace

std::string toml_text(const Value& value)
{
    return std::visit(TomlText{}, value);
}

std::string describe(const Value& value)
{
    static constexpr std::string_view kinds[] = {"", "", "the integer ", "", "the string ", "the list "};
    if (const auto* unsupported = std::get_if<Unsupported>(&value))
    {
        return unsupported->what.empty() ? "nothing" : unsupported->what;
    }
    return std::string(kinds[value.index()]) + printable(toml_text(value), 80);
}

std::string printable(std::string_view text, std::size_t longest)
{
    std::string result;
    for (const char c : text.substr(0, longest))
    {
        const auto code = static_cast<unsigned char>(c);
        result += code < 0x20 || code == 0x7f ? ' ' : c;
    }
    if (text.size() > longest)
    {
        while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0x80) != 0)
        {
            result.pop_back(); // never half a character
        }
        result += "...";
    }
    return result;
}

} // namespace corticle::config
