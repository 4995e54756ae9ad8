// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/box.hpp"
#include "corticle/view/display.hpp"
#include "corticle/view/picture_window.hpp"
#include "corticle/view/pictures.hpp"
#include "corticle/view/shaded_views.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace corticle::view
{

namespace
{

constexpr int picture_width = 1600; // [px], as are the places below
constexpr int row_height = 750;
constexpr int panel_size = 700;
constexpr int panel_bottom = 40;
constexpr int title_height = 50;
constexpr int bar_left = 1450;

constexpr int tile_picture = 380; // of a grid
constexpr int tile_caption = 48;
constexpr int tile_width = 400;
constexpr int tile_height = tile_picture + tile_caption + 4;
constexpr int bar_room = 150;

constexpr std::array<int, 2> panel_left{10, 730};

/// A view and what stands below it.
struct Side
{
    View view;
    const char* caption;
};

constexpr std::array<Side, 2> sides{
    {{{{0, 0, 1}, {0, 1, 0}}, "from above (+z)"}, {{{1, 0, 0}, {0, 0, 1}}, "from the right (+x)"}}};

/// The first `count` sides of a body in squares of `size` pixels.
Pictures draw_sides(const Body& body, std::span<const Coloring> colorings, const Vec3& center, double half_width,
                    std::size_t count, int size)
{
    std::vector<View> views;
    for (std::size_t i = 0; i < count; ++i)
    {
        views.push_back(sides[i].view);
        views.back().center = center;
    }
    return draw_views(
        body, colorings, views,
        {.width = size, .height = size, .mm_per_pixel = 2.0 * half_width / size, .half_size = half_width});
}

/// Half of the width of a panel that the surface fits [mm].
double fitting_half_width(std::span<const Vec3> points)
{
    return std::max(1.04 * bounding_box(points).half_width(), std::numeric_limits<double>::min());
}

/// Of a caption, so that its first line fits a tile [px].
int caption_size(const std::string& caption)
{
    constexpr std::size_t largest = 16;
    constexpr std::size_t smallest = 9;
    constexpr std::size_t fitting = 40; // characters of the largest
    const std::size_t length = std::min(caption.find('\n'), caption.size());
    return static_cast<int>(length <= fitting ? largest : std::max(smallest, largest * fitting / length));
}

/// Middle and half of the width of a surface [mm]; of the bulk of its points where a few have left it far behind.
std::pair<Vec3, double> extent_of(std::span<const Vec3> points)
{
    constexpr double far = 1.5;        // times the bulk
    constexpr std::size_t share = 200; // one point of so many at each end is not part of the bulk
    Box bulk;
    std::vector<double> along(points.size());
    for (int axis = 0; axis < 3; ++axis)
    {
        std::ranges::transform(points, along.begin(), [axis](const Vec3& point) { return point[axis]; });
        std::ranges::sort(along);
        bulk.low[axis] = along[along.size() / share];
        bulk.high[axis] = along[along.size() - 1 - along.size() / share];
    }
    const Box all = bounding_box(points);
    const Box& shown = all.half_width() > far * bulk.half_width() ? bulk : all;
    return {shown.center(), std::max(1.04 * shown.half_width(), std::numeric_limits<double>::min())};
}

struct PagePanel
{
    vtkSmartPointer<vtkImageData> image;
    std::size_t row; ///< from below
    std::size_t column;
    std::string caption;
};

/// Panels in `rows` rows of two columns, a colour bar on their right, a title above.
vtkSmartPointer<vtkImageData> draw_page(std::span<const PagePanel> panels, std::size_t rows, const ColorScale& scale,
                                        const std::string& title)
{
    const int height = static_cast<int>(rows) * row_height + title_height;
    vtkNew<vtkRenderer> page;
    page->SetBackground(1, 1, 1);
    for (const PagePanel& panel : panels)
    {
        const int left = panel_left[panel.column];
        const int below = static_cast<int>(panel.row) * row_height;
        add_image(page, panel.image, left, below + panel_bottom);
        add_text(page, panel.caption, left + 0.5 * panel_size, below + 20, {.size = 20});
    }
    add_text(page, title, 0.5 * picture_width, height - 30, {.size = 26, .is_bold = true});
    const double bar_bottom = 0.5 * (static_cast<double>(rows) - 1.0) * row_height + panel_bottom + 100;
    add_color_bar(page, scale, bar_left, bar_bottom, panel_size - 200);
    return draw_renderer(page, picture_width, height);
}

} // namespace

std::future<void> start_renderer()
{
    return std::async(
        std::launch::async,
        []
        {
            const std::array<Vec3, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}};
            const std::array<Triangle, 1> triangle{{{0, 1, 2}}};
            const ColorScale scale{"one", 0.0, 1.0};
            const std::array coloring{Coloring{{}, &scale}};
            const Pictures drawn = draw_sides({corners, triangle}, coloring, corners[0], 1.0, sides.size(), 8);
            draw_page(std::array{PagePanel{drawn[0], 0, 0, "one"}}, 1, scale, "one");
            picture_window(8, 8)->ReleaseCurrent(); // another thread draws from now on
        });
}

