// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/figure.hpp"

#include "corticle/base/box.hpp"
#include "corticle/metrics/asymmetry.hpp"
#include "corticle/view/display.hpp"
#include "corticle/view/picture_window.hpp"
#include "corticle/view/plane_section.hpp"
#include "corticle/view/robust_range.hpp"
#include "corticle/view/shaded_views.hpp"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::view
{

namespace
{

constexpr int most_columns = 4;
constexpr double usual_width = 1600.0; // of a page whose texts have their usual size [px], as are the places below
constexpr double bar_room = 170.0;
constexpr double title_room = 60.0;
constexpr double caption_room = 44.0;
constexpr double foot_room = 54.0;
constexpr double margin = 1.2; // room for the marks beside the body

double size_of(int width)
{
    return std::max(0.5, width / usual_width);
}

int even(double pixels)
{
    return 2 * static_cast<int>(std::lround(0.5 * pixels));
}

/// Which half a view shows of this body.
int half_of(const AnatomicalView& view, const BodySides& sides)
{
    return sides.part == imaging::Hemisphere::both ? view.half : 0;
}

/// What a view shows of points: its middle, and its size to the right and upwards [mm].
struct Extent
{
    Vec3 middle;
    double right = 0.0;
    double up = 0.0;
};

Extent extent_of(const AnatomicalView& view, int half, std::span<const Vec3> points)
{
    const double middle = metrics::mid_sagittal_plane(points).point.x;
    Box box; // along right, up, and towards the viewer
    for (const Vec3& point : points)
    {
        if (half * (point.x - middle) >= 0.0)
        {
            box.include({dot(point, view.right()), dot(point, view.up), dot(point, view.from)});
        }
    }
    const Vec3 c = box.center();
    return {c.x * view.right() + c.y * view.up + c.z * view.from, box.size().x, box.size().y};
}

/// Pixels of a view of a plane across x, whose columns go along y.
PixelGrid grid_of(const FigureLayout& layout, int height, const Vec3& center)
{
    return {layout.panel_width, height, center.y - 0.5 * layout.panel_width * layout.mm_per_pixel,
            center.z - 0.5 * height * layout.mm_per_pixel, layout.mm_per_pixel};
}

/// Paints the face of the cut over the picture of a view across it.
void paint_face(vtkImageData* image, const Figure& figure, const View& view, const FigureLayout& layout)
{
    const PixelGrid grid = grid_of(layout, image->GetDimensions()[1], view.center);
    const Plane plane{0, view.middle};
    const std::vector<Segment> outline = section_outline(figure.points, figure.triangles, plane);
    const std::vector<std::uint8_t> inside = inside_mask(outline, grid);
    const std::vector<double> line = outline_cover(outline, grid);
    const std::vector<std::uint8_t> white =
        figure.boundary.empty() ? std::vector<std::uint8_t>(inside.size())
                                : inside_mask(section_outline(figure.boundary, figure.triangles, plane), grid);
    const Color cortex = figure.boundary.empty() ? Color{0.8, 0.8, 0.8} : map_color(ColorMap::tissue, 1.0);
    const Color inner = map_color(ColorMap::tissue, 0.0);
    auto* const pixels = static_cast<unsigned char*>(image->GetScalarPointer());
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
        const std::size_t row = i / static_cast<std::size_t>(grid.width);
        const std::size_t column = i % static_cast<std::size_t>(grid.width);
        const std::size_t shown = view.from.x > 0.0 ? column : static_cast<std::size_t>(grid.width) - 1 - column;
        unsigned char* const pixel = pixels + 3 * (row * static_cast<std::size_t>(grid.width) + shown);
        for (std::size_t c = 0; c < 3; ++c)
        {
            const double color = inside[i] == 0 ? pixel[c] / 255.0 : white[i] != 0 ? inner[c] : cortex[c];
            pixel[c] = static_cast<unsigned char>(std::lround(255.0 * (1.0 - line[i]) * color));
        }
    }
}

/// Where the cut faces whoever looks.
bool shows_face(const View& view)
{
    return view.half != 0 && view.half * view.from.x < -0.99;
}

/// A dark bar of a round length, with its length above.
void add_scale_bar(vtkRenderer* page, double x, double y, const FigureLayout& layout)
{
    const double size = size_of(layout.width);
    const double length = round_step(0.22 * layout.panel_width * layout.mm_per_pixel, 1);
    const int pixels = std::max(1, static_cast<int>(std::lround(length / layout.mm_per_pixel)));
    const int thick = std::max(2, static_cast<int>(std::lround(5 * size)));
    vtkNew<vtkImageData> bar;
    bar->SetDimensions(pixels, thick, 1);
    bar->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::fill_n(static_cast<unsigned char*>(bar->GetScalarPointer()), 3 * pixels * thick,
                static_cast<unsigned char>(26));
    add_image(page, bar, x, y);
    add_text(page, fmt::format("{:g} mm", length), x + 0.5 * pixels, y + 20 * size,
             {.size = static_cast<int>(20 * size)});
}

std::vector<View> looks_of(const Figure& figure)
{
    std::vector<View> looks;
    for (const AnatomicalView& view : figure.views)
    {
        const int half = half_of(view, figure.sides);
        looks.push_back({view.from, view.up, extent_of(view, half, figure.points).middle, half,
                         metrics::mid_sagittal_plane(figure.points).point.x});
    }
    return looks;
}

void add_panel(vtkRenderer* page, vtkImageData* picture, const AnatomicalView& view, const Figure& figure,
               const FigureLayout& layout, double x, double y)
{
    const double size = size_of(layout.width);
    const auto text = [size](int pixels) { return static_cast<int>(std::lround(size * pixels)); };
    add_image(page, picture, x, y + caption_room * size);
    const auto marks = side_marks(view, figure.sides.is_brain);
    const double middle = y + caption_room * size + 0.5 * picture->GetDimensions()[1];
    add_text(page, marks[0], x + 4 * size, middle, {.size = text(20), .align = -1, .is_bold = true});
    add_text(page, marks[1], x + layout.panel_width - 4 * size, middle,
             {.size = text(20), .align = 1, .is_bold = true});
    add_text(page, std::string(figure.sides.is_brain ? view.words : view.plain_words), x + 0.5 * layout.panel_width,
             y + 0.5 * caption_room * size, {.size = text(20)});
}

/// Row `row` of the panels, its lower edge at y. Says whether a face of a cut is seen.
bool add_row(vtkRenderer* page, std::size_t row, double y, const Figure& figure, const FigureLayout& layout,
             double background)
{
    const std::vector<View> all = looks_of(figure);
    const std::size_t first = row * static_cast<std::size_t>(layout.columns);
    const std::span<const View> looks =
        std::span(all).subspan(first, std::min(static_cast<std::size_t>(layout.columns), all.size() - first));
    const std::array coloring{Coloring{figure.scalar, &figure.scale}};
    const Pictures pictures =
        draw_views({figure.points, figure.triangles}, coloring, looks,
                   {layout.panel_width, layout.panel_heights[row], layout.mm_per_pixel, layout.half_size, background});
    for (std::size_t i = 0; i < looks.size(); ++i)
    {
        if (shows_face(looks[i]))
        {
            paint_face(pictures[i], figure, looks[i], layout);
        }
        add_panel(page, pictures[i], figure.views[first + i], figure, layout,
                  static_cast<double>(i) * layout.panel_width, y);
    }
    return std::ranges::any_of(looks, shows_face);
}

/// The page on one background, white or black.
vtkSmartPointer<vtkImageData> draw_page(const Figure& figure, const FigureLayout& layout, double background)
{
    const double size = size_of(layout.width);
    const auto text = [size](int pixels) { return static_cast<int>(std::lround(size * pixels)); };
    vtkNew<vtkRenderer> page;
    page->SetBackground(background, background, background);
    const double top = layout.height - title_room * size;
    const double foot = foot_room * size;
    double y = top;
    bool has_face = false;
    for (std::size_t row = 0; row < layout.panel_heights.size(); ++row)
    {
        y -= layout.panel_heights[row] + caption_room * size;
        has_face = add_row(page, row, y, figure, layout, background) || has_face;
    }
    const double bar_height = std::min(500.0 * size, 0.75 * (top - foot));
    add_color_bar(page, figure.scale, layout.width - (bar_room - 12) * size, 0.5 * (foot + top - bar_height),
                  bar_height, size);
    add_text(page, figure.title, 0.5 * layout.columns * layout.panel_width, top + 0.5 * title_room * size,
             {.size = text(26), .is_bold = true});
    add_scale_bar(page, 24 * size, 12 * size, layout);
    if (has_face && !figure.boundary.empty())
    {
        add_text(page, "face of the cut: cortex red, white matter pale blue", layout.columns * layout.panel_width,
                 22 * size, {.size = text(18), .align = 1});
    }
    return draw_renderer(page, layout.width, layout.height);
}

} // namespace

