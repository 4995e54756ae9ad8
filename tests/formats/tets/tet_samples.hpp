// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"
#include "formats/surfaces/surface_samples.hpp"

#include <fmt/format.h>

namespace corticle
{

/// Two tets whose coordinates take few decimals.
inline TetMesh two_tets()
{
    return {{{0, 0, 0}, {1.5, 0, 0}, {0, 2.25, 0}, {0, 0, 3}, {2, 2.5, 3}}, {{0, 1, 2, 3}, {1, 2, 3, 4}}};
}

/// Numbers as words or as bytes.
class SampleText
{
  public:
    enum class Form
    {
        text,
        little_endian,
        big_endian
    };

    explicit SampleText(Form form) : form_(form) {}

    bool is_text() const { return form_ == Form::text; }
    SampleText& put(std::string_view words)
    {
        bytes_ += words;
        return *this;
    }
    template <class Number>
    SampleText& number(Number value)
    {
        if (is_text())
        {
            bytes_ += fmt::format("{} ", value);
        }
        else
        {
            append(bytes_, value, form_ == Form::big_endian);
        }
        return *this;
    }
    SampleText& position(const Vec3& p) { return number(p.x).number(p.y).number(p.z); }
    /// Ends a line of text.
    SampleText& end_line() { return is_text() ? put("\n") : *this; }
    SampleText& header(const char* version, int size_bytes = 8)
    {
        put(fmt::format("$MeshFormat\n{} {} {}\n", version, is_text() ? 0 : 1, size_bytes));
        return is_text() ? put("$EndMeshFormat\n") : number(std::int32_t{1}).put("\n$EndMeshFormat\n");
    }
    const std::string& bytes() const { return bytes_; }

