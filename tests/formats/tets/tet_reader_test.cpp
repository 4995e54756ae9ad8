// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/tets/tet_reader.hpp"

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/tets/tet_samples.hpp"
#include "formats/tets/tet_writers.hpp"
#include "geometry/simple_tets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::string refusal(const std::string& bytes)
{
    const std::string message = message_of<InputError>([&] { formats::parse_tets(bytes, "body"); });
    if (!message.empty())
    {
        EXPECT_THAT(message, StartsWith("body: "));
        EXPECT_THAT(message, Not(HasSubstr("\n")));
    }
    return message;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

const TetMesh mesh = two_tets();
const std::string netgen = netgen_text(mesh);
const std::string gmsh = gmsh_2(mesh, SampleText::Form::text);

TEST(TetReader, ReadsEveryFormatToTheSameBits)
{
    for (const auto& [kind, bytes] : tet_samples(mesh))
    {
        std::vector<std::string> notes;
        const TetMesh read = formats::parse_tets(bytes, kind, &notes);
        EXPECT_EQ(read.vertices, mesh.vertices) << kind;
        EXPECT_EQ(read.tets, mesh.tets) << kind;
        EXPECT_THAT(notes, IsEmpty()) << kind;
    }
}

TEST(TetReader, WhatIsWrittenComesBackToTheBit)
{
    const TemporaryFolder folder;
    TetMesh ball = test::tet_ball(6, 1.0 / 3.0);
    ball.vertices[0].x = 1e-300;
    write_tets_vtu(folder / "a.vtu", ball);
    write_tets_msh(folder / "a.msh", ball);
    for (const char* name : {"a.vtu", "a.msh"})
    {
        ASSERT_TRUE(formats::is_tet_file(folder / name));
        const TetMesh read = formats::read_tets(folder / name);
        EXPECT_EQ(read.vertices, ball.vertices) << name;
        EXPECT_EQ(read.tets, ball.tets) << name;
    }
}

TEST(TetReader, LargeFilesOfEqualCellsCompressAndComeBack)
{
    const TemporaryFolder folder;
    const TetMesh box = test::tet_box(20, {0, 0, 0}, {1, 1, 1});
    write_tets_vtu(folder / "a.vtu", box);
    EXPECT_EQ(formats::read_tets(folder / "a.vtu").tets, box.tets);
}

TEST(TetReader, ScalesToMillimetres)
{
    const TemporaryFolder folder;
    put_bytes(folder / "a.mesh", netgen);
    const TetMesh read = formats::read_tets(folder / "a.mesh", 10.0);
    EXPECT_EQ(read.vertices[1], (Vec3{15, 0, 0}));
    EXPECT_THROW(formats::read_tets(folder / "a.mesh", 1e308), InputError);
    EXPECT_THAT(message_of<InputError>([&] { formats::read_tets(folder / "none.mesh"); }),
                HasSubstr("cannot be opened"));
}

TEST(TetReader, KnowsItsFilesByExtension)
{
    EXPECT_TRUE(formats::is_tet_file("a/b.MSH"));
    EXPECT_TRUE(formats::is_tet_file("b.mesh"));
    EXPECT_FALSE(formats::is_tet_file("mesh"));
    EXPECT_FALSE(formats::is_tet_file("b.vtp"));
}

TEST(TetReader, SecondOrderTetsGiveTheirCorners)
{
    const std::string second = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
                               "5 .5 0 0\n6 .5 .5 0\n7 0 .5 0\n8 0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n$EndNodes\n"
                               "$Elements\n1\n1 11 0 1 2 3 4 5 6 7 8 9 10\n$EndElements\n";
    std::vector<std::string> notes;
    const TetMesh read = formats::parse_tets(second, "body", &notes);
    EXPECT_THAT(read.tets, ElementsAre(Tet{0, 1, 2, 3}));
    EXPECT_EQ(read.vertices.size(), 10u);
    EXPECT_THAT(notes, ElementsAre("1 tets of second or higher order: only their corners are used"));
    std::string medit =
        replaced(medit_text(mesh), "Tetrahedra\n2\n1 2 3 4 1\n2 3 4 5 1\n", "TetrahedraP2\n1\n1 2 3 4 5 5 5 5 5 5 1\n");
    EXPECT_THAT(formats::parse_tets(medit, "body", &notes).tets, ElementsAre(Tet{0, 1, 2, 3}));
    EXPECT_EQ(notes.size(), 2u);
}

TEST(TetReader, MeditTextInQuotesHoldsAnyWord)
{
    const std::string titled =
        replaced(medit_text(mesh), "Dimension\n3\n", "Dimension\n3\nIdentifier\n\"left brain, Tetrahedra of June\"\n");
    EXPECT_EQ(formats::parse_tets(titled, "body").tets, formats::parse_tets(medit_text(mesh), "body").tets);
}

TEST(TetReader, NetgenFilesMayLackTheSurface)
{
    const std::string bare = netgen.substr(0, netgen.find("2\n   1"));
    EXPECT_EQ(formats::parse_tets(bare, "body").tets, mesh.tets);
    EXPECT_THAT(refusal(netgen.substr(0, netgen.size() - 4)), HasSubstr("bad surface triangle at line 12"));
}

TEST(TetReader, RefusesSolidsThatAreNoTets)
{
    EXPECT_THAT(refusal(replaced(gmsh, "2 4 2 1 7 100 99 98 97", "2 5 2 1 7 100 99 98 97 96 96 96 96")),
                HasSubstr("an element that is no tet at line 20; got a hexahedron (type 5)"));
    EXPECT_THAT(refusal(replaced(vtu_ascii(mesh), "5 10 10", "5 12 10")), HasSubstr("VTK cell type 12"));
    EXPECT_THAT(refusal(replaced(medit_text(mesh), "Ridges\n1\n2\n", "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n")),
                HasSubstr("elements that are no tets"));
}

TEST(TetReader, RefusesOtherKindsAndVersions)
{
    EXPECT_THAT(refusal(""), HasSubstr("unknown kind of tet mesh; got an empty file"));
    EXPECT_THAT(refusal("solid cube\n"), HasSubstr("unknown kind of tet mesh; got solid"));
    EXPECT_THAT(refusal("$NOD\n1\n1 0 0 0\n$ENDNOD\n"), HasSubstr("$EndNOD"));
    EXPECT_THAT(refusal(replaced(gmsh, "2.2 0 8", "3.0 0 8")), HasSubstr("version 2, 4.0 or 4.1"));
    EXPECT_THAT(refusal(replaced(gmsh, "2.2 0 8", "2.2 7 8")), HasSubstr("bad $MeshFormat"));
    EXPECT_THAT(refusal(replaced(gmsh_2(mesh, SampleText::Form::little_endian), std::string("\1\0\0\0\n$End", 9),
                                 "abcd\n$End")),
                HasSubstr("unknown byte order"));
    EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n$EndParametricNodes\n"),
                HasSubstr("parametric nodes"));
    EXPECT_THAT(refusal(vtp_ascii(tetrahedron())), HasSubstr("expected VTKFile of type UnstructuredGrid"));
    EXPECT_THAT(refusal(replaced(medit_text(mesh), "Dimension\n3", "Dimension\n2")), HasSubstr("bad Dimension"));
}

