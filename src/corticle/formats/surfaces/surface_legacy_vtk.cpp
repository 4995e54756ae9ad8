// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/legacy_vtk.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::formats
{

namespace
{

// VTK's numbers for cells.
constexpr std::array<std::int64_t, 4> unseen{1, 2, 3, 4}; // points and lines
constexpr std::array<std::int64_t, 3> polygons{5, 7, 9};  // triangle, polygon, quad
constexpr std::int64_t strip = 6;

void add_grid(const LegacyVtkFile& file, SurfaceBuilder& surface)
{
    for (std::size_t k = 0; k < file.cells.count(); ++k)
    {
        const std::int64_t type = file.types[k];
        if (type == strip)
        {
            surface.add_strip(file.cells[k]);
        }
        else if (std::ranges::find(polygons, type) != polygons.end())
        {
            surface.add_polygon(file.cells[k]);
        }
        else if (std::ranges::find(unseen, type) == unseen.end())
        {
            fail_reading(surface.file(), "a cell that is no polygon", fmt::format("VTK cell type {}", type),
                         "triangles (5), strips (6), polygons (7) and quads (9)");
        }
    }
}

} // namespace

void parse_legacy_vtk_surface(std::string_view bytes, SurfaceBuilder& surface)
{
    const LegacyVtkFile file = parse_legacy_vtk(bytes, surface.file());
    for (const Vec3& point : file.points)
    {
        surface.add_vertex(point);
    }
    for (std::size_t k = 0; k < file.polygons.count(); ++k)
    {
        surface.add_polygon(file.polygons[k]);
    }
    for (std::size_t k = 0; k < file.strips.count(); ++k)
    {
        surface.add_strip(file.strips[k]);
    }
    add_grid(file, surface);
}

} // namespace corticle::formats