FigureLayout figure_layout(std::span<const AnatomicalView> views, const BodySides& sides,
                           std::span<const std::span<const Vec3>> shapes, int width)
{
    const double size = size_of(width);
    FigureLayout layout;
    layout.width = even(width);
    layout.columns = std::min(most_columns, static_cast<int>(views.size()));
    layout.panel_width = static_cast<int>((layout.width - bar_room * size) / layout.columns);
    const std::size_t columns = static_cast<std::size_t>(layout.columns);
    double right = std::numeric_limits<double>::min();                     // the largest of all views [mm]
    std::vector<double> up((views.size() + columns - 1) / columns, right); // the largest of each row [mm]
    layout.half_size = right;
    for (const std::span<const Vec3> points : shapes)
    {
        for (std::size_t i = 0; i < views.size(); ++i)
        {
            const Extent extent = extent_of(views[i], half_of(views[i], sides), points);
            right = std::max(right, extent.right);
            up[i / columns] = std::max(up[i / columns], extent.up);
        }
        layout.half_size = std::max(layout.half_size, bounding_box(points).half_width());
    }
    layout.mm_per_pixel = margin * right / layout.panel_width;
    double height = (foot_room + title_room) * size;
    for (const double row : up)
    {
        layout.panel_heights.push_back(static_cast<int>(std::ceil(1.04 * row / layout.mm_per_pixel)));
        height += layout.panel_heights.back() + caption_room * size;
    }
    layout.height = even(height);
    return layout;
}

void render_figure(const std::filesystem::path& png, const Figure& figure, const FigureLayout& layout,
                   bool is_transparent)
{
    require_display(png);
    vtkSmartPointer<vtkImageData> picture = draw_page(figure, layout, 1.0);
    if (is_transparent)
    {
        picture = with_alpha(picture, draw_page(figure, layout, 0.0));
    }
    write_pngs(std::array{PngPicture{png, picture}});
}

} // namespace corticle::view
