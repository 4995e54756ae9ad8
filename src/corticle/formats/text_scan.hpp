// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

namespace corticle::formats
{

inline bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// Takes the next word off the front of `text`; empty at the end.
inline std::string_view take_word(std::string_view& text)
{
    std::size_t begin = 0;
    while (begin < text.size() && is_space(text[begin]))
    {
        ++begin;
    }
    std::size_t end = begin;
    while (end < text.size() && !is_space(text[end]))
    {
        ++end;
    }
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

/// Without white space at either end.
inline std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_space(text.front()))
    {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_space(text.back()))
    {
        text.remove_suffix(1);
    }
    return text;
}

/// True when there is nothing but white space.
inline bool is_blank(std::string_view text)
{
    return take_word(text).empty();
}

/// Takes the next line off the front of `text`, without its end ("\n", "\r\n", "\r"); false at the end.
inline bool take_line(std::string_view& text, std::string_view& line)
{
    if (text.empty())
    {
        return false;
    }
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : (text.empty() ? 0 : 1));
    return true;
}

/// Without the mark of byte order that editors put before UTF-8.
inline std::string_view without_byte_order_mark(std::string_view text)
{
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// True when the whole word is one number of this type.
template <class Number>
bool to_number(std::string_view word, Number& value)
{
    if (word.size() > 1 && word.front() == '+' && word[1] != '-')
    {
        word.remove_prefix(1);
    }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return !word.empty() && error == std::errc{} && end == word.data() + word.size();
}

/// In lower case, of ASCII.
inline char lower_case(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string lower_case(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) { return lower_case(c); });
    return lower;
}

/// Equal up to ASCII case; `lower` is in lower case.
inline bool equals_ignoring_case(std::string_view word, std::string_view lower)
{
    if (word.size() != lower.size())
    {
        return false;
    }
    for (std::size_t i = 0; i < word.size(); ++i)
    {
        if (lower_case(word[i]) != lower[i])
        {
            return false;
        }
    }
    return true;
}

/// Reads a number in the byte order of the file; `bytes` holds at least sizeof(Number).
template <class Number>
Number load(const char* bytes, bool big_endian)
{
    char buffer[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
    {
        buffer[i] = bytes[big_endian ? sizeof(Number) - 1 - i : i];
    }
    Number value;
    std::memcpy(&value, buffer, sizeof(Number));
    return value;
}

} // namespace corticle::formats
