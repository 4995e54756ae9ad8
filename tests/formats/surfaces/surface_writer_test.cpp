// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_writer.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "formats/surfaces/surface_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

TEST(SurfaceWriter, PlyKeepsEveryBit)
{
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[2].x = 1.0 / 3.0;
    const std::vector<double> growth{1, 2, 3, 4};
    const std::vector<formats::Field> scalars{{"growth", 1, growth}, {"mean curvature", 1, growth}};
    formats::write_surface_ply(folder / "a.ply", mesh.vertices, mesh.triangles, scalars);
    const TriangleMesh read = formats::read_surface_unmerged(folder / "a.ply");
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
    const std::string bytes = bytes_of(folder / "a.ply");
    EXPECT_THAT(bytes, ::testing::HasSubstr("property double growth\nproperty double mean_curvature\n"));
    EXPECT_EQ(folder.file_count(), 1u);
}

TEST(SurfaceWriter, StlKeepsSinglePrecision)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron(); // exact in single precision
    formats::write_surface_stl(folder / "a.stl", mesh.vertices, mesh.triangles);
    const TriangleMesh read = formats::read_surface(folder / "a.stl");
    EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            EXPECT_EQ(read.vertices[static_cast<std::size_t>(read.triangles[t][k])],
                      mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])]);
        }
    }
    EXPECT_EQ(formats::read_surface_unmerged(folder / "a.stl").vertices.size(), 12u);
}

TEST(SurfaceWriter, SaysWhereItCannotWrite)
{
    const TriangleMesh mesh = tetrahedron();
    EXPECT_THAT(message_of<RunError>(
                    [&] { formats::write_surface_ply("/no/such/folder/a.ply", mesh.vertices, mesh.triangles); }),
                ::testing::HasSubstr("/no/such/folder/a.ply"));
}

} // namespace corticle
