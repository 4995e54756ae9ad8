// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/view/plane_section.hpp"
#include "formats/surfaces/surface_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace corticle
{

namespace
{

using Pixel = std::array<int, 3>;

struct Picture
{
    int width = 0;
    int height = 0;
    std::set<Pixel> colors;
    std::vector<Pixel> pixels; ///< rows from below

    Pixel at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

Picture read_picture(const std::filesystem::path& png)
{
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(png.c_str());
    reader->Update();
    Picture picture;
    vtkImageData* image = reader->GetOutput();
    picture.width = image->GetDimensions()[0];
    picture.height = image->GetDimensions()[1];
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
            picture.pixels.push_back({pixel[0], pixel[1], pixel[2]});
            picture.colors.insert(picture.pixels.back());
        }
    }
    return picture;
}

class Pictures : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        std::string reason;
        if (!view::can_render(reason))
        {
            GTEST_SKIP() << reason;
        }
    }
    TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
};

} // namespace

TEST_F(Pictures, SurfaceShowsShadedColours)
{
    const std::vector<double> values{0, 1, 2, std::nan("")};
    const std::vector<double> others{2, 1, 0, 1};
    const view::ColorScale scale{"value [-]", 0, 2, view::ColorMap::viridis};
    const std::array pictures{
        view::SurfacePicture{folder / "a.png", values, scale},
        view::SurfacePicture{folder / "other.png", others, {"other [-]", 0, 3, view::ColorMap::coolwarm}},
        view::SurfacePicture{folder / "b.png", values, scale}};
    view::render_surface(mesh.vertices, mesh.triangles, pictures, "title");
    view::render_surface(mesh.vertices, mesh.triangles, {&pictures[0], 1}, "title");
    const Picture picture = read_picture(folder / "a.png");
    EXPECT_EQ(picture.width, 1600);
    EXPECT_EQ(picture.height, 800);
    EXPECT_GT(picture.colors.size(), 500u);
    EXPECT_EQ(picture.at(5, 5), (Pixel{255, 255, 255}));
    EXPECT_NE(picture.at(1080, 500), (Pixel{255, 255, 255}));          // the right panel is drawn, too
    EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png")); // alone or among others
    EXPECT_NE(bytes_of(folder / "a.png"), bytes_of(folder / "other.png"));
}

TEST_F(Pictures, CutShowsTheNearestParticles)
{
    // One particle of cortex on the left, one of white matter on the right of a section through a tetrahedron.
    const std::vector<Vec3> particles{{0.2, 0.3, -0.5}, {0.9, 0.3, -0.5}};
    const std::vector<Mat3> undeformed(2, Mat3::identity());
    const std::array theta{1.0, 0.0};
    const std::array scalar{0.0, 1.0};
    const view::CutInput input{.positions = particles,
                               .origins = particles,
                               .F = undeformed,
                               .theta = theta,
                               .scalar = scalar,
                               .spacing = 0.5,
                               .surface_points = mesh.vertices,
                               .triangles = mesh.triangles,
                               .axis = 2,
                               .coordinate = -0.5};
    view::render_cut(folder / "a.png", input, {"stress [kPa]", 0, 1, view::ColorMap::viridis}, "cut");
    view::render_cut(folder / "b.png", input, {"stress [kPa]", 0, 1, view::ColorMap::viridis}, "cut");
    EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));
    const Picture picture = read_picture(folder / "a.png");
    EXPECT_EQ(picture.width, 1600);
    EXPECT_TRUE(picture.colors.contains(Pixel{196, 78, 62}));   // cortex
    EXPECT_TRUE(picture.colors.contains(Pixel{208, 218, 228})); // white matter
    EXPECT_TRUE(picture.colors.contains(Pixel{68, 1, 84}));     // low end of viridis
    EXPECT_TRUE(picture.colors.contains(Pixel{253, 231, 37}));  // high end
    EXPECT_TRUE(picture.colors.contains(Pixel{0, 0, 0}));       // outline
}

TEST_F(Pictures, CutBesideTheBodyIsEmptyButDrawn)
{
    view::CutInput input;
    input.surface_points = mesh.vertices;
    input.triangles = mesh.triangles;
    input.axis = 0;
    input.coordinate = 50.0;
    view::render_cut(folder / "a.png", input, {"stress [kPa]", 0, 1, view::ColorMap::viridis}, "beside");
    EXPECT_GT(read_picture(folder / "a.png").colors.size(), 10u);
}

