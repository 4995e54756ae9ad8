// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/tets/tet_samples.hpp"

namespace corticle
{

/// How a sample of a legacy VTK file is written.
struct LegacyVtkStyle
{
    bool is_binary = false;
    bool has_offsets = false; ///< version 5
};

inline std::vector<LegacyVtkStyle> legacy_vtk_styles()
{
    return {{false, false}, {true, false}, {false, true}, {true, true}};
}

inline SampleText legacy_vtk_numbers(const LegacyVtkStyle& style)
{
    return SampleText(style.is_binary ? SampleText::Form::big_endian : SampleText::Form::text);
}

template <class Cell>
std::string legacy_vtk_cells(const std::string& section, const std::vector<Cell>& cells, const LegacyVtkStyle& style)
{
    const std::size_t corners = cells.empty() ? 0 : cells.front().size();
    SampleText text = legacy_vtk_numbers(style);
    if (!style.has_offsets)
    {
        text.put(fmt::format("{} {} {}\n", section, cells.size(), (corners + 1) * cells.size()));
        for (const Cell& cell : cells)
        {
            text.number(static_cast<std::int32_t>(corners));
            for (const std::int32_t corner : cell)
            {
                text.number(corner);
            }
            text.end_line();
        }
        return text.put("\n").bytes();
    }
    text.put(fmt::format("{} {} {}\nOFFSETS vtktypeint64\n", section, cells.size() + 1, corners * cells.size()));
    for (std::size_t k = 0; k <= cells.size(); ++k)
    {
        text.number(static_cast<std::int64_t>(corners * k));
    }
    text.put("\nCONNECTIVITY vtktypeint64\n");
    for (const Cell& cell : cells)
    {
        for (const std::int32_t corner : cell)
        {
            text.number(static_cast<std::int64_t>(corner));
        }
    }
    return text.put("\n").bytes();
}

inline std::string legacy_vtk_head(const char* dataset, const std::vector<Vec3>& points, const LegacyVtkStyle& style)
{
    SampleText text = legacy_vtk_numbers(style);
    text.put(fmt::format("# vtk DataFile Version {}\na sample\n{}\nDATASET {}\nPOINTS {} double\n",
                         style.has_offsets ? "5.1" : "3.0", style.is_binary ? "BINARY" : "ASCII", dataset,
                         points.size()));
    for (const Vec3& point : points)
    {
        text.position(point).end_line();
    }
    return text.put("\n").bytes();
}

inline std::string legacy_vtk_surface(const TriangleMesh& mesh, const LegacyVtkStyle& style)
{
    return legacy_vtk_head("POLYDATA", mesh.vertices, style) + legacy_vtk_cells("POLYGONS", mesh.triangles, style);
}

inline std::string legacy_vtk_tets(const TetMesh& mesh, const LegacyVtkStyle& style)
{
    SampleText types = legacy_vtk_numbers(style);
    types.put(fmt::format("CELL_TYPES {}\n", mesh.tets.size()));
    for (std::size_t k = 0; k < mesh.tets.size(); ++k)
    {
        types.number(std::int32_t{10});
    }
    return legacy_vtk_head("UNSTRUCTURED_GRID", mesh.vertices, style) + legacy_vtk_cells("CELLS", mesh.tets, style) +
           types.put("\n").bytes();
}

} // namespace corticle
