// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/vtk_xml.hpp"

#include "corticle/io/format_error.hpp"
#include "corticle/io/text_scan.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle
{

namespace
{

constexpr std::array<std::pair<std::string_view, char>, 5> entities{
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};

constexpr std::size_t free_growth = 1 << 16;

bool is_blank(std::string_view text)
{
    return take_word(text).empty();
}

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

std::int64_t VtkXmlPiece::count(const std::string& key) const
{
    const auto found = counts.find(key);
    return found == counts.end() ? 0 : found->second;
}

const VtkXmlArray* VtkXmlPiece::find(std::string_view section, std::string_view name) const
{
    for (const VtkXmlArray& array : arrays)
    {
        if (array.section == section && (name.empty() || array.name == name))
        {
            return &array;
        }
    }
    return nullptr;
}

VtkXmlFile::VtkXmlFile(std::string_view bytes, std::string type, std::string file, std::size_t largest_growth)
    : type_(std::move(type)), file_(std::move(file)), budget_(free_growth + largest_growth * bytes.size())
{
    parse(bytes);
    if (pieces_.empty())
    {
        fail("not a complete VTK XML file", "no Piece", fmt::format("a VTKFile of type {}", type_));
    }
}

void VtkXmlFile::fail(std::string_view what, std::string_view got, std::string_view expected) const
{
    fail_reading(file_, what, got, expected);
}

void VtkXmlFile::read_header(const XmlTag& tag)
{
    if (tag.name != "VTKFile" || tag.attribute("type") != type_)
    {
        fail("not the VTK XML file it should be", fmt::format("{} of type {}", tag.name, tag.attribute("type", "none")),
             fmt::format("VTKFile of type {}", type_));
    }
    big_endian_ = tag.attribute("byte_order") == "BigEndian";
    const std::string_view header = tag.attribute("header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64")
    {
        fail("unknown header_type", header, "UInt32 or UInt64");
    }
    header_bytes_ = header == "UInt64" ? 8 : 4;
    compressor_ = tag.attribute("compressor");
    if (!compressor_.empty() && compressor_ != "vtkZLibDataCompressor" && compressor_ != "vtkLZ4DataCompressor")
    {
        fail("unknown compressor", compressor_, "vtkZLibDataCompressor, vtkLZ4DataCompressor or none");
    }
    has_root_ = true;
}

void VtkXmlFile::add_piece(const XmlTag& tag)
{
    pieces_.emplace_back();
    for (const auto& [key, value] : tag.attributes)
    {
        std::int64_t& count = pieces_.back().counts[std::string(key)];
        if (!to_number(value, count) || count < 0)
        {
            fail(fmt::format("bad {}", key), value, "a whole number from 0 on");
        }
    }
}

void VtkXmlFile::add_array(const XmlTag& tag, std::string_view section)
{
    VtkXmlArray array;
    array.section = section;
    array.name = unescape_xml(tag.attribute("Name"));
    array.type = tag.attribute("type");
    array.format = tag.attribute("format", "ascii");
    const bool good = to_number(tag.attribute("NumberOfComponents", "1"), array.components) &&
                      to_number(tag.attribute("offset", "0"), array.offset);
    if (!good || array.components < 1 || array.components > 1000 || array.offset < 0)
    {
        fail(fmt::format("bad DataArray {}", array.name),
             fmt::format("{} components, offset {}", tag.attribute("NumberOfComponents", "1"),
                         tag.attribute("offset", "0")),
             "1 to 1000 components and an offset from 0 on");
    }
    pieces_.back().arrays.push_back(std::move(array));
}

void VtkXmlFile::find_appended_data(std::string_view bytes, const XmlTag& tag)
{
    const std::string_view encoding = tag.attribute("encoding");
    if (encoding != "raw" && encoding != "base64")
    {
        fail("unknown encoding of AppendedData", encoding, "raw or base64");
    }
    appended_base64_ = encoding == "base64";
    const std::size_t mark = bytes.find('_', tag.end);
    if (mark == std::string_view::npos || !is_blank(bytes.substr(tag.end, mark - tag.end)))
    {
        fail("truncated VTK XML file", "no appended data", "data after an underscore");
    }
    appended_ = bytes.substr(mark + 1);
}

void VtkXmlFile::parse(std::string_view bytes)
{
    std::vector<std::string_view> open; // names of the elements around the current position
    XmlTag tag;
    for (std::size_t position = 0; next_tag(bytes, position, tag); position = tag.end)
    {
        const bool in_array =
            !open.empty() && open.back() == "DataArray" && !pieces_.empty() && !pieces_.back().arrays.empty();
        const std::string_view before = bytes.substr(position, tag.begin - position);
        if (in_array && is_blank(pieces_.back().arrays.back().content) && !is_blank(before))
        {
            pieces_.back().arrays.back().content = before;
        }
        if (tag.closes)
        {
            if (open.empty() || open.back() != tag.name)
            {
                fail("malformed XML", fmt::format("</{}>", tag.name), "the tag opened last");
            }
            open.pop_back();
            continue;
        }
        if (!has_root_)
        {
            read_header(tag);
        }
        else if (tag.name == "AppendedData")
        {
            return find_appended_data(bytes, tag);
        }
        else if (tag.name == "Piece" && open.size() == 2 && open.back() == type_)
        {
            add_piece(tag);
        }
        else if (tag.name == "DataArray" && open.size() == 4 && open[2] == "Piece")
        {
            add_array(tag, open.back());
        }
        if (!tag.is_empty)
        {
            open.push_back(tag.name);
        }
    }
    if (!open.empty() || !has_root_)
    {
        fail("truncated or malformed VTK XML file", has_root_ ? fmt::format("no </{}>", open.back()) : "no VTKFile",
             "a complete file");
    }
}

} // namespace corticle