  private:
    Form form_;
    std::string bytes_;
};

/// Gmsh 2.2: numbers of nodes run down from 100; a triangle and a point are there too.
inline std::string gmsh_2(const TetMesh& mesh, SampleText::Form form)
{
    SampleText out(form);
    out.header("2.2").put("$PhysicalNames\n1\n3 1 \"body\"\n$EndPhysicalNames\n");
    out.put(fmt::format("$Nodes\n{}\n", mesh.vertices.size()));
    const auto tag = [](std::int64_t node) { return static_cast<std::int32_t>(100 - node); };
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    {
        out.number(tag(static_cast<std::int64_t>(v))).position(mesh.vertices[v]).end_line();
    }
    out.put("\n$EndNodes\n").put(fmt::format("$Elements\n{}\n", mesh.tets.size() + 1));
    const auto put_header = [&](std::int32_t type, std::size_t count)
    {
        if (!out.is_text())
        {
            out.number(type).number(static_cast<std::int32_t>(count)).number(std::int32_t{2});
        }
    };
    const auto put_element = [&](std::int32_t number, std::int32_t type, std::span<const std::int32_t> nodes)
    {
        out.number(number);
        if (out.is_text())
        {
            out.number(type).number(std::int32_t{2});
        }
        out.number(std::int32_t{1}).number(std::int32_t{7});
        for (const std::int32_t node : nodes)
        {
            out.number(tag(node));
        }
        out.end_line();
    };
    put_header(2, 1);
    put_element(1, 2, std::span(mesh.tets[0]).first(3));
    put_header(4, mesh.tets.size());
    for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    {
        put_element(static_cast<std::int32_t>(i + 2), 4, mesh.tets[i]);
    }
    return out.put("\n$EndElements\n").bytes();
}

/// Gmsh 4.0: nodes in two blocks, the first parametric; a line among the elements.
inline std::string gmsh_4_0(const TetMesh& mesh, SampleText::Form form)
{
    SampleText out(form);
    out.header("4").put("$Comments\nany text\n$EndComments\n$Nodes\n");
    const std::size_t nodes = mesh.vertices.size();
    out.number(std::uint64_t{2}).number(std::uint64_t{nodes}).end_line();
    for (std::size_t block = 0; block < 2; ++block)
    {
        const std::size_t begin = block == 0 ? 0 : 2;
        const std::size_t end = block == 0 ? 2 : nodes;
        const auto dimension = static_cast<std::int32_t>(block + 2);
        out.number(std::int32_t{1})
            .number(dimension)
            .number(std::int32_t{block == 0})
            .number(std::uint64_t{end - begin});
        out.end_line();
        for (std::size_t v = begin; v < end; ++v)
        {
            out.number(static_cast<std::int32_t>(3 * v + 1)).position(mesh.vertices[v]);
            if (block == 0)
            {
                out.number(0.25).number(0.75);
            }
            out.end_line();
        }
    }
    out.put("$EndNodes\n$Elements\n").number(std::uint64_t{2}).number(std::uint64_t{mesh.tets.size() + 1}).end_line();
    out.number(std::int32_t{1}).number(std::int32_t{1}).number(std::int32_t{1}).number(std::uint64_t{1}).end_line();
    out.number(std::int32_t{1}).number(std::int32_t{1}).number(std::int32_t{4}).end_line();
    out.number(std::int32_t{1}).number(std::int32_t{3}).number(std::int32_t{4});
    out.number(std::uint64_t{mesh.tets.size()}).end_line();
    for (const Tet& tet : mesh.tets)
    {
        out.number(std::int32_t{9});
        for (const std::int32_t node : tet)
        {
            out.number(3 * node + 1);
        }
        out.end_line();
    }
    return out.put("$EndElements\n").bytes();
}

/// Gmsh 4.1 with sizes of 8 or 4 bytes; an entity section is passed over; a triangle among the elements.
template <class Size>
std::string gmsh_4_1(const TetMesh& mesh, SampleText::Form form)
{
    SampleText out(form);
    const auto size = [](std::size_t value) { return static_cast<Size>(value); };
    out.header("4.1", sizeof(Size)).put("$Entities\n0 0 0 0\n$EndEntities\n$Nodes\n");
    const std::size_t nodes = mesh.vertices.size();
    out.number(size(2)).number(size(nodes)).number(size(1)).number(size(nodes)).end_line();
    for (std::size_t block = 0; block < 2; ++block)
    {
        const std::size_t begin = block == 0 ? 0 : 1;
        const std::size_t end = block == 0 ? 1 : nodes;
        out.number(static_cast<std::int32_t>(block + 1)).number(std::int32_t{1}).number(std::int32_t{block == 0});
        out.number(size(end - begin)).end_line();
        for (std::size_t v = begin; v < end; ++v)
        {
            out.number(size(v + 1)).end_line();
        }
        for (std::size_t v = begin; v < end; ++v)
        {
            out.position(mesh.vertices[v]);
            if (block == 0)
            {
                out.number(0.5);
            }
            out.end_line();
        }
    }
    out.put("$EndNodes\n$Elements\n").number(size(2)).number(size(mesh.tets.size() + 1)).number(size(1));
    out.number(size(99)).end_line();
    out.number(std::int32_t{2}).number(std::int32_t{1}).number(std::int32_t{2}).number(size(1)).end_line();
    out.number(size(1)).number(size(1)).number(size(2)).number(size(3)).end_line();
    out.number(std::int32_t{3})
        .number(std::int32_t{1})
        .number(std::int32_t{4})
        .number(size(mesh.tets.size()))
        .end_line();
    for (const Tet& tet : mesh.tets)
    {
        out.number(size(5));
        for (const std::int32_t node : tet)
        {
            out.number(size(static_cast<std::size_t>(node) + 1));
        }
        out.end_line();
    }
    return out.put("$EndElements\n").bytes();
}

inline std::string netgen_text(const TetMesh& mesh)
{
    std::string text = fmt::format("{}\n", mesh.vertices.size());
    for (const Vec3& p : mesh.vertices)
    {
        text += fmt::format("  {:.6f}  {:.6f}  {:.6f}\n", p.x, p.y, p.z);
    }
    text += fmt::format("{}\n", mesh.tets.size());
    for (const Tet& t : mesh.tets)
    {
        text += fmt::format("  1  {} {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
    }
    return text + "2\n   1   1 2 3\n   1   1 2 4\n";
}

inline std::string medit_text(const TetMesh& mesh)
{
    std::string text =
        fmt::format("# made by hand\nMeshVersionFormatted 2\nDimension\n3\n\nVertices {}\n", mesh.vertices.size());
    for (const Vec3& p : mesh.vertices)
    {
        text += fmt::format("{} {} {} 0\n", p.x, p.y, p.z);
    }
    text += fmt::format("# the skin\nTriangles\n1\n1 2 3 5\nTetrahedra\n{}\n", mesh.tets.size());
    for (const Tet& t : mesh.tets)
    {
        text += fmt::format("{} {} {} {} 1\n", t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
    }
    return text + "Ridges\n1\n2\nEnd\n";
}

/// Text, with a triangle among the cells.
inline std::string vtu_ascii(const TetMesh& mesh)
{
    std::string points;
    std::string nodes = "0 1 2 ";
    std::string offsets = "3 ";
    std::string types = "5 ";
    for (const Vec3& p : mesh.vertices)
    {
        points += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    }
    for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    {
        const Tet& t = mesh.tets[i];
        nodes += fmt::format("{} {} {} {} ", t[0], t[1], t[2], t[3]);
        offsets += fmt::format("{} ", 4 * i + 7);
        types += "10 ";
    }
    return fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
                       "NumberOfCells=\"{}\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
                       "format=\"ascii\">\n{}</DataArray>\n</Points>\n<Cells>\n"
                       "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">{}</DataArray>\n"
                       "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">{}</DataArray>\n"
                       "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">{}</DataArray>\n"
                       "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
                       mesh.vertices.size(), mesh.tets.size() + 1, points, nodes, offsets, types);
}

/// A sample of each format that needs no library: (what it is, bytes).
inline std::vector<std::pair<std::string, std::string>> tet_samples(const TetMesh& mesh)
{
    std::vector<std::pair<std::string, std::string>> samples{
        {"netgen", netgen_text(mesh)}, {"medit", medit_text(mesh)}, {"vtu", vtu_ascii(mesh)}};
    using Form = SampleText::Form;
    for (const Form form : {Form::text, Form::little_endian, Form::big_endian})
    {
        const std::string kind = form == Form::text ? "text" : (form == Form::big_endian ? "big" : "little");
        samples.emplace_back("gmsh 2 " + kind, gmsh_2(mesh, form));
        samples.emplace_back("gmsh 4.0 " + kind, gmsh_4_0(mesh, form));
        samples.emplace_back("gmsh 4.1 " + kind, gmsh_4_1<std::uint64_t>(mesh, form));
        samples.emplace_back("gmsh 4.1 of 32 bits " + kind, gmsh_4_1<std::uint32_t>(mesh, form));
    }
    return samples;
}

} // namespace corticle
