// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <fmt/format.h>

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace corticle
{

/// Writes a tet mesh as Gmsh .msh 4.1 (text, one volume); read_tets reads it back to the bit.
inline void write_tets_msh(const std::filesystem::path& file, const TetMesh& mesh)
{
    const std::size_t nodes = mesh.vertices.size();
    const std::size_t tets = mesh.tets.size();
    std::string text = fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                                   "$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n",
                                   nodes);
    const auto out = std::back_inserter(text);
    for (std::size_t i = 1; i <= nodes; ++i)
    {
        fmt::format_to(out, "{}\n", i);
    }
    for (const Vec3& p : mesh.vertices)
    {
        fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z); // the fewest digits that give the same bits
    }
    fmt::format_to(out, "$EndNodes\n$Elements\n1 {0} 1 {0}\n3 1 4 {0}\n", tets);
    for (std::size_t i = 0; i < tets; ++i)
    {
        const Tet& t = mesh.tets[i];
        fmt::format_to(out, "{} {} {} {} {}\n", i + 1, t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
    }
    std::ofstream(file) << text << "$EndElements\n";
}

/// Writes a tet mesh as VTK does: appended, neither encoded nor compressed.
inline void write_tets_vtu(const std::filesystem::path& file, const TetMesh& mesh)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : mesh.vertices)
    {
        points->InsertNextPoint(p.x, p.y, p.z);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    for (const Tet& tet : mesh.tets)
    {
        const vtkIdType corners[4] = {tet[0], tet[1], tet[2], tet[3]};
        grid->InsertNextCell(VTK_TETRA, 4, corners);
    }
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone();
    writer->SetFileName(file.c_str());
    writer->Write();
}

} // namespace corticle