void render_surface(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    std::span<const SurfacePicture> colored, const std::string& title, double half_width)
{
    assert(!points.empty() && !colored.empty());
    require_display(colored.front().png);
    std::vector<Coloring> colorings;
    for (const SurfacePicture& one : colored)
    {
        assert(one.scalar.empty() || one.scalar.size() == points.size());
        colorings.push_back({one.scalar, &one.scale});
    }
    const Pictures pictures =
        draw_sides({points, triangles}, colorings, bounding_box(points).center(),
                   half_width > 0.0 ? half_width : fitting_half_width(points), sides.size(), panel_size);
    std::vector<PngPicture> pages;
    for (std::size_t k = 0; k < colored.size(); ++k)
    {
        std::vector<PagePanel> panels;
        for (std::size_t i = 0; i < sides.size(); ++i)
        {
            panels.push_back({pictures[k * sides.size() + i], 0, i, sides[i].caption});
        }
        pages.push_back({colored[k].png, draw_page(panels, 1, colored[k].scale, title)});
    }
    write_pngs(pages);
}

void render_surface_pair(const std::filesystem::path& png, const std::array<SurfaceInput, 2>& surfaces,
                         const ColorScale& scale, const std::string& title)
{
    require_display(png);
    const double half_width = std::max(fitting_half_width(surfaces[0].points), fitting_half_width(surfaces[1].points));
    std::vector<PagePanel> panels;
    for (std::size_t column = 0; column < surfaces.size(); ++column)
    {
        const SurfaceInput& surface = surfaces[column];
        const std::array coloring{Coloring{surface.scalar, &scale}};
        const Pictures pictures =
            draw_sides({surface.points, surface.triangles}, coloring, bounding_box(surface.points).center(), half_width,
                       sides.size(), panel_size);
        for (std::size_t i = 0; i < sides.size(); ++i)
        {
            panels.push_back({pictures[i], sides.size() - 1 - i, column, surface.caption + ", " + sides[i].caption});
        }
    }
    write_pngs(std::array{PngPicture{png, draw_page(panels, sides.size(), scale, title)}});
}

void render_surface_grid(const std::filesystem::path& png, std::size_t count, std::size_t columns,
                         const std::function<SurfaceTile(std::size_t)>& tile, const ColorScale& scale,
                         const std::string& title)
{
    require_display(png);
    const auto rows = static_cast<int>((count + columns - 1) / columns);
    const int width = static_cast<int>(columns) * tile_width + bar_room;
    const int height = rows * tile_height + title_height;
    vtkNew<vtkRenderer> page;
    page->SetBackground(1, 1, 1);
    for (std::size_t i = 0; i < count; ++i)
    {
        const SurfaceTile one = tile(i);
        const int left = static_cast<int>(i % columns) * tile_width;
        const int bottom = (rows - 1 - static_cast<int>(i / columns)) * tile_height;
        if (!one.points.empty())
        {
            const auto [center, half_width] = extent_of(one.points);
            const std::array coloring{Coloring{one.scalar, &scale}};
            const Pictures pictures =
                draw_sides({one.points, one.triangles}, coloring, center, half_width, 1, tile_picture);
            constexpr int margin = (tile_width - tile_picture) / 2;
            add_image(page, pictures.front(), left + margin, bottom + tile_caption);
        }
        add_text(page, one.caption, left + 0.5 * tile_width, bottom + 0.5 * tile_caption,
                 {.size = caption_size(one.caption)});
    }
    add_text(page, title, 0.5 * width, height - 0.5 * title_height, {.size = 24, .is_bold = true});
    add_color_bar(page, scale, width - bar_room + 10, 0.5 * (height - title_height) - 0.5 * tile_picture + 20,
                  tile_picture - 40);
    write_pngs(std::array{PngPicture{png, draw_renderer(page, width, height)}});
}

} // namespace corticle::view
