// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/vtk_xml.hpp"

#include "corticle/formats/checksum.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

constexpr std::size_t free_growth = 1 << 16;

} // namespace

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

const VtkXmlArray& VtkXmlFile::required(const VtkXmlPiece& piece, std::string_view section, std::string_view name) const
{
    const VtkXmlArray* array = piece.find(section, name);
    if (array == nullptr)
    {
        fail_reading(file_, fmt::format("no array {} in {}", name, section), "none", "one");
    }
    return *array;
}

VtkXmlFile::VtkXmlFile(std::string_view bytes, std::string type, std::string file, std::size_t largest_growth)
    : type_(std::move(type)), file_(std::move(file)), budget_(free_growth + largest_growth * bytes.size())
{
    require_checksum(bytes, file_);
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
    bool array_is_open = false;
    XmlTag tag;
    for (std::size_t position = 0; next_tag(bytes, position, tag); position = tag.end)
    {
        const std::string_view before = bytes.substr(position, tag.begin - position);
        if (array_is_open && pieces_.back().arrays.back().content.empty() && !is_blank(before))
        {
            pieces_.back().arrays.back().content = before;
        }
        array_is_open = array_is_open && !(tag.closes && tag.name == "DataArray");
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
        else if (tag.name == "DataArray" && open.size() == 4 && open[1] == type_ && open[2] == "Piece")
        {
            add_array(tag, open.back());
            array_is_open = !tag.is_empty;
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

} // namespace corticle::formats