TEST_F(Pictures, PairOfSurfacesHasOneScaleOfLength)
{
    std::vector<Vec3> small = mesh.vertices;
    for (Vec3& v : small)
    {
        v *= 0.25;
    }
    const std::vector<double> values{0, 1, 2, 1};
    const std::array<view::SurfaceInput, 2> surfaces{view::SurfaceInput{"one", mesh.vertices, mesh.triangles, values},
                                                     view::SurfaceInput{"quarter", small, mesh.triangles, values}};
    view::render_surface_pair(folder / "a.png", surfaces, {"value [-]", 0, 2, view::ColorMap::viridis}, "title");
    view::render_surface_pair(folder / "b.png", surfaces, {"value [-]", 0, 2, view::ColorMap::viridis}, "title");
    EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));
    const Picture picture = read_picture(folder / "a.png");
    EXPECT_EQ(picture.width, 1600);
    EXPECT_EQ(picture.height, 1550);
    const auto covered = [&](int left, int bottom)
    {
        double count = 0;
        for (int y = bottom; y < bottom + 690; ++y)
        {
            for (int x = left; x < left + 690; ++x)
            {
                count += picture.at(x, y) == Pixel{255, 255, 255} ? 0 : 1;
            }
        }
        return count;
    };
    for (const int bottom : {45, 795}) // from the right, from above
    {
        // A quarter of the length covers a sixteenth; edges of the small one count for some per cent.
        EXPECT_NEAR(16.0 * covered(735, bottom) / covered(15, bottom), 1.0, 0.1);
    }
}

TEST_F(Pictures, PairOfCutsHasOneColorScale)
{
    const std::vector<Vec3> particles{{0.2, 0.3, -0.5}, {0.9, 0.3, -0.5}};
    const std::vector<Mat3> undeformed(2, Mat3::identity());
    const std::array theta{1.0, 0.0};
    const std::array low{0.0, 0.0};
    const std::array high{1.0, 1.0};
    view::CutInput input{.positions = particles,
                         .origins = particles,
                         .F = undeformed,
                         .theta = theta,
                         .scalar = low,
                         .spacing = 0.5,
                         .surface_points = mesh.vertices,
                         .triangles = mesh.triangles,
                         .axis = 2,
                         .coordinate = -0.5};
    view::CutInput other = input;
    other.scalar = high;
    view::render_cut_pair(folder / "a.png", {input, other}, {"left", "right"}, {"J", 0, 1, view::ColorMap::viridis},
                          "cuts");
    const Picture picture = read_picture(folder / "a.png");
    const auto count = [&](const Pixel& color, int left)
    {
        int found = 0;
        for (int y = 60; y < 720; ++y)
        {
            for (int x = left; x < left + 660; ++x)
            {
                found += picture.at(x, y) == color ? 1 : 0;
            }
        }
        return found;
    };
    const Pixel lowest{68, 1, 84};
    const Pixel highest{253, 231, 37};
    EXPECT_GT(count(lowest, 5), 10000);
    EXPECT_EQ(count(highest, 5), 0);
    EXPECT_GT(count(highest, 800), 10000);
    EXPECT_EQ(count(lowest, 800), 0);
}

TEST_F(Pictures, PlotMarksPoints)
{
    const std::array panels{view::Panel{"t", "y", {{"line", {0, 1}, {0, 1}}, {"points", {0.2, 0.6}, {0.8, 0.4}, true}}},
                            view::Panel{"t", "one point", {{"point", {1}, {2}, true}}}};
    view::render_plot(folder / "a.png", panels, "points");
    view::render_plot(folder / "b.png",
                      std::array{view::Panel{"t", "y", {panels[0].curves[0], {"points", {}, {}, true}}}}, "no points");
    const Pixel second{213, 94, 0};
    EXPECT_TRUE(read_picture(folder / "a.png").colors.contains(second));
    EXPECT_FALSE(read_picture(folder / "b.png").colors.contains(second));
}

TEST_F(Pictures, PlotMarksPointsOfLinesAndNamesTicks)
{
    const auto draw = [&](const std::string& name, bool is_marked, std::vector<std::pair<double, std::string>> ticks)
    {
        const view::Curve curve{"line", {0, 1}, {0, 1}, false, is_marked};
        const view::Curve wider{"points", {-0.2, 1.2}, {-0.2, 1.2}, true}; // both pictures have one range
        view::render_plot(folder / name, std::array{view::Panel{"x", "y", {curve, wider}, std::move(ticks)}}, "ticks");
        const Picture picture = read_picture(folder / name);
        return std::count(picture.pixels.begin(), picture.pixels.end(), Pixel{0, 114, 178});
    };
    const auto plain = draw("plain.png", false, {});
    EXPECT_GT(draw("marked.png", true, {}), plain + 50);
    draw("ticks.png", false, {{0.25, "coarse"}, {0.75, "fine"}});
    EXPECT_NE(read_picture(folder / "ticks.png").pixels, read_picture(folder / "plain.png").pixels);
}

