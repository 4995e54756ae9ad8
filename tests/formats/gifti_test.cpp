// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/gifti.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/companion_files.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "formats/gifti_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(const std::string& bytes)
{
    return message_of<InputError>([&] { formats::parse_surface(bytes, "gii", "body.surf.gii"); });
}

std::string transform(const std::string& from, const std::string& to, const std::string& matrix)
{
    return "<CoordinateSystemTransformMatrix>\n<DataSpace><![CDATA[" + from +
           "]]></DataSpace>\n<TransformedSpace><![CDATA[" + to + "]]></TransformedSpace>\n<MatrixData>" + matrix +
           "</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
}

TriangleMesh read_with(const std::string& about_points)
{
    return formats::parse_surface(gifti_surface(tetrahedron(), {}, about_points), "gii", "body");
}

/// `text` with its first `from` replaced.
std::string changed(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(Gifti, ReadsEveryStorageToTheSameNumbers)
{
    for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    {
        for (const bool big_endian : {false, true})
        {
            for (const bool by_columns : {false, true})
            {
                for (const char* type : {"NIFTI_TYPE_FLOAT32", "NIFTI_TYPE_FLOAT64"})
                {
                    const GiftiStyle style{encoding, big_endian, by_columns, type};
                    const TriangleMesh mesh =
                        formats::parse_surface(gifti_surface(tetrahedron(), style), "gii", "body");
                    EXPECT_EQ(mesh.vertices, tetrahedron().vertices) << encoding << big_endian << by_columns << type;
                    EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
                }
            }
        }
    }
}

TEST(Gifti, BringsCoordinatesToScannerSpace)
{
    const std::string matrix = "0 -1 0 10 1 0 0 20 0 0 1 30 0 0 0 1";
    const TriangleMesh plain = tetrahedron();
    const Vec3& p = plain.vertices[1];
    const Vec3 expected{10.0 - p.y, 20.0 + p.x, 30.0 + p.z};
    EXPECT_EQ(read_with(transform("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_SCANNER_ANAT", matrix)).vertices[1], expected);
    // Already there; and nothing that leads there.
    EXPECT_EQ(read_with(transform("NIFTI_XFORM_SCANNER_ANAT", "NIFTI_XFORM_TALAIRACH", matrix)).vertices[1], p);
    EXPECT_EQ(read_with(transform("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_TALAIRACH", matrix)).vertices[1], p);
    // FreeSurfer's volume geometry, unless the coordinates are scanner's.
    const std::string centre = gifti_metadata({{"VolGeomC_R", "1"}, {"VolGeomC_A", "2"}, {"VolGeomC_S", "3"}});
    EXPECT_EQ(read_with(centre).vertices[1], (p + Vec3{1, 2, 3}));
    EXPECT_EQ(read_with(centre + transform("NIFTI_XFORM_SCANNER_ANAT", "NIFTI_XFORM_SCANNER_ANAT", matrix)).vertices[1],
              p);
}

TEST(Gifti, KeepsNormalsOutwardUnderAMirror)
{
    const TriangleMesh mesh = read_with(transform("A", "NIFTI_XFORM_SCANNER_ANAT", "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"));
    const TriangleMesh plain = tetrahedron();
    EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), enclosed_volume(plain.vertices, plain.triangles),
                1e-12);
}

