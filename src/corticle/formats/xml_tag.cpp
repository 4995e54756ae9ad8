// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/xml_tag.hpp"

#include "corticle/formats/text_scan.hpp"

#include <array>

namespace corticle::formats
{

namespace
{

constexpr std::array<std::pair<std::string_view, char>, 5> entities{
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};

/// Reads the attributes of a tag; false where they are malformed.
bool take_attributes(std::string_view inside, XmlTag& tag)
{
    while (!is_blank(inside))
    {
        while (is_space(inside.front()))
        {
            inside.remove_prefix(1);
        }
        const std::size_t equals = inside.find('=');
        if (equals == std::string_view::npos || equals + 1 >= inside.size())
        {
            return false;
        }
        std::string_view key = inside.substr(0, equals);
        key = take_word(key);
        const char quote = inside[equals + 1];
        const std::size_t close = inside.find(quote, equals + 2);
        if (key.empty() || (quote != '"' && quote != '\'') || close == std::string_view::npos)
        {
            return false;
        }
        tag.attributes.emplace_back(key, inside.substr(equals + 2, close - equals - 2));
        inside.remove_prefix(close + 1);
    }
    return true;
}

/// Position after a comment or declaration that begins at `open`; npos when it does not end, `open` when it is a tag.
std::size_t skip_declaration(std::string_view text, std::size_t open)
{
    const auto after = [&](std::string_view ending)
    {
        const std::size_t found = text.find(ending, open);
        return found == std::string_view::npos ? found : found + ending.size();
    };
    const std::string_view start = text.substr(open, 4);
    if (start == "<!--")
    {
        return after("-->");
    }
    if (start == "<![C")
    {
        return after("]]>"); // CDATA
    }
    if (start.substr(0, 2) == "<?")
    {
        return after("?>");
    }
    return start.substr(0, 2) == "<!" ? after(">") : open;
}

/// Position of the '>' that ends a tag, outside quotes.
std::size_t end_of_tag(std::string_view text, std::size_t position)
{
    char quote = 0;
    for (; position < text.size(); ++position)
    {
        const char c = text[position];
        if (quote != 0)
        {
            quote = c == quote ? '\0' : quote;
        }
        else if (c == '"' || c == '\'')
        {
            quote = c;
        }
        else if (c == '>' || c == '<')
        {
            return c == '>' ? position : std::string_view::npos;
        }
    }
    return std::string_view::npos;
}

} // namespace

std::string_view XmlTag::attribute(std::string_view key, std::string_view otherwise) const
{
    for (const auto& [name_of_attribute, value] : attributes)
    {
        if (name_of_attribute == key)
        {
            return value;
        }
    }
    return otherwise;
}

bool next_tag(std::string_view text, std::size_t position, XmlTag& tag)
{
    std::size_t open = text.find('<', position);
    while (open != std::string_view::npos)
    {
        const std::size_t after = skip_declaration(text, open);
        if (after == open)
        {
            break;
        }
        open = after == std::string_view::npos ? after : text.find('<', after);
    }
    const std::size_t close = open == std::string_view::npos ? open : end_of_tag(text, open + 1);
    if (close == std::string_view::npos)
    {
        return false;
    }
    std::string_view inside = text.substr(open + 1, close - open - 1);
    tag = XmlTag{};
    tag.begin = open;
    tag.end = close + 1;
    tag.closes = !inside.empty() && inside.front() == '/';
    inside.remove_prefix(tag.closes ? 1 : 0);
    tag.is_empty = !inside.empty() && inside.back() == '/';
    inside.remove_suffix(tag.is_empty ? 1 : 0);
    tag.name = take_word(inside);
    return !tag.name.empty() && take_attributes(inside, tag);
}

std::string unescape_xml(std::string_view text)
{
    std::string result;
    while (!text.empty())
    {
        std::size_t used = 1;
        char c = text.front();
        for (const auto& [entity, meaning] : entities)
        {
            if (text.substr(0, entity.size()) == entity)
            {
                used = entity.size();
                c = meaning;
                break;
            }
        }
        result.push_back(c);
        text.remove_prefix(used);
    }
    return result;
}

std::string escape_xml(std::string_view text)
{
    std::string result;
    for (const char c : text)
    {
        std::string_view written(&c, 1);
        for (const auto& [entity, meaning] : entities)
        {
            written = c == meaning ? entity : written;
        }
        result += written;
    }
    return result;
}

} // namespace corticle::formats
