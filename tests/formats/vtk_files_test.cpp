// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/vtk_files.hpp"

#include "corticle/base/error.hpp"
#include "formats/random_flips.hpp"
#include "formats/surfaces/surface_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

const std::vector<double> awkward{0.1, -0.0, std::numeric_limits<double>::denorm_min(), 1e308};
const std::vector<double> vectors{1, 2, 3, 4, 5, 6, 7, 8, 9, 1.0 / 3, 1e-17, 12};
const std::vector<formats::Field> fields{{"theta <&> \"1\"", 1, awkward}, {"velocity", 3, vectors}};

bool equal_bits(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

} // namespace

TEST(VtkFiles, SurfaceComesBackToTheBit)
{
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[1].x = 1.0 / 3.0;
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, fields);
    const formats::SurfaceFile read = formats::read_surface_vtp(folder / "a.vtp");
    EXPECT_EQ(read.mesh.vertices, mesh.vertices);
    EXPECT_EQ(read.mesh.triangles, mesh.triangles);
    ASSERT_EQ(read.fields.size(), 2u);
    EXPECT_EQ(read.fields[0].first, fields[0].name);
    EXPECT_TRUE(equal_bits(read.fields[0].second, awkward));
    EXPECT_TRUE(equal_bits(read.fields[1].second, vectors));
    formats::write_surface_vtp(folder / "b.vtp", mesh.vertices, mesh.triangles, fields);
    EXPECT_EQ(bytes_of(folder / "a.vtp"), bytes_of(folder / "b.vtp"));
    EXPECT_EQ(folder.file_count(), 2u);
}

TEST(VtkFiles, ParticlesComeBackToTheBit)
{
    const TemporaryFolder folder;
    const std::vector<Vec3> points = tetrahedron().vertices;
    const std::vector<std::int32_t> ids{3, 1, 2, 2147483647};
    formats::write_particles_vtu(folder / "a.vtu", points, ids, fields);
    const formats::ParticleFile read = formats::read_particles_vtu(folder / "a.vtu");
    EXPECT_EQ(read.points, points);
    ASSERT_EQ(read.fields.size(), 3u);
    EXPECT_EQ(read.fields[0], (std::pair<std::string, std::vector<double>>("id", {3, 1, 2, 2147483647})));
    EXPECT_TRUE(equal_bits(read.fields[2].second, vectors));
}

TEST(VtkFiles, ManyEqualValuesComeBack)
{
    const TemporaryFolder folder;
    const std::vector<Vec3> points(100000, Vec3{});
    const std::vector<std::int32_t> ids(points.size(), 0);
    const std::vector<double> ones(9 * points.size(), 1.0);
    formats::write_particles_vtu(folder / "a.vtu", points, ids, std::vector<formats::Field>{{"growth", 9, ones}});
    EXPECT_EQ(formats::read_particles_vtu(folder / "a.vtu").fields[1].second, ones);
}

TEST(VtkFiles, EmptyCloudsAreFiles)
{
    const TemporaryFolder folder;
    formats::write_particles_vtu(folder / "a.vtu", {}, {}, {});
    formats::write_surface_vtp(folder / "a.vtp", {}, {}, {});
    EXPECT_TRUE(formats::read_particles_vtu(folder / "a.vtu").points.empty());
    EXPECT_TRUE(formats::read_surface_vtp(folder / "a.vtp").mesh.triangles.empty());
}

TEST(VtkFiles, VtkReadsThem)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, fields);
    vtkNew<vtkXMLPolyDataReader> surface;
    surface->SetFileName((folder / "a.vtp").c_str());
    surface->Update();
    EXPECT_EQ(surface->GetOutput()->GetNumberOfPolys(), 4);
    EXPECT_EQ(surface->GetOutput()->GetPointData()->GetNumberOfArrays(), 2);
    formats::write_particles_vtu(folder / "a.vtu", mesh.vertices, std::vector<std::int32_t>{0, 1, 2, 3}, fields);
    vtkNew<vtkXMLUnstructuredGridReader> particles;
    particles->SetFileName((folder / "a.vtu").c_str());
    particles->Update();
    EXPECT_EQ(particles->GetOutput()->GetNumberOfCells(), 4);
    EXPECT_EQ(particles->GetOutput()->GetCellType(3), VTK_VERTEX);
}

TEST(VtkFiles, SeriesComesBack)
{
    const TemporaryFolder folder;
    const std::vector<std::pair<double, std::string>> frames{
        {0.0, "surface/0.vtp"}, {0.1, "a & b <1>.vtp"}, {1.0 / 3.0, "c.vtp"}};
    formats::write_pvd(folder / "a.pvd", frames);
    EXPECT_EQ(formats::read_pvd(folder / "a.pvd"), frames);
    put_bytes(folder / "cut.pvd", bytes_of(folder / "a.pvd").substr(0, 200));
    EXPECT_THROW(formats::read_pvd(folder / "cut.pvd"), InputError);
}

TEST(VtkFiles, RefusesDamage)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, fields);
    const std::string bytes = bytes_of(folder / "a.vtp");
    for (const double part : {0.0, 0.3, 0.6, 0.95})
    {
        put_bytes(folder / "cut.vtp",
                  bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
        EXPECT_THROW(formats::read_surface_vtp(folder / "cut.vtp"), InputError) << part;
    }
    EXPECT_THROW(formats::read_particles_vtu(folder / "a.vtp"), InputError);
    EXPECT_THAT(message_of<RunError>(
                    [&] { formats::write_surface_vtp(folder / "none/a.vtp", mesh.vertices, mesh.triangles, {}); }),
                HasSubstr("none/a.vtp: No such file"));
}

TEST(VtkFiles, NoFlippedBitIsReadInSilence)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    const std::vector<std::int32_t> ids{3, 1, 2, 2147483647};
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, fields);
    formats::write_particles_vtu(folder / "a.vtu", mesh.vertices, ids, fields);
    formats::write_pvd(folder / "a.pvd", std::vector<std::pair<double, std::string>>{{0.0, "a"}, {1.0 / 3.0, "b"}});
    expect_no_silent_flip(folder / "a.vtp",
                          [](const std::filesystem::path& file)
                          {
                              const formats::SurfaceFile read = formats::read_surface_vtp(file);
                              return std::tuple(read.mesh.vertices, read.mesh.triangles, read.fields);
                          });
    expect_no_silent_flip(folder / "a.vtu",
                          [](const std::filesystem::path& file)
                          {
                              const formats::ParticleFile read = formats::read_particles_vtu(file);
                              return std::pair(read.points, read.fields);
                          });
    expect_no_silent_flip(folder / "a.pvd", [](const std::filesystem::path& file) { return formats::read_pvd(file); });
}

TEST(VtkFiles, FilesWithoutAChecksumAreRead)
{
    const TemporaryFolder folder;
    const TriangleMesh mesh = tetrahedron();
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, fields);
    const std::string bytes = bytes_of(folder / "a.vtp");
    const std::size_t line = bytes.rfind("<!-- checksum ");
    ASSERT_NE(line, std::string::npos);
    put_bytes(folder / "b.vtp", bytes.substr(0, line));
    EXPECT_EQ(formats::read_surface_vtp(folder / "b.vtp").mesh.vertices, mesh.vertices);
    put_bytes(folder / "c.vtp", " " + bytes);
    EXPECT_THAT(message_of<InputError>([&] { formats::read_surface_vtp(folder / "c.vtp"); }),
                HasSubstr("c.vtp: damaged, or changed by hand"));
}

} // namespace corticle
