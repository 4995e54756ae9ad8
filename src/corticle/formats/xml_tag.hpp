// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace corticle::formats
{

/// An XML tag: `<name a="b">`, `<name/>` or `</name>`.
struct XmlTag
{
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> attributes;
    bool closes = false; ///< `</name>`
    bool is_empty = false;
    std::size_t begin = 0; ///< position of '<'
    std::size_t end = 0;   ///< position after '>'

    /// The value of an attribute, `otherwise` when it is not there.
    std::string_view attribute(std::string_view key, std::string_view otherwise = {}) const;
};

/// Finds the next tag from `position` on, past comments and declarations. False at the end or where the text is not
/// XML.
bool next_tag(std::string_view text, std::size_t position, XmlTag& tag);

/// Text with the five XML entities resolved.
std::string unescape_xml(std::string_view text);
/// The reverse, for an attribute.
std::string escape_xml(std::string_view text);

} // namespace corticle::formats
