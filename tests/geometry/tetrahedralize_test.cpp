// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/tetrahedralize.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/validate_tets.hpp"
#include "formats/temporary_folder.hpp"
#include "mesh/mesh_volume.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <random>

namespace corticle
{
namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t nodes = 2200;

TriangleMesh ellipsoid_surface()
{
    return geometry::make_ellipsoid({12.0, 10.0, 8.0}, 1.3);
}

TEST(Tetrahedralize, FillsTheSurfaceAndKeepsItsVertices)
{
    const TriangleMesh surface = ellipsoid_surface();
    const TetMesh mesh = geometry::tetrahedralize(surface, nodes);
    EXPECT_TRUE(std::equal(surface.vertices.begin(), surface.vertices.end(), mesh.vertices.begin()));
    EXPECT_NEAR(mesh_volume(mesh) / enclosed_volume(surface.vertices, surface.triangles), 1.0, 1e-12);
    const TetBoundary boundary = boundary_of(mesh);
    EXPECT_EQ(boundary.surface.vertices, surface.vertices);
    EXPECT_EQ(boundary.surface.triangles.size(), surface.triangles.size());
    geometry::TetReport report;
    EXPECT_EQ(geometry::require_valid_tets(mesh, "mesh", &report).tets.size(), mesh.tets.size());
    EXPECT_TRUE(report.lines.empty()) << report.lines[0];
    EXPECT_NEAR(static_cast<double>(mesh.vertices.size()) / nodes, 1.0, 0.05);
    EXPECT_GT(report.smallest_mean_ratio, 0.3);
}

TEST(Tetrahedralize, GivesTheSameForAnyNumberOfThreads)
{
    const int threads = thread_count();
    set_thread_count(1);
    const TetMesh one = geometry::tetrahedralize(ellipsoid_surface(), nodes);
    set_thread_count(2);
    const TetMesh two = geometry::tetrahedralize(ellipsoid_surface(), nodes);
    EXPECT_EQ(thread_count(), 2); // as it was
    set_thread_count(threads);
    EXPECT_EQ(one.vertices, two.vertices);
    EXPECT_EQ(one.tets, two.tets);
}

/// Blocks of all sizes, of which about half were given back in no order: what any program's heap may look like.
std::vector<std::unique_ptr<char[]>> litter_the_heap(unsigned seed)
{
    std::minstd_rand random(seed);
    std::vector<std::unique_ptr<char[]>> blocks;
    for (int k = 0; k < 20000; ++k)
    {
        blocks.push_back(std::make_unique<char[]>(8 + random() % (random() % 10 == 0 ? 6000 : 300)));
    }
    std::ranges::shuffle(blocks, random);
    blocks.resize(blocks.size() / 2);
    return blocks;
}

TEST(Tetrahedralize, GivesTheSameWhateverTheHeapHolds)
{
    const TetMesh clean = geometry::tetrahedralize(ellipsoid_surface(), nodes);
    for (const unsigned seed : {1U, 2U, 3U})
    {
        const auto litter = litter_the_heap(seed);
        const TetMesh again = geometry::tetrahedralize(ellipsoid_surface(), nodes);
        EXPECT_EQ(clean.vertices, again.vertices) << seed;
        EXPECT_EQ(clean.tets, again.tets) << seed;
    }
}

TEST(Tetrahedralize, ASurfaceThatCrossesItselfIsRefused)
{
    TriangleMesh surface = ellipsoid_surface();
    for (Vec3& v : surface.vertices) // one half is pushed through the other
    {
        v.x = v.x > 5.0 ? v.x - 20.0 : v.x;
    }
    EXPECT_THROW(geometry::tetrahedralize(surface, nodes), InputError);
}

/// While it lives, a shell script meshes in place of the program.
class OtherProgram
{
  public:
    explicit OtherProgram(const std::string& script)
    {
        const std::filesystem::path file = folder_ / "program";
        if (!script.empty())
        {
            std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
            std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        }
        setenv("CORTICLE_TETRAHEDRALIZE", file.c_str(), 1);
    }
    ~OtherProgram() { unsetenv("CORTICLE_TETRAHEDRALIZE"); }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

  private:
    TemporaryFolder folder_;
};

/// What is said where a script meshes.
std::string failure(const std::string& script)
{
    const OtherProgram other(script);
    try
    {
        geometry::tetrahedralize(ellipsoid_surface(), nodes);
    }
    catch (const RunError& error)
    {
        return error.what();
    }
    catch (const InputError& error)
    {
        return std::string("input: ") + error.what();
    }
    return "no failure";
}

TEST(Tetrahedralize, AProgramThatIsMissingOrFailsIsNamed)
{
    EXPECT_THAT(failure(""), AllOf(HasSubstr("cannot start"), HasSubstr("No such file")));
    EXPECT_THAT(failure("kill -SEGV $$"), HasSubstr("ended by signal 11"));
    EXPECT_THAT(failure("echo lost >&2; exit 127"), HasSubstr("exit status 127, lost"));
    EXPECT_THAT(failure("exit 1"), StartsWith("input: surface of"));
    const OtherProgram other("exit 2");
    EXPECT_THROW(geometry::tetrahedralize(ellipsoid_surface(), nodes), std::bad_alloc);
}

TEST(Tetrahedralize, OutputThatIsNoMeshIsRefused)
{
    const std::string beside =
        (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "corticle-tetrahedralize").string();
    const auto is_refused = HasSubstr("are no mesh of this surface");
    EXPECT_THAT(failure("exit 0"), is_refused);
    EXPECT_THAT(failure("head -c 100000 /dev/zero"), is_refused);
    EXPECT_THAT(failure("cat"), is_refused);
    EXPECT_THAT(failure(beside + " | head -c 50000"), is_refused);
    EXPECT_THAT(failure(beside + "; echo more"), is_refused);
    EXPECT_THAT(failure("printf 'tets 1\\n\\377\\377\\377\\377\\377\\377\\377\\377'"), is_refused);
    EXPECT_EQ(failure(beside), "no failure");
}

TEST(Tetrahedralize, WorksWhereSigchldIsIgnored)
{
    std::signal(SIGCHLD, SIG_IGN);
    EXPECT_FALSE(geometry::tetrahedralize(ellipsoid_surface(), nodes).tets.empty());
    EXPECT_THAT(failure("kill -SEGV $$"), HasSubstr("ended by signal 11"));
    EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN);
}

TEST(Tetrahedralize, MeetsTheNumberOfTetsAskedFor)
{
    constexpr double radius = 12.496;
    constexpr double edge_per_spacing = 1.05;
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
    const double area = 4.0 * std::numbers::pi * radius * radius;
    for (const std::int64_t tets : {5000, 50000})
    {
        const double tolerance = tets > 20000 ? 0.03 : 0.08; // a coarse surface has less volume than its sphere
        const std::int64_t count = geometry::nodes_for_tets(tets, volume, area, edge_per_spacing);
        const double spacing = std::cbrt(volume / static_cast<double>(count));
        const TetMesh mesh = geometry::tetrahedralize(
            geometry::make_ellipsoid({radius, radius, radius}, edge_per_spacing * spacing), count);
        EXPECT_NEAR(static_cast<double>(mesh.tets.size()) / static_cast<double>(tets), 1.0, tolerance) << tets;
        EXPECT_NEAR(static_cast<double>(mesh.vertices.size()) / static_cast<double>(count), 1.0, tolerance) << tets;
    }
}

} // namespace
} // namespace corticle
