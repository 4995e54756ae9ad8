// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_reader.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/unit_of_length.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "formats/surfaces/surface_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <set>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

/// The corners of the triangles as positions, so that the order of vertices does not matter.
std::multiset<std::vector<double>> corner_positions(const TriangleMesh& mesh)
{
    std::multiset<std::vector<double>> result;
    for (const Triangle& t : mesh.triangles)
    {
        std::vector<double> corners;
        for (const std::int32_t corner : t)
        {
            const Vec3& v = mesh.vertices[static_cast<std::size_t>(corner)];
            corners.insert(corners.end(), {v.x, v.y, v.z});
        }
        result.insert(corners);
    }
    return result;
}

std::string refusal(const std::string& extension, const std::string& bytes)
{
    return message_of<InputError>([&] { formats::parse_surface(bytes, extension, "body." + extension); });
}

std::string vtp_of(vtkXMLPolyDataWriter* writer)
{
    vtkNew<vtkSphereSource> sphere;
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    writer->SetInputConnection(sphere->GetOutputPort());
    writer->SetWriteToOutputString(true);
    writer->Write();
    return writer->GetOutputString();
}

} // namespace

TEST(SurfaceReader, ReadsEveryFormatToTheSameBits)
{
    const TriangleMesh mesh = tetrahedron();
    for (const auto& [extension, bytes] : surface_samples(mesh))
    {
        const TriangleMesh read = formats::parse_surface(bytes, extension, "body");
        EXPECT_EQ(read.vertices.size(), 4u) << extension;
        EXPECT_EQ(corner_positions(read), corner_positions(mesh)) << extension << "\n" << bytes.substr(0, 60);
    }
}

TEST(SurfaceReader, ReadsEveryKindOfVtp)
{
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetDataModeToAscii();
    const auto expected = corner_positions(formats::parse_surface(vtp_of(writer), "vtp", "ascii"));
    EXPECT_EQ(expected.size(), 96u);
    for (const int mode : {vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    {
        for (const int encode : {0, 1})
        {
            for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4})
            {
                for (const int order : {vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian})
                {
                    vtkNew<vtkXMLPolyDataWriter> other;
                    other->SetDataMode(mode);
                    other->SetEncodeAppendedData(encode);
                    other->SetCompressorType(compressor);
                    other->SetByteOrder(order);
                    other->SetHeaderType(order == vtkXMLWriter::BigEndian ? vtkXMLWriter::UInt64
                                                                          : vtkXMLWriter::UInt32);
                    other->SetBlockSize(1024);
                    EXPECT_EQ(corner_positions(formats::parse_surface(vtp_of(other), "vtp", "other")), expected)
                        << mode << " " << encode << " " << compressor << " " << order;
                }
            }
        }
    }
}

