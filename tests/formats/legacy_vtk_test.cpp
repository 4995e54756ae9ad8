// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/legacy_vtk.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/tets/tet_reader.hpp"
#include "formats/legacy_vtk_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

std::string refusal(const std::string& bytes)
{
    const std::string message = message_of<InputError>([&] { formats::parse_legacy_vtk(bytes, "a.vtk"); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
}

} // namespace

TEST(LegacyVtk, ReadsWhatVtkWrites)
{
    for (const LegacyVtkStyle& style : legacy_vtk_styles())
    {
        const TriangleMesh mesh = formats::parse_surface(legacy_vtk_surface(tetrahedron(), style), "vtk", "a.vtk");
        EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
        EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
        const TetMesh tets = formats::parse_tets(legacy_vtk_tets(two_tets(), style), "t.vtk");
        EXPECT_EQ(tets.vertices, two_tets().vertices);
        EXPECT_EQ(tets.tets, two_tets().tets);
    }
}

TEST(LegacyVtk, TellsTetsFromSurfaces)
{
    const TemporaryFolder folder;
    put_bytes(folder / "surface.vtk", legacy_vtk_surface(tetrahedron(), {}));
    put_bytes(folder / "tets.VTK", legacy_vtk_tets(two_tets(), {}));
    const std::string grid =
        "# vtk DataFile Version 3.0\nby meshio\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
        "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
        "CELL_TYPES 4\n5\n5\n5\n5\nCELL_DATA 4\nSCALARS a double 1\n";
    put_bytes(folder / "grid.vtk", grid);
    EXPECT_FALSE(formats::is_tet_file(folder / "surface.vtk"));
    EXPECT_TRUE(formats::is_tet_file(folder / "tets.VTK"));
    EXPECT_FALSE(formats::is_tet_file(folder / "grid.vtk"));
    EXPECT_EQ(formats::read_surface(folder / "grid.vtk").triangles.size(), 4u);
}

TEST(LegacyVtk, ReadsStripsFieldsAndMetadata)
{
    const std::string text =
        "# vtk DataFile Version 4.2\nstrips\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\ntime 1 2 double\n0.5 1\n"
        "METADATA\nINFORMATION 0\n\nPOINTS 5 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 2 1\nVERTICES 1 2\n1 0\n"
        "TRIANGLE_STRIPS 1 6\n5 0 1 2 3 4\n";
    const TriangleMesh mesh = formats::parse_surface(text, "vtk", "a.vtk");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST(LegacyVtk, RefusesDamage)
{
    for (const LegacyVtkStyle& style : legacy_vtk_styles())
    {
        const std::string good = legacy_vtk_surface(tetrahedron(), style);
        for (std::size_t size = 0; size + 4 < good.size(); ++size)
        {
            EXPECT_THROW(formats::parse_surface(good.substr(0, size), "vtk", "cut.vtk"), InputError) << size;
        }
    }
    const std::string head = "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\n";
    EXPECT_THAT(refusal(head + "POINTS 99999999999 float\n0 0 0\n"), HasSubstr("bad number of points"));
    EXPECT_THAT(refusal(head + "POINTS -1 float\n0 0 0\n"), HasSubstr("bad number of points; got -1"));
    EXPECT_THAT(refusal(head + "POINTS 1 quaternion\n0 0 0\n"), HasSubstr("got quaternion"));
    EXPECT_THAT(refusal(head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n3 0 0 1\n"),
                HasSubstr("a cell names no point; got index 1; expected 0 to 0"));
    EXPECT_THAT(refusal(head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n5 0 0 0\n"), HasSubstr("is damaged"));
    EXPECT_THAT(refusal("# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\n"),
                HasSubstr("got structured_points; expected POLYDATA or UNSTRUCTURED_GRID"));
}

} // namespace corticle