TEST(TetReader, RefusesBadIndicesAndNumbers)
{
    EXPECT_THAT(refusal(replaced(netgen, "2 3 4 5", "2 3 4 6")),
                HasSubstr("tet 1 (counted from 0) names no node; got node 6"));
    EXPECT_THAT(refusal(replaced(netgen, "1 2 3 4", "0 2 3 4")), HasSubstr("got node 0"));
    EXPECT_THAT(refusal(replaced(gmsh, "\n99 1.5", "\n100 1.5")), HasSubstr("two nodes of one number; got 100"));
    EXPECT_THAT(refusal(replaced(gmsh, "98 0 2.25", "98 0 nan")), HasSubstr("node 98 is not finite"));
    EXPECT_THAT(refusal(replaced(gmsh, "98 0 2.25", "98 0 two")),
                HasSubstr("bad coordinate of a node at line 12; got two; expected a number"));
    EXPECT_THAT(refusal(replaced(vtu_ascii(mesh), "1 2 3 4 ", "1 2 3 -4 ")), HasSubstr("got node -1"));
}

TEST(TetReader, RefusesCountsThatTheFileCannotHold)
{
    EXPECT_THAT(refusal(replaced(netgen, "5\n", "99999999999\n")), HasSubstr("bad number of nodes at line 1"));
    EXPECT_THAT(refusal(replaced(gmsh, "$Nodes\n5", "$Nodes\n4000000000")), HasSubstr("bad number of nodes"));
    EXPECT_THAT(refusal(replaced(gmsh, "$Elements\n3", "$Elements\n-3")), HasSubstr("bad number of elements"));
    std::string binary = "$MeshFormat\n4.1 1 8\n" + std::string("\1\0\0\0", 4) + "\n$EndMeshFormat\n$Nodes\n";
    for (const std::uint64_t value : {std::uint64_t{1}, std::uint64_t{1} << 60, std::uint64_t{1}, std::uint64_t{1}})
    {
        append(binary, value);
    }
    EXPECT_THAT(refusal(binary + "$EndNodes\n"), HasSubstr("bad number of nodes at byte"));
}

TEST(TetReader, RefusesEveryTruncation)
{
    for (const auto& [kind, bytes] : tet_samples(mesh))
    {
        const std::size_t enough = kind == "netgen" ? bytes.find("2\n   1") : bytes.size() - 2;
        for (std::size_t size = 0; size < enough; size += 1 + size / 40)
        {
            std::string message =
                message_of<InputError>([&, &whole = bytes] { formats::parse_tets(whole.substr(0, size), "body"); });
            if (kind == "netgen" && message.empty())
            {
                continue; // the last digits of the last tet may be missing without a sign
            }
            EXPECT_THAT(message, StartsWith("body: ")) << kind << " cut to " << size;
        }
    }
}

TEST(TetReader, RefusesFilesWithoutTets)
{
    EXPECT_THAT(refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), HasSubstr("no tets in the file"));
    EXPECT_THAT(refusal(replaced(vtu_ascii(mesh), "5 10 10", "5 9 9")), HasSubstr("no tets in the file"));
}

} // namespace
} // namespace corticle