TEST(SurfaceReader, FansPolygonsAndMergesVertices)
{
    const TriangleMesh mesh = formats::parse_surface(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nf -5 -4 -3 -2\nf 5 3 2\n", "obj", "quad.obj");
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST(SurfaceReader, ReadsFilesWithAnyCaseOfExtensionAndScales)
{
    const TemporaryFolder folder;
    put_bytes(folder / "body.STL", stl_binary(tetrahedron()));
    const TriangleMesh mesh = formats::read_surface(folder / "body.STL", {10.0});
    EXPECT_EQ(std::ranges::count(mesh.vertices, Vec3{0, 22.5, 0}), 1);
    EXPECT_EQ(formats::millimetres_per(formats::UnitOfLength::cm), 10.0);
}

TEST(SurfaceReader, KeepsTheVerticesOfTheFileForMaps)
{
    const TemporaryFolder folder;
    put_bytes(folder / "a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 2 3 4\nf 5 4 3\n");
    const TriangleMesh mesh = formats::read_surface_unmerged(folder / "a.obj", {2.0});
    EXPECT_EQ(mesh.vertices.size(), 5u);
    EXPECT_EQ(mesh.vertices[0], (Vec3{18, 18, 18}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{1, 2, 3}, {4, 3, 2}}));
    EXPECT_EQ(formats::read_surface(folder / "a.obj", {2.0}).vertices.size(), 3u);
}

TEST(SurfaceReader, RefusesWithOneLine)
{
    const TemporaryFolder folder;
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface(folder / "none.stl"); }),
                HasSubstr("none.stl: cannot be opened"));
    put_bytes(folder / "points.xyz", "0 0 0");
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface(folder / "points.xyz"); }),
                HasSubstr("got .xyz; expected .stl, .obj, .ply, .off, .vtp, .vtk, .gii, .asc or a FreeSurfer"));
    std::filesystem::create_directory(folder / "folder.stl");
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface(folder / "folder.stl"); }),
                HasSubstr("a directory"));
    EXPECT_THAT(refusal("obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"), HasSubstr("vertex 2 is not finite"));
    EXPECT_THAT(refusal("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
                HasSubstr("triangle 0 names no vertex; got index 3"));
    EXPECT_THAT(refusal("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), HasSubstr("0 triangles"));
    EXPECT_THAT(refusal("obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n"), HasSubstr("collapsed"));
    EXPECT_THAT(refusal("obj", "v 0 0 0\nf 1 2\n"), HasSubstr("2 corners"));
    EXPECT_THAT(refusal("off", "OFF\n999999999999 4 0\n"), HasSubstr("announces more than the file holds"));
    EXPECT_THAT(refusal("ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float "
                               "y\nproperty float z\nend_header\n"),
                HasSubstr("the end of the file"));
}

TEST(SurfaceReader, RefusesTruncatedAndForeignBytes)
{
    const TriangleMesh mesh = tetrahedron();
    for (const auto& [extension, bytes] : surface_samples(mesh))
    {
        for (const auto& cut : {bytes.substr(0, 0), bytes.substr(0, bytes.size() / 2), std::string(500, '\x80'),
                                std::string("\n\x1b[31m\n"), bytes + bytes})
        {
            // Twice the same STL, PLY, OFF or OBJ may pass for a file with something behind it.
            const std::string message = refusal(extension, cut);
            EXPECT_TRUE(cut.size() > bytes.size() || !message.empty() || extension == "obj")
                << extension << " of " << cut.size() << " bytes";
            EXPECT_EQ(message.find_first_of("\n\x1b"), std::string::npos) << message;
        }
    }
}

namespace
{

std::string with_every(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    {
        text.replace(at, from.size(), to);
    }
    return text;
}

} // namespace

TEST(SurfaceReader, ReadsTextWithAMarkOfByteOrderAndAnyEndOfLine)
{
    const TriangleMesh mesh = tetrahedron();
    for (const auto& [extension, text] : {std::pair<std::string, std::string>{"off", off_text(mesh)},
                                          {"obj", obj_text(mesh)},
                                          {"ply", ply_ascii(mesh)},
                                          {"stl", stl_ascii(mesh)}})
    {
        for (const char* end : {"\r", "\r\n"})
        {
            const TriangleMesh read =
                formats::parse_surface("\xef\xbb\xbf" + with_every(text, "\n", end), extension, "body." + extension);
            EXPECT_EQ(corner_positions(read), corner_positions(mesh)) << extension;
        }
    }
}

TEST(SurfaceReader, ReadsStlAsOthersWriteIt)
{
    const TriangleMesh mesh = tetrahedron();
    const std::string text = stl_ascii(mesh);
    std::string binary = stl_binary(mesh);
    binary.replace(0, 5, "solid");
    for (const std::string& bytes : {"  " + text, with_every(text, "endloop", "end loop"),
                                     with_every(text, "endsolid", "end solid"), binary, binary + std::string(2, '\0')})
    {
        EXPECT_EQ(corner_positions(formats::parse_surface(bytes, "stl", "body")), corner_positions(mesh));
    }
    EXPECT_THAT(refusal("stl", binary.substr(0, 100)), HasSubstr("truncated binary STL"));
}

TEST(SurfaceReader, ReadsVariantsOfOffAndPly)
{
    const std::string coloured =
        "CNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 1\n1 0 0 0 0 1 9 9 9 1\n0 1 0 0 0 1 9 9 9 1\n3 0 1 2\n";
    EXPECT_EQ(formats::parse_surface(coloured, "off", "body").vertices[1], (Vec3{1, 0, 0}));
    EXPECT_THAT(refusal("off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"), HasSubstr("got 4OFF"));
    const TriangleMesh strips = formats::parse_surface(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n",
        "ply", "body");
    EXPECT_EQ(strips.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST(SurfaceReader, ReadsStripsOfVtp)
{
    const std::string vtp =
        "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"5\" "
        "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"1\" NumberOfPolys=\"1\"><Points><DataArray "
        "type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 0 0 2 1</DataArray></Points>"
        "<Strips><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4</DataArray><DataArray "
        "type=\"Int64\" Name=\"offsets\" format=\"ascii\">5</DataArray></Strips><Polys><DataArray type=\"Int64\" "
        "Name=\"connectivity\" format=\"ascii\">0 2 4</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
        "format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";
    // The polygon 0 2 4, then of the strip 0 1 2, 2 1 3 and 2 3 4; vertices are numbered as they are used.
    EXPECT_EQ(formats::parse_surface(vtp, "vtp", "strips.vtp").triangles,
              (std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}, {1, 3, 4}, {1, 4, 2}}));
    std::string bad = vtp;
    bad.replace(bad.find("0 1 2 3 4"), 9, "0 1 2 3 9");
    EXPECT_THROW(formats::parse_surface(bad, "vtp", "strips.vtp"), InputError);
}

} // namespace corticle
