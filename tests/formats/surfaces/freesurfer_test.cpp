// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/freesurfer.hpp"

#include "corticle/base/error.hpp"
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
    return message_of<InputError>([&] { formats::parse_surface(bytes, "white", "lh.white"); });
}

Vec3 second_vertex(const std::string& tags)
{
    return formats::parse_surface(freesurfer_surface(tetrahedron(), tags), "pial", "lh.pial").vertices[1];
}

} // namespace

TEST(Freesurfer, ReadsTrianglesWhateverTheFileIsCalled)
{
    const TemporaryFolder folder;
    for (const char* name : {"lh.white", "pial", "lh.pial.T1"})
    {
        put_bytes(folder / name, freesurfer_surface(tetrahedron()));
        const TriangleMesh mesh = formats::read_surface(folder / name);
        EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
        EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
    }
}

TEST(Freesurfer, BringsSurfaceCoordinatesToTheScanner)
{
    const Vec3 p = tetrahedron().vertices[1];
    EXPECT_EQ(second_vertex(volume_geometry("1", conformed_axes(), "5 -6 7.5")), (p + Vec3{5, -6, 7.5}));
    EXPECT_EQ(second_vertex(volume_geometry("0", conformed_axes(), "5 -6 7.5")), p);
    // A volume turned by 90 degrees about the axis from left to right.
    const std::string turned = "xras = -1 0 0\nyras = 0 -1 0\nzras = 0 0 -1\n";
    const Vec3 q = second_vertex(volume_geometry("1", turned, "0 0 0"));
    EXPECT_NEAR(norm(q - Vec3{p.x, p.z, -p.y}), 0.0, 1e-12);
    // Scanner coordinates already, says a tag before the geometry.
    std::string real_ras;
    append(real_ras, std::int32_t{2}, true);
    append(real_ras, std::int32_t{1}, true);
    EXPECT_EQ(second_vertex(real_ras + volume_geometry("1", conformed_axes(), "5 -6 7.5")), p);
    std::string not_real_ras;
    append(not_real_ras, std::int32_t{2}, true);
    append(not_real_ras, std::int32_t{0}, true);
    EXPECT_EQ(second_vertex(not_real_ras + volume_geometry("1", conformed_axes(), "5 0 0")), (p + Vec3{5, 0, 0}));
}

TEST(Freesurfer, ReadsBackWhatItWrites)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    formats::write_surface_freesurfer(folder / "lh.folded", mesh.vertices, mesh.triangles);
    const TriangleMesh read = formats::read_surface(folder / "lh.folded");
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
    const std::vector<double> values{0.25, -1.0, 3.0, 1e-3};
    formats::write_scalars_freesurfer(folder / "lh.curv", values, mesh.triangles.size());
    EXPECT_THAT(formats::parse_freesurfer_scalars(bytes_of(folder / "lh.curv"), "lh.curv"),
                ElementsAre(0.25, -1.0, 3.0, static_cast<double>(1e-3f)));
}

TEST(Freesurfer, RefusesWithOneLine)
{
    const std::string good = freesurfer_surface(tetrahedron());
    EXPECT_THAT(refusal("\xff\xff\xff" + good.substr(3)), HasSubstr("quadrangles"));
    EXPECT_THAT(refusal("\xff\xff\xfd" + good.substr(3)), HasSubstr("lh.white"));
    EXPECT_THAT(refusal(good.substr(0, good.size() - 1)), HasSubstr("truncated FreeSurfer surface"));
    EXPECT_THAT(refusal(good.substr(0, 5)), HasSubstr("truncated FreeSurfer surface"));
    const std::string flat = "xras = 1 0 0\nyras = 1 0 0\nzras = 0 0 1\n";
    EXPECT_THAT(refusal(good + volume_geometry("1", flat, "0 0 0")), HasSubstr("bad volume geometry"));
    EXPECT_THAT(refusal(good + volume_geometry("1", conformed_axes(), "0 x 0")), HasSubstr("bad volume geometry"));
    std::string huge = good;
    huge.replace(good.find("\n\n") + 2, 4, "\x7f\xff\xff\xff");
    EXPECT_THAT(refusal(huge), HasSubstr("2147483647 vertices"));
    const auto scalars = [](const std::string& bytes)
    { return message_of<InputError>([&] { formats::parse_freesurfer_scalars(bytes, "lh.curv"); }); };
    const std::string curv = freesurfer_scalars({1, 2, 3});
    EXPECT_EQ(scalars(curv), "");
    EXPECT_THAT(scalars(curv.substr(0, curv.size() - 1)), HasSubstr("truncated"));
    EXPECT_THAT(scalars(good), HasSubstr("new curv format"));
}

TEST(Freesurfer, SaysWhatMovedThePointsAndCanLeaveThemAlone)
{
    const Vec3 p = tetrahedron().vertices[1];
    const std::string bytes = freesurfer_surface(tetrahedron(), volume_geometry("1", conformed_axes(), "5 -6 7.5"));
    std::vector<std::string> notes;
    EXPECT_EQ(
        formats::parse_surface(bytes, "pial", "lh.pial", {1.0, formats::Coordinates::scanner, &notes}).vertices[1],
        (p + Vec3{5, -6, 7.5}));
    EXPECT_THAT(notes, ElementsAre(HasSubstr("moved by (5, -6, 7.5) mm by the volume geometry behind")));
    notes.clear();
    EXPECT_EQ(formats::parse_surface(bytes, "pial", "lh.pial", {1.0, formats::Coordinates::file, &notes}).vertices[1],
              p);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("taken as they are")));
}

TEST(Freesurfer, ReadsACommentWithOneNewline)
{
    std::string bytes = freesurfer_surface(tetrahedron());
    bytes.erase(bytes.find("\n\n"), 1);
    const TriangleMesh mesh = formats::parse_surface(bytes, "white", "lh.white");
    EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
    EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
}

} // namespace corticle
