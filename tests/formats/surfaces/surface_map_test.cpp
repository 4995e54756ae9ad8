// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_map.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/gifti.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "formats/gifti_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

const std::vector<double> values{0.5, -1.25, 3.0, 8.0};

std::vector<double> parsed(const std::string& extension, const std::string& bytes, const std::string& array = "")
{
    return formats::parse_surface_map(bytes, extension, "map." + extension, array, 4);
}

std::string refusal(const std::string& extension, const std::string& bytes, const std::string& array = "")
{
    return message_of<InputError>([&] { parsed(extension, bytes, array); });
}

} // namespace

TEST(SurfaceMap, ReadsGiftiByNameOrNumber)
{
    for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    {
        const std::string bytes = gifti_scalars({encoding, true}, values);
        for (const char* array : {"depth", "0", "1"})
        {
            EXPECT_EQ(parsed("gii", bytes, array), values) << encoding << " " << array;
        }
        EXPECT_THAT(refusal("gii", bytes), HasSubstr("2 arrays; expected one of depth, 1"));
        EXPECT_THAT(refusal("gii", bytes, "thickness"), HasSubstr("got thickness; expected one of depth, 1"));
    }
    const std::string surface = gifti_surface(tetrahedron(), {});
    EXPECT_THAT(refusal("gii", surface), HasSubstr("a scalar for each vertex"));
}

TEST(SurfaceMap, ReadsVtpArrays)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    const std::vector<double> vectors(12, 1.0);
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles,
                               std::vector<formats::Field>{{"m", 1, values}, {"H", 1, values}, {"u", 3, vectors}});
    EXPECT_EQ(formats::read_surface_map(folder / "a.vtp", "H", 4), values);
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface_map(folder / "a.vtp", "u", 4); }),
                HasSubstr("one of m, H"));
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface_map(folder / "a.vtp", "m", 5); }),
                HasSubstr("got 4 values; expected 5"));
}

TEST(SurfaceMap, ReadsFreesurferScalars)
{
    const TemporaryFolder folder;
    put_bytes(folder / "lh.thickness", freesurfer_scalars(values));
    EXPECT_EQ(formats::read_surface_map(folder / "lh.thickness", "", 4), values);
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface_map(folder / "lh.thickness", "", 3); }),
                HasSubstr("got 4 values; expected 3"));
}

TEST(SurfaceMap, ReadsTextAndTables)
{
    EXPECT_EQ(parsed("txt", "0.5\n-1.25\n3\n8"), values);
    EXPECT_EQ(parsed("txt", "# m\r\n0.5\r\n-1.25\r\n\r\n3\r\n8\r\n"), values);
    EXPECT_EQ(parsed("csv", "growth\n0.5\n-1.25\n3\n8\n"), values);
    EXPECT_EQ(parsed("csv", "id,\"m of x\",H\n1,0.5,2\n2,-1.25,2\n3, 3 ,2\n4,8,2\n", "m of x"), values);
    EXPECT_EQ(parsed("csv", "id;m\n1;0.5\n2;-1.25\n3;3\n4;8\n", "m"), values);
    EXPECT_EQ(parsed("csv", "1 0.5\n2 -1.25\n3 3\n4 8\n", "1"), values);
    EXPECT_THAT(refusal("csv", "id,m\n1,2\n"), HasSubstr("2 arrays; expected one of id, m"));
    EXPECT_THAT(refusal("csv", "id,m\n1,2\n", "H"), HasSubstr("no such array; got H; expected one of id, m"));
    EXPECT_THAT(refusal("csv", "id,m\n1,2\n2\n", "m"), HasSubstr("line 3: wrong number of cells; got 1; expected 2"));
    EXPECT_THAT(refusal("txt", "1\n2\nthree\n4\n"), HasSubstr("line 3"));
    EXPECT_THAT(refusal("txt", "\n#\n"), HasSubstr("no map in the file"));
}

TEST(SurfaceMap, ReadsDecimalCommas)
{
    EXPECT_EQ(parsed("csv", "vertex;m\n0;0,5\n1;-1,25\n2;3\n3;8,0\n", "m"), values);
    EXPECT_EQ(parsed("csv", "vertex\tm\n1\t0,5\n2\t-1,25\n3\t3\n4\t8\n", "m"), values);
    EXPECT_EQ(parsed("csv", "\xef\xbb\xbfm;\"n;o\"\n\"0,5\";1\n-1,25;1\n3;1\n8;1\n", "m"), values);
    EXPECT_THAT(refusal("csv", "a;m\n1;0,5\n2;1.5\n3;3\n4;8\n", "m"),
                HasSubstr("both decimal commas and decimal points; got a comma in line 2, a point in line 3"));
    EXPECT_THAT(refusal("csv", "a;m\n1;1.000,5\n2;1\n3;3\n4;8\n", "m"), HasSubstr("got 1.000,5"));
}

TEST(SurfaceMap, RefusesRowsOfAnotherLength)
{
    EXPECT_THAT(refusal("csv", "m\n0,5\n1,25\n3\n8\n"), HasSubstr("line 2: wrong number of cells; got 2; expected 1"));
    EXPECT_THAT(refusal("csv", "a,m\n1,0,5\n", "m"), HasSubstr("line 2: wrong number of cells; got 3; expected 2"));
    EXPECT_THAT(refusal("csv", "a,m\n1,2\n1,2,\n", "m"), HasSubstr("line 3: wrong number of cells; got 3; expected 2"));
    EXPECT_THAT(refusal("txt", "1 2\n3\n", "0"), HasSubstr("line 2: wrong number of cells; got 1; expected 2"));
    EXPECT_THAT(refusal("csv", "a;m\n1;2\n1,2\n", "m"), HasSubstr("line 3: wrong number of cells; got 1; expected 2"));
    EXPECT_THAT(refusal("csv", "m\n\"1\n", "m"), HasSubstr("line 2: a quote that does not close"));
}

TEST(SurfaceMap, RefusesVerticesInAnotherOrder)
{
    EXPECT_EQ(parsed("csv", "vertex,m\n1,0.5\n2,-1.25\n3,3\n4,8\n", "m"), values);
    EXPECT_THAT(refusal("csv", "vertex,m\n0,0.5\n2,-1.25\n1,3\n3,8\n", "m"),
                HasSubstr("line 3: values are not in the order of the vertices; got vertex 2; expected vertex 1"));
}

TEST(SurfaceMap, RefusesWrongLengthsAndWhatIsNoNumber)
{
    EXPECT_THAT(refusal("txt", "1\n2\n3\n"), HasSubstr("map.txt: a map of the wrong length; got 3 values; expected 4"));
    EXPECT_THAT(refusal("txt", "1\n2\nnan\n4\n"), HasSubstr("the value of vertex 2 is not finite"));
    EXPECT_THAT(refusal("gii", gifti_scalars({"Base64Binary"}, {1, 2, 3, std::nan("")}), "depth"),
                HasSubstr("vertex 3 is not finite"));
    EXPECT_THAT(refusal("xyz", "abc"), HasSubstr("unknown kind of surface map; got .xyz"));
    EXPECT_THAT(refusal("", ""), HasSubstr("no extension"));
}

} // namespace corticle
