// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

/// Arrays may take this many times the bytes of the file: a compressed mesh shrinks by less than ten.
constexpr std::size_t largest_growth = 20;

void add_points(const VtkXmlFile& file, const VtkXmlPiece& piece, SurfaceBuilder& surface)
{
    const std::int64_t count = piece.count("NumberOfPoints");
    if (count == 0)
    {
        return;
    }
    const VtkXmlArray& array = file.required(piece, "Points", "");
    if (array.components != 3 || count > std::int64_t{1} << 40)
    {
        fail_reading(file.file(), "bad Points", fmt::format("{} points of {} components", count, array.components),
                     "3 components");
    }
    const std::vector<double> values = file.doubles(array, 3 * count);
    for (std::size_t i = 0; i < values.size(); i += 3)
    {
        surface.add_vertex({values[i], values[i + 1], values[i + 2]});
    }
}

/// Cells of one section, "Polys" or "Strips"; `add` receives the corners of each.
template <class Add>
void add_cells(const VtkXmlFile& file, const VtkXmlPiece& piece, std::string_view section, std::int64_t first,
               SurfaceBuilder& surface, Add add)
{
    const std::int64_t count = piece.count(fmt::format("NumberOf{}", section));
    if (count == 0)
    {
        return;
    }
    const std::vector<std::int64_t> offsets = file.integers(file.required(piece, section, "offsets"), count);
    std::int64_t begin = 0;
    for (const std::int64_t end : offsets)
    {
        if (end < begin)
        {
            fail_reading(file.file(), fmt::format("the offsets of {} decrease", section),
                         fmt::format("{} after {}", end, begin), "growing offsets");
        }
        begin = end;
    }
    std::vector<std::int64_t> corners = file.integers(file.required(piece, section, "connectivity"), offsets.back());
    for (std::int64_t& corner : corners)
    {
        // An index that names no point of its piece must not name one of another.
        corner = corner < 0 || corner >= surface.vertex_count() - first ? -1 : corner + first;
    }
    begin = 0;
    for (const std::int64_t end : offsets)
    {
        add(std::span(corners).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)));
        begin = end;
    }
}

} // namespace

void parse_vtp(std::string_view bytes, SurfaceBuilder& surface)
{
    const VtkXmlFile file(bytes, "PolyData", surface.file(), largest_growth);
    for (const VtkXmlPiece& piece : file.pieces())
    {
        const std::int64_t first = surface.vertex_count();
        add_points(file, piece, surface);
        add_cells(file, piece, "Polys", first, surface,
                  [&](std::span<const std::int64_t> corners) { surface.add_polygon(corners); });
        add_cells(file, piece, "Strips", first, surface,
                  [&](std::span<const std::int64_t> corners) { surface.add_strip(corners); });
    }
}

} // namespace corticle::formats