TEST(Gifti, ReadsBackTheSurfaceItWrites)
{
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[3].z = -1.0 / 3.0;
    formats::write_surface_gifti(folder / "a.surf.gii", mesh.vertices, mesh.triangles, "CortexLeft");
    const TriangleMesh read = formats::read_surface(folder / "a.surf.gii");
    mesh.vertices[3].z = static_cast<double>(static_cast<float>(-1.0 / 3.0));
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
    const formats::GiftiFile file = formats::parse_gifti(bytes_of(folder / "a.surf.gii"), "a");
    EXPECT_EQ(file.metadata.at("AnatomicalStructurePrimary"), "CortexLeft");
    EXPECT_EQ(file.arrays.at(0).metadata.at("AnatomicalStructurePrimary"), "CortexLeft");
    EXPECT_EQ(file.arrays.at(0).transforms.at(0).data_space, "NIFTI_XFORM_SCANNER_ANAT");
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(Gifti, ReadsBackTheScalarsItWrites)
{
    const TemporaryFolder folder;
    const std::vector<double> growth{1.0, 1.5, -2.25, 1e-3};
    const std::vector<double> depth{0.0, 0.0, 0.0, 7.0};
    formats::write_scalars_gifti(folder / "a.shape.gii",
                                 std::vector<formats::Field>{{"growth", 1, growth}, {"a < \"b\"", 1, depth}});
    const formats::GiftiFile file = formats::parse_gifti(bytes_of(folder / "a.shape.gii"), "a");
    ASSERT_EQ(file.arrays.size(), 2u);
    EXPECT_EQ(file.arrays[0].metadata.at("Name"), "growth");
    EXPECT_EQ(file.arrays[1].metadata.at("Name"), "a < \"b\"");
    EXPECT_THAT(file.arrays[0].values, ElementsAre(1.0, 1.5, -2.25, static_cast<double>(1e-3f)));
    EXPECT_EQ(file.arrays[1].values, depth);
    EXPECT_EQ(file.arrays[1].intent, "NIFTI_INTENT_SHAPE");
}

TEST(Gifti, RefusesWithOneLine)
{
    const std::string good = gifti_surface(tetrahedron(), {"Base64Binary"});
    EXPECT_EQ(refusal(good), "");
    EXPECT_THAT(refusal(changed(good, "Base64Binary", "ExternalFileBinary")),
                HasSubstr("lies in another file; got no ExternalFileName"));
    EXPECT_THAT(refusal(changed(good, "Base64Binary", "Base32")), HasSubstr("unknown Encoding"));
    EXPECT_THAT(refusal(changed(good, "FLOAT32", "COMPLEX64")), HasSubstr("NIFTI_TYPE_COMPLEX64"));
    EXPECT_THAT(refusal(changed(good, "Dim0=\"4\"", "Dim0=\"5\"")), HasSubstr("truncated or damaged DataArray 0"));
    EXPECT_THAT(refusal(changed(good, "Dim0=\"4\"", "Dim0=\"4000000000000000000\"")),
                HasSubstr("larger than the file can hold"));
    EXPECT_THAT(refusal(changed(good, "Dim1=\"3\"", "Dim1=\"2\"")), HasSubstr("4 x 2"));
    EXPECT_THAT(refusal(changed(good, "INTENT_TRIANGLE", "INTENT_NONE")),
                HasSubstr("0 arrays of intent NIFTI_INTENT_TRIANGLE"));
    EXPECT_THAT(refusal(changed(good, "<GIFTI", "<VTKFile")), HasSubstr("not a GIFTI file"));
    EXPECT_THAT(refusal(good.substr(0, good.size() - 9)), HasSubstr("truncated"));
    EXPECT_THAT(refusal(""), HasSubstr("no GIFTI"));
    const std::string packed = gifti_surface(tetrahedron(), {"GZipBase64Binary"});
    EXPECT_THAT(refusal(changed(packed, "<Data>eJ", "<Data>eK")), HasSubstr("damaged DataArray 0"));
    const std::string singular = transform("A", "NIFTI_XFORM_SCANNER_ANAT", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1");
    EXPECT_THAT(refusal(gifti_surface(tetrahedron(), {}, singular)), HasSubstr("bad matrix"));
    TriangleMesh wild = tetrahedron();
    wild.triangles[2][1] = 7;
    EXPECT_THAT(refusal(gifti_surface(wild, {})), HasSubstr("triangle 2 names no vertex"));
}

TEST(Gifti, SaysWhatMovedThePointsAndCanLeaveThemAlone)
{
    const std::string centre = gifti_metadata({{"VolGeomC_R", "5"}, {"VolGeomC_A", "-18"}, {"VolGeomC_S", "20"}});
    const Vec3 p = tetrahedron().vertices[1];
    std::vector<std::string> notes;
    const auto read = [&](const std::string& about_points, formats::Coordinates coordinates)
    {
        notes.clear();
        return formats::parse_surface(gifti_surface(tetrahedron(), {}, about_points), "gii", "body",
                                      {1.0, coordinates, &notes})
            .vertices[1];
    };
    EXPECT_EQ(read(centre, formats::Coordinates::scanner), (p + Vec3{5, -18, 20}));
    EXPECT_THAT(notes, ElementsAre(HasSubstr("moved by (5, -18, 20) mm by the volume geometry")));
    EXPECT_EQ(read(centre, formats::Coordinates::file), p);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("taken as they are, since coordinates = file")));
    EXPECT_EQ(read("", formats::Coordinates::scanner), p);
    EXPECT_TRUE(notes.empty());
    // In a space that the file names, other than that of the volume geometry.
    const std::string identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
    const std::string named = transform("NIFTI_XFORM_MNI_152", "NIFTI_XFORM_TALAIRACH", identity);
    EXPECT_EQ(read(centre + named, formats::Coordinates::scanner), p);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("points are in NIFTI_XFORM_MNI_152")));
    const std::string turned = "0 -1 0 10 1 0 0 20 0 0 1 30 0 0 0 1";
    read(transform("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_SCANNER_ANAT", turned), formats::Coordinates::scanner);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("mapped by the matrix (0 -1 0; 1 0 0; 0 0 1) and moved by (10, 20, 30)")));
}

