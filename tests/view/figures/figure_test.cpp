// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/figure.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/shapes.hpp"
#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle
{

namespace
{

/// A picture as numbers: rows from above, `channels` bytes a pixel.
struct Read
{
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<int> bytes;

    int at(int x, int y, int c) const { return bytes[static_cast<std::size_t>((y * width + x) * channels + c)]; }
};

Read read_png(const std::filesystem::path& png)
{
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(png.c_str());
    reader->Update();
    vtkImageData* const image = reader->GetOutput();
    Read read{image->GetDimensions()[0], image->GetDimensions()[1], image->GetNumberOfScalarComponents(), {}};
    for (int y = read.height - 1; y >= 0; --y)
    {
        const auto* row = static_cast<const unsigned char*>(image->GetScalarPointer(0, y, 0));
        read.bytes.insert(read.bytes.end(), row, row + read.width * read.channels);
    }
    return read;
}

/// An ellipsoid whose front half has the value 1 and its back half 0, with a core of white matter.
struct Brain
{
    TriangleMesh mesh = geometry::make_ellipsoid({20.0, 30.0, 15.0}, 2.0);
    std::vector<Vec3> boundary;
    std::vector<double> front;

    Brain()
    {
        for (const Vec3& point : mesh.vertices)
        {
            boundary.push_back(0.6 * point);
            front.push_back(point.y > 0.0 ? 1.0 : 0.0);
        }
    }
};

class Figures : public ::testing::Test
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
    view::Figure figure(std::span<const view::AnatomicalView> views) const
    {
        return {brain.mesh.vertices,
                brain.mesh.triangles,
                brain.boundary,
                brain.front,
                {"front", 0.0, 1.0},
                "week 30",
                views,
                {true, imaging::Hemisphere::both}};
    }
    view::FigureLayout layout(std::span<const view::AnatomicalView> views, int width) const
    {
        const std::array<std::span<const Vec3>, 1> shapes{brain.mesh.vertices};
        return view::figure_layout(views, {true, imaging::Hemisphere::both}, shapes, width);
    }
    Brain brain;
    TemporaryFolder folder;
};

/// Mean red less mean blue of the coloured pixels of a box: large where the map's yellow end is shown.
double yellowness(const Read& read, int left, int right, int top, int bottom)
{
    double sum = 0.0;
    int count = 0;
    for (int y = top; y < bottom; ++y)
    {
        for (int x = left; x < right; ++x)
        {
            const std::array<int, 3> c{read.at(x, y, 0), read.at(x, y, 1), read.at(x, y, 2)};
            if (*std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end()) > 30)
            {
                sum += c[0] - c[2];
                ++count;
            }
        }
    }
    return count == 0 ? 0.0 : sum / count;
}

} // namespace

TEST(Anatomy, MarksAreThoseOfThePicture)
{
    for (const auto& [name, left, right] : {std::array<std::string, 3>{"left-lateral", "A", "P"},
                                            {"left-medial", "P", "A"},
                                            {"right-lateral", "P", "A"},
                                            {"right-medial", "A", "P"},
                                            {"dorsal", "L", "R"},
                                            {"ventral", "R", "L"},
                                            {"anterior", "R", "L"},
                                            {"posterior", "L", "R"}})
    {
        const auto view = view::views_named(std::array{name}).front();
        EXPECT_EQ(view::side_marks(view, true), (std::array{left, right})) << name;
    }
    EXPECT_EQ(view::side_marks(view::views_named(std::array<std::string, 1>{"dorsal"}).front(), false)[1], "+x");
}

TEST(Anatomy, ViewsOfWhatIsThere)
{
    EXPECT_EQ(view::usual_views(imaging::Hemisphere::both).size(), 8u);
    const auto left = view::usual_views(imaging::Hemisphere::left);
    ASSERT_EQ(left.size(), 4u);
    EXPECT_TRUE(std::ranges::all_of(left, [](const auto& view) { return view.name.starts_with("left"); }));
    EXPECT_THROW(view::views_named(std::array<std::string, 1>{"above"}), InputError);
    for (const view::AnatomicalView& view : view::anatomical_views())
    {
        EXPECT_NEAR(norm(view.from), 1.0, 1e-5) << view.name; // six digits
        EXPECT_NEAR(norm(view.up), 1.0, 1e-5) << view.name;
        EXPECT_NEAR(dot(view.from, view.up), 0.0, 1e-5) << view.name;
    }
}

