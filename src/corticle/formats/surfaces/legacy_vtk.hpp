// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// Cells of any number of corners: those of cell k end at ends[k].
struct LegacyVtkCells
{
    std::vector<std::int64_t> ends;
    std::vector<std::int64_t> corners; ///< indices of points, checked

    std::size_t count() const { return ends.size(); }
    std::span<const std::int64_t> operator[](std::size_t k) const
    {
        const std::int64_t begin = k == 0 ? 0 : ends[k - 1];
        return std::span(corners).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(ends[k] - begin));
    }
};

/// The geometry of a legacy VTK file (.vtk); its data at points and cells are not read.
struct LegacyVtkFile
{
    std::vector<Vec3> points;
    LegacyVtkCells polygons, strips; ///< of POLYDATA
    LegacyVtkCells cells;            ///< of UNSTRUCTURED_GRID
    std::vector<std::int64_t> types; ///< VTK's numbers for its cells, one each
    bool is_grid = false;            ///< UNSTRUCTURED_GRID
};

/// Reads POLYDATA or UNSTRUCTURED_GRID, ASCII or BINARY, of versions 1 to 5 (VTK File Formats, "simple legacy
/// formats"). VTK's own reader trusts what a file announces (docs/decisions/own-readers.md).
/// @throws InputError, one line naming `name`, for what is no such file, truncated, or holds bad indices
LegacyVtkFile parse_legacy_vtk(std::string_view bytes, const std::string& name);

} // namespace corticle::formats