TEST(Gifti, ReadsTrianglesOfEveryWholeType)
{
    const std::string good = gifti_surface(tetrahedron(), {"ASCII"});
    for (const char* type : {"INT8", "UINT8", "INT16", "UINT16", "UINT32", "INT64", "UINT64"})
    {
        const std::string bytes = changed(good, "NIFTI_TYPE_INT32", std::string("NIFTI_TYPE_") + type);
        EXPECT_EQ(formats::parse_surface(bytes, "gii", "body").triangles, tetrahedron().triangles) << type;
    }
    // One number of 64 bits, 258, in base64.
    const std::string one = "<GIFTI><DataArray Intent=\"NIFTI_INTENT_SHAPE\" DataType=\"NIFTI_TYPE_INT64\" "
                            "Dimensionality=\"1\" Dim0=\"1\" Encoding=\"Base64Binary\" Endian=\"LittleEndian\">"
                            "<Data>AgEAAAAAAAA=</Data></DataArray></GIFTI>";
    EXPECT_THAT(formats::parse_gifti(one, "a").arrays.at(0).values, ElementsAre(258.0));
}

/// An array inside an element that is no GIFTI is none: its matrix has nothing to belong to.
TEST(Gifti, RefusesAnArrayInAnElementThatDoesNotClose)
{
    const std::string matrix =
        "<CoordinateSystemTransformMatrix><DataSpace></DataSpace></CoordinateSystemTransformMatrix>";
    const std::string good = gifti_surface(tetrahedron(), {}, matrix);
    EXPECT_TRUE(refusal(good).find("malformed XML") == std::string::npos);
    EXPECT_THAT(refusal(changed(good, "<LabelTable/>", "<LabelT>ble/>")), HasSubstr("malformed XML"));
}

TEST(Gifti, ReadsNumbersInAFileOfTheirOwn)
{
    const TemporaryFolder folder;
    const auto array = [](const std::string& name, std::size_t offset)
    {
        return gifti_file("<DataArray Intent=\"NIFTI_INTENT_SHAPE\" DataType=\"NIFTI_TYPE_INT16\" "
                          "ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"1\" Dim0=\"4\" "
                          "Encoding=\"ExternalFileBinary\" Endian=\"BigEndian\" ExternalFileName=\"" +
                          name + "\" ExternalFileOffset=\"" + std::to_string(offset) +
                          "\"><Data></Data></DataArray>\n");
    };
    std::string numbers(3, 'x');
    for (const std::int16_t number : {1, -2, 3, 400})
    {
        append(numbers, number, true);
    }
    put_bytes(folder / "a.dat", numbers);
    const std::string name = folder / "a.gii";
    EXPECT_THAT(formats::parse_gifti(array("a.dat", 3), name).arrays.at(0).values,
                ::testing::ElementsAre(1, -2, 3, 400));
    const auto refused = [&](const std::string& bytes)
    { return message_of<InputError>([&] { formats::parse_gifti(bytes, name); }); };
    EXPECT_THAT(refused(array("a.dat", 4)), HasSubstr("is longer than a.dat; got 8 bytes from byte 4 on"));
    EXPECT_THAT(refused(array("none.dat", 0)), HasSubstr("none.dat: cannot be opened"));
    EXPECT_THAT(refused(array("../a.dat", 0)), HasSubstr("expected the name of a file in the folder of this one"));
    EXPECT_THAT(refused(array("/dev/zero", 0)), HasSubstr("expected the name of a file in the folder of this one"));
    put_bytes(name, array("a.dat", 3));
    const std::string sum = formats::sha256_with_companions(name);
    put_bytes(folder / "a.dat", numbers + "y");
    EXPECT_NE(formats::sha256_with_companions(name), sum);
}

} // namespace corticle
