// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/legacy_vtk.hpp"
#include "corticle/formats/tets/tet_formats.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::formats
{

namespace
{

/// Arrays may take this many times the bytes of the file: cell types and offsets of tets shrink to almost nothing.
constexpr std::size_t largest_growth = 100;

constexpr std::int64_t most_entries = std::int64_t{1} << 40;

/// VTK's numbers for cells: linear, quadratic and higher tets, whose corners come first.
constexpr std::array<std::int64_t, 4> tet_types{10, 24, 71, 78};
/// Points, lines and faces of any order.
constexpr std::array<std::int64_t, 27> flat_types{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  21, 22, 23, 28,
                                                  30, 34, 35, 36, 60, 61, 62, 68, 69, 70, 75, 76, 77};

template <std::size_t size>
bool is_among(const std::array<std::int64_t, size>& types, std::int64_t type)
{
    return std::find(types.begin(), types.end(), type) != types.end();
}

void add_points(const VtkXmlFile& file, const VtkXmlPiece& piece, TetBuilder& mesh)
{
    const std::int64_t count = piece.count("NumberOfPoints");
    if (count == 0)
    {
        return;
    }
    const VtkXmlArray& array = file.required(piece, "Points", "");
    if (array.components != 3 || count > most_entries)
    {
        fail_reading(file.file(), "bad Points", fmt::format("{} points of {} components", count, array.components),
                     "3 components");
    }
    const std::vector<double> values = file.doubles(array, 3 * count);
    for (std::size_t i = 0; i < values.size(); i += 3)
    {
        mesh.add_node(mesh.node_count(), {values[i], values[i + 1], values[i + 2]});
    }
}

void add_cell(std::int64_t type, std::span<const std::int64_t> nodes, TetBuilder& mesh)
{
    if (is_among(flat_types, type))
    {
        return;
    }
    if (!is_among(tet_types, type))
    {
        fail_reading(mesh.file(), "a cell that is no tet", fmt::format("VTK cell type {}", type),
                     "tets (type 10), triangles, lines and points");
    }
    if (nodes.size() < 4)
    {
        fail_reading(mesh.file(), fmt::format("tet {} (counted from 0) is none", mesh.tet_count()),
                     fmt::format("{} nodes", nodes.size()), "at least 4");
    }
    mesh.add_tet(nodes);
}

void add_cells(const VtkXmlFile& file, const VtkXmlPiece& piece, std::int64_t first_node, TetBuilder& mesh)
{
    const std::int64_t count = piece.count("NumberOfCells");
    if (count == 0)
    {
        return;
    }
    const std::vector<std::int64_t> offsets = file.integers(file.required(piece, "Cells", "offsets"), count);
    const std::vector<std::int64_t> types = file.integers(file.required(piece, "Cells", "types"), count);
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
        const std::int64_t before = i == 0 ? 0 : offsets[i - 1];
        if (offsets[i] < before)
        {
            fail_reading(file.file(), "the offsets of the cells decrease",
                         fmt::format("{} after {}", offsets[i], before), "growing offsets");
        }
    }
    std::vector<std::int64_t> nodes = file.integers(file.required(piece, "Cells", "connectivity"), offsets.back());
    for (std::int64_t& node : nodes)
    {
        // An index that names no point of its piece must not name one of another.
        node = node < 0 || node >= mesh.node_count() - first_node ? -1 : node + first_node;
    }
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
        add_cell(types[i], std::span(nodes).subspan(begin, offsets[i] - begin), mesh);
        begin = offsets[i];
    }
}

} // namespace

void parse_vtu(std::string_view bytes, TetBuilder& mesh)
{
    const VtkXmlFile file(bytes, "UnstructuredGrid", mesh.file(), largest_growth);
    for (const VtkXmlPiece& piece : file.pieces())
    {
        const std::int64_t first = mesh.node_count();
        add_points(file, piece, mesh);
        add_cells(file, piece, first, mesh);
    }
}

void parse_legacy_vtk_tets(std::string_view bytes, TetBuilder& mesh)
{
    const LegacyVtkFile file = parse_legacy_vtk(bytes, mesh.file());
    for (const Vec3& point : file.points)
    {
        mesh.add_node(mesh.node_count(), point);
    }
    for (std::size_t k = 0; k < file.cells.count(); ++k)
    {
        add_cell(file.types[k], file.cells[k], mesh);
    }
}

bool has_legacy_vtk_tets(std::string_view bytes, const std::string& name)
{
    const LegacyVtkFile file = parse_legacy_vtk(bytes, name);
    return std::ranges::any_of(file.types, [](std::int64_t type) { return is_among(tet_types, type); });
}

} // namespace corticle::formats