TEST_F(Pictures, GridDrawsEachTileInItsPlace)
{
    const TriangleMesh ball = geometry::make_ellipsoid({2.0, 2.0, 2.0}, 0.3);
    const auto tile = [&](std::size_t i) -> view::SurfaceTile
    {
        if (i == 1)
        {
            return {"failed", {}, {}, {}};
        }
        std::vector<Vec3> points = ball.vertices;
        points.front() *= i == 2 ? 50.0 : 1.0; // one has left the body
        return {"ball", std::move(points), ball.triangles, std::vector<double>(ball.vertices.size(), 1.0)};
    };
    view::render_surface_grid(folder / "grid.png", 3, 2, tile, {"J", 0.0, 1.0, view::ColorMap::viridis}, "three");
    const Picture picture = read_picture(folder / "grid.png");
    EXPECT_EQ(picture.width, 950);
    EXPECT_EQ(picture.height, 914);
    const auto drawn = [&](int left, int bottom)
    {
        int count = 0;
        for (int y = bottom + 50; y < bottom + 420; ++y)
        {
            for (int x = left; x < left + 400; ++x)
            {
                count += picture.at(x, y) != Pixel{255, 255, 255} ? 1 : 0;
            }
        }
        return count;
    };
    const int first = drawn(0, 432);
    EXPECT_GT(first, 60000);
    EXPECT_EQ(drawn(400, 432), 0);
    EXPECT_GT(drawn(0, 0), first * 4 / 5);
}

TEST_F(Pictures, PlotDrawsCurvesAndSurvivesOddOnes)
{
    const double nan = std::nan("");
    const std::vector<view::Panel> panels{
        {"t [-]", "a [mm]", {{"one", {0, 1, 2}, {1, 3, 2}}, {"two", {0, 1, 2}, {2, nan, 1}}}},
        {"t [-]", "constant", {{"", {0, 1}, {5, 5}}}},
        {"t [-]", "point", {{"", {0}, {5}}}},
        {"t [-]", "nothing", {}}};
    view::render_plot(folder / "a.png", panels, "plots");
    const Picture picture = read_picture(folder / "a.png");
    EXPECT_EQ(picture.width, 1800);
    EXPECT_TRUE(picture.colors.contains(Pixel{0, 114, 178}));
    EXPECT_TRUE(picture.colors.contains(Pixel{213, 94, 0}));
}

TEST_F(Pictures, ReportsWhereItCannotWrite)
{
    EXPECT_THROW(view::render_plot(folder / "none/a.png", {}, "title"), RunError);
}

TEST(PlaneSection, MaskFollowsTheWindingNumber)
{
    // A square of 4 mm and, overlapping it, a second one: the overlap is wound twice and still inside.
    const auto square = [](double low, double high)
    {
        return std::vector<view::Segment>{{{low, low}, {high, low}},
                                          {{high, low}, {high, high}},
                                          {{high, high}, {low, high}},
                                          {{low, high}, {low, low}}};
    };
    std::vector<view::Segment> outline = square(1, 5);
    const std::vector<view::Segment> second = square(3, 7);
    outline.insert(outline.end(), second.begin(), second.end());
    const view::PixelGrid grid{8, 8, 0.0, 0.0, 1.0};
    const std::vector<std::uint8_t> mask = view::inside_mask(outline, grid);
    const std::vector<std::string> expected{"00000000", "01111000", "01111000", "01111110",
                                            "01111110", "00011110", "00011110", "00000000"};
    for (std::size_t row = 0; row < 8; ++row)
    {
        for (std::size_t column = 0; column < 8; ++column)
        {
            EXPECT_EQ(mask[8 * row + column], expected[row][column] - '0') << row << " " << column;
        }
    }
}

TEST(PlaneSection, OutlineOfAClosedSurfaceIsClosed)
{
    const TriangleMesh mesh = tetrahedron();
    for (const double height : {-2.9, -1.0, 0.0}) // at 0 three vertices lie on the plane
    {
        std::array<double, 2> sum{};
        const std::vector<view::Segment> outline = view::section_outline(mesh.vertices, mesh.triangles, {2, height});
        EXPECT_EQ(outline.size(), 3u);
        for (const view::Segment& segment : outline)
        {
            sum = {sum[0] + segment.to[0] - segment.from[0], sum[1] + segment.to[1] - segment.from[1]};
        }
        EXPECT_NEAR(std::abs(sum[0]) + std::abs(sum[1]), 0.0, 1e-12); // round-off of a few additions of order 1
    }
}

TEST(PlaneSection, NearestParticleAgreesWithTryingAll)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-10.0, 10.0);
    std::vector<Vec3> particles(2000);
    for (Vec3& particle : particles)
    {
        particle = {place(random), place(random), place(random)};
    }
    const view::Plane plane{1, 2.0};
    const view::PixelGrid grid{40, 30, -14.0, -11.0, 0.7};
    const std::vector<std::uint8_t> everywhere(1200, 1);
    const std::vector<std::int32_t> nearest = view::nearest_particles(particles, plane, grid, everywhere);
    for (int row = 0; row < grid.height; ++row)
    {
        for (int column = 0; column < grid.width; ++column)
        {
            const Vec3 pixel{grid.right_of(column), plane.coordinate, grid.up_of(row)};
            double best = std::numeric_limits<double>::infinity();
            for (const Vec3& particle : particles)
            {
                best = std::min(best, norm(particle - pixel));
            }
            const auto found = nearest[static_cast<std::size_t>(row * grid.width + column)];
            EXPECT_NEAR(norm(particles[static_cast<std::size_t>(found)] - pixel), best, 1e-12);
        }
    }
}

} // namespace corticle