TEST_F(Figures, FrontLiesWhereItsMarkSays)
{
    const auto views = view::views_named(std::array<std::string, 2>{"left-lateral", "right-lateral"});
    const view::FigureLayout page = layout(views, 1000);
    view::render_figure(folder / "a.png", figure(views), page, false);
    const Read read = read_png(folder / "a.png");
    EXPECT_EQ(read.width, 1000);
    EXPECT_EQ(read.height, page.height);
    EXPECT_EQ(read.channels, 3);
    const int w = page.panel_width;
    const int top = read.height / 4;
    const int bottom = 3 * read.height / 4;
    EXPECT_GT(yellowness(read, w / 10, 4 * w / 10, top, bottom), 50.0);        // front at the left
    EXPECT_LT(yellowness(read, 6 * w / 10, 9 * w / 10, top, bottom), 0.0);     // back at the right
    EXPECT_LT(yellowness(read, w + w / 10, w + 4 * w / 10, top, bottom), 0.0); // mirrored
    EXPECT_GT(yellowness(read, w + 6 * w / 10, w + 9 * w / 10, top, bottom), 50.0);
}

TEST_F(Figures, MedialViewsShowCortexAndWhiteMatter)
{
    const auto views = view::views_named(std::array<std::string, 2>{"left-medial", "right-medial"});
    const view::FigureLayout page = layout(views, 1000);
    view::render_figure(folder / "a.png", figure(views), page, false);
    const Read read = read_png(folder / "a.png");
    for (const int panel : {0, 1})
    {
        std::array<double, 2> found{}; // pixels of cortex and of white matter
        for (int y = 0; y < read.height; ++y)
        {
            for (int x = panel * page.panel_width; x < (panel + 1) * page.panel_width; ++x)
            {
                const std::array<int, 3> c{read.at(x, y, 0), read.at(x, y, 1), read.at(x, y, 2)};
                found[0] += c == std::array{196, 78, 62} ? 1.0 : 0.0;
                found[1] += c == std::array{208, 218, 228} ? 1.0 : 0.0;
            }
        }
        // Areas of an ellipse: white matter 0.36 of it, cortex the rest but the line around.
        const double whole = 3.14159 * 30.0 * 15.0 / std::pow(page.mm_per_pixel, 2);
        EXPECT_NEAR(found[1] / whole, 0.36, 0.03) << panel; // of a ball of facets, less than the smooth one
        EXPECT_NEAR(found[0] / whole, 0.62, 0.05) << panel;
    }
}

TEST_F(Figures, NothingBehindTheBody)
{
    const auto views = view::views_named(std::array<std::string, 1>{"dorsal"});
    view::render_figure(folder / "a.png", figure(views), layout(views, 600), true);
    const Read read = read_png(folder / "a.png");
    ASSERT_EQ(read.channels, 4);
    EXPECT_EQ(read.at(2, 2, 3), 0);
    const int x = layout(views, 600).panel_width / 2;
    EXPECT_EQ(read.at(x, read.height / 2, 3), 255);
}

TEST_F(Figures, PagesOfASeriesHaveOneScale)
{
    const auto views = view::views_named(std::array<std::string, 1>{"dorsal"});
    std::vector<Vec3> large = brain.mesh.vertices;
    for (Vec3& point : large)
    {
        point *= 2.0;
    }
    const std::array<std::span<const Vec3>, 2> both{brain.mesh.vertices, large};
    const view::FigureLayout page = view::figure_layout(views, {true, imaging::Hemisphere::both}, both, 600);
    EXPECT_NEAR(page.mm_per_pixel / layout(views, 600).mm_per_pixel, 2.0, 1e-9);
}

} // namespace corticle
