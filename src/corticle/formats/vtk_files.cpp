// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/vtk_files.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/checksum.hpp"
#include "corticle/formats/quiet_vtk.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cassert>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

namespace corticle::formats
{

namespace
{

vtkNew<vtkPoints> points_of(std::span<const Vec3> positions)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        points->SetPoint(static_cast<vtkIdType>(i), positions[i].x, positions[i].y, positions[i].z);
    }
    return points;
}

/// Adds the fields as arrays that refer to the caller's values.
void add_fields(vtkPointData* data, std::span<const Field> fields, [[maybe_unused]] std::size_t points)
{
    for (const Field& field : fields)
    {
        assert(field.values.size() == points * static_cast<std::size_t>(field.components));
        vtkNew<vtkDoubleArray> array;
        array->SetName(escape_xml(field.name).c_str()); // VTK writes names as they are
        array->SetNumberOfComponents(field.components);
        constexpr int keep = 1; // the values stay the caller's; the writer only reads them
        array->SetArray(const_cast<double*>(field.values.data()), static_cast<vtkIdType>(field.values.size()), keep);
        data->AddArray(array);
    }
}

/// Whether the last tag of a file VTK wrote is there: it does not see when the end of a file no longer fits on the
/// disk.
bool is_complete(const std::filesystem::path& file)
{
    constexpr std::string_view last = "</VTKFile>\n";
    std::ifstream stream(file, std::ios::binary);
    std::string end(last.size(), ' ');
    stream.seekg(-static_cast<std::streamoff>(last.size()), std::ios::end);
    stream.read(end.data(), static_cast<std::streamsize>(end.size()));
    return stream && end == last;
}

template <class Writer>
void write(const std::filesystem::path& file, vtkDataObject* data)
{
    vtkNew<Writer> writer;
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone(); // doubles hardly compress: a seventh smaller, for ten times the time
    writer->SetHeaderTypeToUInt64();
    write_atomically(file,
                     [&](const std::filesystem::path& temporary)
                     {
                         silence_vtk();
                         writer->SetFileName(temporary.c_str());
                         errno = 0;
                         const bool written = writer->Write() == 1 && is_complete(temporary);
                         const int reason = errno;
                         if (!written)
                         {
                             throw RunError(fmt::format("cannot write {}: {}", file.string(),
                                                        reason != 0 ? std::generic_category().message(reason)
                                                                    : "VTK left it incomplete"));
                         }
                         append_checksum(temporary, file.string());
                     });
}

/// Cells of `corners_per_cell` points each; `corner(i)` is the i-th corner of all.
template <class Corner>
vtkNew<vtkCellArray> cells_of(std::size_t count, int corners_per_cell, Corner&& corner)
{
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> corners;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(count) + 1);
    corners->SetNumberOfValues(static_cast<vtkIdType>(count) * corners_per_cell);
    for (vtkIdType cell = 0; cell <= static_cast<vtkIdType>(count); ++cell)
    {
        offsets->SetValue(cell, cell * corners_per_cell);
    }
    for (vtkIdType i = 0; i < corners->GetNumberOfValues(); ++i)
    {
        corners->SetValue(i, corner(i));
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, corners);
    return cells;
}

} // namespace

void write_surface_vtp(const std::filesystem::path& file, std::span<const Vec3> points,
                       std::span<const Triangle> triangles, std::span<const Field> point_fields)
{
    const auto cells = cells_of(
        triangles.size(), 3,
        [&](vtkIdType i) { return triangles[static_cast<std::size_t>(i / 3)][static_cast<std::size_t>(i % 3)]; });
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points_of(points));
    surface->SetPolys(cells);
    add_fields(surface->GetPointData(), point_fields, points.size());
    write<vtkXMLPolyDataWriter>(file, surface);
}

void write_particles_vtu(const std::filesystem::path& file, std::span<const Vec3> points,
                         std::span<const std::int32_t> ids, std::span<const Field> point_fields)
{
    assert(ids.size() == points.size());
    vtkNew<vtkUnstructuredGrid> particles;
    particles->SetPoints(points_of(points));
    particles->SetCells(VTK_VERTEX, cells_of(points.size(), 1, [](vtkIdType i) { return i; }));
    vtkNew<vtkIntArray> id;
    id->SetName("id");
    constexpr int keep = 1;
    id->SetArray(const_cast<std::int32_t*>(ids.data()), static_cast<vtkIdType>(ids.size()), keep);
    particles->GetPointData()->AddArray(id);
    add_fields(particles->GetPointData(), point_fields, points.size());
    write<vtkXMLUnstructuredGridWriter>(file, particles);
}

void write_pvd(const std::filesystem::path& file, std::span<const std::pair<double, std::string>> frames)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n  <Collection>\n";
    for (const auto& [time, name] : frames)
    {
        text +=
            fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, escape_xml(name));
    }
    text += "  </Collection>\n</VTKFile>\n";
    write_text_atomically(file, text + checksum_line(text));
}

} // namespace corticle::formats
