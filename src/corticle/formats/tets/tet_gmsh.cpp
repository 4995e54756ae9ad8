// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/number_source.hpp"
#include "corticle/formats/tets/gmsh_elements.hpp"
#include "corticle/formats/tets/tet_formats.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

// The MSH file format of the Gmsh reference manual, versions 2.2, 4.0 and 4.1.

namespace corticle::formats
{

namespace
{

enum class Version
{
    v2,
    v4_0,
    v4_1
};

struct Header
{
    Version version = Version::v2;
    NumberSource::Form form = NumberSource::Form::text;
    int size_bytes = 8; ///< of a size_t in 4.1
};

Vec3 take_position(NumberSource& source)
{
    Vec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
        position[axis] = source.real("coordinate of a node");
    }
    return position;
}

void require_total(const NumberSource& source, std::string_view what, std::int64_t got, std::int64_t announced)
{
    if (got != announced)
    {
        source.fail(fmt::format("the blocks of {} do not add up", what), fmt::format("{}", got),
                    fmt::format("{}", announced));
    }
}

/// Version 2: the number of entries is text in binary files too.
void parse_nodes_2(NumberSource& counts, NumberSource& source, TetBuilder& mesh)
{
    const std::int64_t count = counts.count(4, 28, 4, "number of nodes");
    mesh.reserve_nodes(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i)
    {
        const std::int64_t tag = source.integer(4, "number of a node");
        mesh.add_node(tag, take_position(source));
    }
}

void skip_tags(NumberSource& source, std::int64_t count)
{
    for (std::int64_t k = 0; k < count; ++k)
    {
        source.integer(4, "tag of an element");
    }
}

void parse_elements_2(NumberSource& counts, NumberSource& source, TetBuilder& mesh)
{
    const std::int64_t count = counts.count(4, 8, 4, "number of elements");
    std::int64_t taken = 0;
    while (taken < count)
    {
        // Text: an element has a header of its own, after its number. Binary: a header serves a block of elements.
        if (source.is_text())
        {
            source.integer(4, "number of an element");
        }
        const GmshElementType& type = gmsh_element_type(source.integer(4, "type of an element"), source);
        const std::int64_t in_block =
            source.is_text() ? 1 : source.count(4, 4 * type.nodes + 4, 1, "number of elements in a block");
        const std::int64_t tags = source.count(4, 4, 1, "number of tags");
        if (in_block == 0)
        {
            source.fail("bad number of elements in a block", "0", "at least 1");
        }
        for (std::int64_t i = 0; i < in_block; ++i)
        {
            if (!source.is_text())
            {
                source.integer(4, "number of an element");
            }
            skip_tags(source, tags);
            take_gmsh_element(source, type, 4, mesh);
        }
        taken += in_block;
    }
    require_total(source, "elements", taken, count);
}

/// Parametric coordinates that follow a position.
void skip_parameters(NumberSource& source, std::int64_t count)
{
    for (std::int64_t k = 0; k < count; ++k)
    {
        source.real("parametric coordinate");
    }
}

struct NodeBlock
{
    std::int64_t parameters; ///< a node
    std::int64_t nodes;
};

NodeBlock take_node_block(NumberSource& source, const Header& header)
{
    const bool is_new = header.version == Version::v4_1;
    const std::int64_t first = source.integer(4, "entity of a block");
    const std::int64_t second = source.integer(4, "entity of a block");
    const std::int64_t dimension = is_new ? first : second; // 4.0 names the tag first
    const bool parametric = source.integer(4, "parametric flag of a block") != 0;
    if (dimension < 0 || dimension > 3)
    {
        source.fail("bad dimension of a block of nodes", fmt::format("{}", dimension), "0 to 3");
    }
    const auto bytes = static_cast<std::size_t>(is_new ? header.size_bytes + 24 : 28);
    return {parametric ? dimension : 0, source.count(is_new ? header.size_bytes : 8, bytes, 4, "number of nodes")};
}

void parse_nodes_4(NumberSource& source, const Header& header, TetBuilder& mesh)
{
    const bool is_new = header.version == Version::v4_1;
    const int size = is_new ? header.size_bytes : 8;
    const std::int64_t blocks = source.integer(size, "number of blocks of nodes");
    const std::int64_t count = source.count(size, 28, 4, "number of nodes");
    if (is_new)
    {
        source.integer(size, "least number of a node");
        source.integer(size, "largest number of a node");
    }
    mesh.reserve_nodes(static_cast<std::size_t>(count));
    std::vector<std::int64_t> tags;
    for (std::int64_t b = 0; b < blocks; ++b)
    {
        const NodeBlock block = take_node_block(source, header);
        tags.clear();
        for (std::int64_t i = 0; is_new && i < block.nodes; ++i)
        {
            tags.push_back(source.integer(size, "number of a node"));
        }
        for (std::int64_t i = 0; i < block.nodes; ++i)
        {
            const std::int64_t tag = is_new ? tags[static_cast<std::size_t>(i)] : source.integer(4, "number of a node");
            const Vec3 position = take_position(source);
            skip_parameters(source, block.parameters);
            mesh.add_node(tag, position);
        }
    }
    require_total(source, "nodes", mesh.node_count(), count);
}

void parse_elements_4(NumberSource& source, const Header& header, TetBuilder& mesh)
{
    const bool is_new = header.version == Version::v4_1;
    const int size = is_new ? header.size_bytes : 8;
    const int tag_bytes = is_new ? header.size_bytes : 4;
    const std::int64_t blocks = source.integer(size, "number of blocks of elements");
    const std::int64_t count = source.count(size, 8, 2, "number of elements");
    if (is_new)
    {
        source.integer(size, "least number of an element");
        source.integer(size, "largest number of an element");
    }
    std::int64_t taken = 0;
    for (std::int64_t b = 0; b < blocks; ++b)
    {
        source.integer(4, "entity of a block");
        source.integer(4, "entity of a block");
        const GmshElementType& type = gmsh_element_type(source.integer(4, "type of an element"), source);
        const std::size_t bytes = (type.nodes + 1) * static_cast<std::size_t>(tag_bytes);
        const std::int64_t in_block = source.count(size, bytes, type.nodes + 1, "number of elements in a block");
        for (std::int64_t i = 0; i < in_block; ++i)
        {
            source.integer(tag_bytes, "number of an element");
            take_gmsh_element(source, type, tag_bytes, mesh);
        }
        taken += in_block;
    }
    require_total(source, "elements", taken, count);
}

Header parse_header(std::string_view bytes, std::size_t begin, std::size_t end, std::string_view file)
{
    std::string_view content = bytes.substr(begin, end - begin);
    std::string_view line;
    take_line(content, line);
    std::string_view words = line;
    double version = 0.0;
    int type = -1;
    Header header;
    const bool good = to_number(take_word(words), version) && to_number(take_word(words), type) &&
                      to_number(take_word(words), header.size_bytes);
    if (!good || (type != 0 && type != 1) || (header.size_bytes != 4 && header.size_bytes != 8))
    {
        fail_reading(file, "bad $MeshFormat", line, "a version, 0 or 1, and 4 or 8");
    }
    if (!(version >= 2.0 && version < 3.0) && !(version >= 4.0 && version < 5.0))
    {
        fail_reading(file, "a version of the Gmsh format that is not read", line, "version 2, 4.0 or 4.1");
    }
    header.version = version < 3.0 ? Version::v2 : (version < 4.05 ? Version::v4_0 : Version::v4_1);
    if (type == 1)
    {
        if (content.size() < 4)
        {
            fail_reading(file, "truncated $MeshFormat", "the end of the data", "the number 1 in 4 bytes");
        }
        const bool big = load<std::int32_t>(content.data(), true) == 1;
        if (!big && load<std::int32_t>(content.data(), false) != 1)
        {
            fail_reading(file, "unknown byte order in $MeshFormat", "other bytes", "the number 1 in 4 bytes");
        }
        header.form = big ? NumberSource::Form::big_endian : NumberSource::Form::little_endian;
    }
    return header;
}

struct Section
{
    std::string_view name;
    std::size_t begin = 0, end = 0; ///< of its content
};

/// The section that begins at or after a position, which moves on to its end; false when there is none.
bool take_section(std::string_view bytes, std::size_t& position, std::string_view file, Section& section)
{
    std::string_view rest = bytes.substr(position);
    section.name = take_word(rest);
    if (section.name.empty())
    {
        return false;
    }
    if (section.name.front() != '$' || section.name.starts_with("$End"))
    {
        fail_reading(file, "bad Gmsh file", section.name, "a section such as $Nodes");
    }
    section.name.remove_prefix(1);
    std::string_view line;
    take_line(rest, line);
    section.begin = bytes.size() - rest.size();
    const std::string closing = fmt::format("$End{}", section.name);
    section.end = bytes.find(closing, section.begin);
    if (section.end == std::string_view::npos)
    {
        fail_reading(file, "truncated Gmsh file", fmt::format("no {}", closing), "the end of every section");
    }
    position = section.end + closing.size();
    return true;
}

/// Version 2 puts the number of entries on a line of text before them.
void parse_section_2(std::string_view bytes, const Section& section, const Header& header, TetBuilder& mesh)
{
    const std::size_t line_end = std::min(bytes.find('\n', section.begin), section.end);
    NumberSource counts(bytes, section.begin, section.end, NumberSource::Form::text, mesh.file());
    const std::size_t begin = std::min(line_end + 1, section.end);
    NumberSource source(bytes, begin, section.end, header.form, mesh.file());
    if (section.name == "Nodes")
    {
        parse_nodes_2(counts, source, mesh);
    }
    else
    {
        parse_elements_2(counts, source, mesh);
    }
}

void parse_section_4(std::string_view bytes, const Section& section, const Header& header, TetBuilder& mesh)
{
    NumberSource source(bytes, section.begin, section.end, header.form, mesh.file());
    if (section.name == "Nodes")
    {
        parse_nodes_4(source, header, mesh);
    }
    else
    {
        parse_elements_4(source, header, mesh);
    }
}

} // namespace

void parse_gmsh(std::string_view bytes, TetBuilder& mesh)
{
    Header header;
    bool has_header = false;
    Section section;
    for (std::size_t position = 0; take_section(bytes, position, mesh.file(), section);)
    {
        if (section.name == "NOD" || section.name == "ELM")
        {
            fail_reading(mesh.file(), "a version of the Gmsh format that is not read", "version 1",
                         "version 2, 4.0 or 4.1");
        }
        if (section.name == "ParametricNodes")
        {
            fail_reading(mesh.file(), "parametric nodes of Gmsh version 2 are not read", "$ParametricNodes",
                         "a file saved with Mesh.SaveParametric = 0");
        }
        if (section.name == "MeshFormat")
        {
            header = parse_header(bytes, section.begin, section.end, mesh.file());
            has_header = true;
        }
        else if (section.name == "Nodes" || section.name == "Elements")
        {
            if (!has_header)
            {
                fail_reading(mesh.file(), "bad Gmsh file", fmt::format("${} before $MeshFormat", section.name),
                             "$MeshFormat first");
            }
            const auto parse = header.version == Version::v2 ? parse_section_2 : parse_section_4;
            parse(bytes, section, header, mesh);
        }
    }
}

} // namespace corticle::formats
