// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/plain_text.hpp"

#include <algorithm>

namespace corticle::report
{

namespace
{

/// What may stand before a path.
constexpr std::string_view before_path = " \t\n\"'(=[,:@";
/// What ends one.
constexpr std::string_view after_path = " \t\n\"')],;:@";

std::string shortened(std::string_view path)
{
    while (path.size() > 1 && path.back() == '/')
    {
        path.remove_suffix(1);
    }
    return std::string(path.substr(path.rfind('/') + 1));
}

} // namespace

std::string without_paths(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        const bool begins = i == 0 || before_path.find(text[i - 1]) != std::string_view::npos;
        const std::size_t end = std::min(text.find_first_of(after_path, i), text.size());
        const std::string_view word = text.substr(i, end - i);
        const bool is_path =
            begins && word.find('/') != std::string_view::npos &&
            (word.starts_with('/') || word.starts_with("~/") || word.starts_with("./") || word.starts_with("../"));
        if (is_path && word.size() > 1)
        {
            result += shortened(word);
            i = end;
        }
        else
        {
            result += text[i++];
        }
    }
    return result;
}

std::string name_of(const std::filesystem::path& path)
{
    return std::filesystem::absolute(path / ".").lexically_normal().parent_path().filename().string();
}

} // namespace corticle::report
