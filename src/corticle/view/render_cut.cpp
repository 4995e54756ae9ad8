// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/box.hpp"
#include "corticle/view/color_map.hpp"
#include "corticle/view/display.hpp"
#include "corticle/view/material_section.hpp"
#include "corticle/view/picture_window.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace corticle::view
{

namespace
{

constexpr int picture_width = 1600;
constexpr int picture_height = 800;
constexpr int panel_width = 660; // [px], as are the places below
constexpr int panel_height = 660;
constexpr int panel_bottom = 60;
constexpr int left_panel = 5;
constexpr int right_panel = 800;
constexpr int bar_gap = 10;

/// Half of the width of a panel that the section fits [mm].
double fitting_half_width(const CutInput& input)
{
    const Vec3 size = bounding_box(input.surface_points).size();
    const Plane plane{input.axis, input.coordinate};
    return 0.51 * std::max(size[plane.right()], size[plane.up()]);
}

/// The pixels of a panel, centred on the surface.
PixelGrid pixel_grid(std::span<const Vec3> points, const Plane& plane, double half_width)
{
    const Vec3 center = bounding_box(points).center();
    const double shown = std::max(half_width, std::numeric_limits<double>::min());
    const double pixel = 2.0 * shown / panel_width;
    return {panel_width, panel_height, center[plane.right()] - shown, center[plane.up()] - 0.5 * pixel * panel_height,
            pixel};
}

/// Colours each pixel by the value of its particle; white where there is none.
vtkNew<vtkImageData> colored_image(const PixelGrid& grid, std::span<const std::int32_t> particles,
                                   std::span<const double> values, const ColorScale& scale)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(grid.width, grid.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
    const double span = scale.high > scale.low ? scale.high - scale.low : 1.0;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const Color color =
            particles[i] < 0
                ? Color{1, 1, 1}
                : map_color(scale.map, (values[static_cast<std::size_t>(particles[i])] - scale.low) / span);
        for (std::size_t k = 0; k < 3; ++k)
        {
            pixels[3 * i + k] = static_cast<unsigned char>(std::lround(255.0 * color[k]));
        }
    }
    return image;
}

/// Draws the outline in black, with soft edges, into an image.
void draw_outline(vtkImageData* image, std::span<const Segment> outline, const PixelGrid& grid)
{
    auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
    const std::vector<double> cover = outline_cover(outline, grid);
    for (std::size_t i = 0; i < 3 * cover.size(); ++i)
    {
        pixels[i] = static_cast<unsigned char>(std::lround((1.0 - cover[i / 3]) * pixels[i]));
    }
}

std::string caption_of(const Plane& plane)
{
    constexpr std::string_view names = "xyz";
    const auto name = [&](int axis) { return names[static_cast<std::size_t>(axis)]; };
    const double rounded = std::round(10.0 * plane.coordinate) / 10.0 + 0.0; // no -0
    return fmt::format("section at {} = {:.4g} mm; {} to the right, {} up", name(plane.axis), rounded,
                       name(plane.right()), name(plane.up()));
}

/// What a section shows: the particle of each pixel, and the outline.
struct Section
{
    PixelGrid grid;
    std::vector<Segment> outline;
    std::vector<std::int32_t> shown;
};

Section section_of(const CutInput& input, double half_width)
{
    assert(input.origins.size() == input.positions.size() && input.F.size() == input.positions.size());
    assert(input.theta.size() == input.positions.size() && input.scalar.size() == input.positions.size());
    assert(!input.surface_points.empty() && input.axis >= 0 && input.axis < 3);
    const Plane plane{input.axis, input.coordinate};
    Section section{pixel_grid(input.surface_points, plane, half_width),
                    section_outline(input.surface_points, input.triangles, plane),
                    {}};
    section.shown = material_particles(input, section.grid, inside_mask(section.outline, section.grid));
    return section;
}

void add_panel(vtkRenderer* page, const Section& section, std::span<const double> values, const ColorScale& colors,
               int left)
{
    const vtkNew<vtkImageData> image = colored_image(section.grid, section.shown, values, colors);
    draw_outline(image, section.outline, section.grid);
    add_image(page, image, left, panel_bottom);
    add_color_bar(page, colors, left + panel_width + bar_gap, panel_bottom + 100, panel_height - 200);
}

/// A page with a title; what `fill` adds; written as a PNG.
template <class Fill>
void save_page(const std::filesystem::path& png, const std::string& title, Fill&& fill)
{
    vtkNew<vtkRenderer> page;
    page->SetBackground(1, 1, 1);
    fill(page);
    add_text(page, title, 0.5 * picture_width, picture_height - 30, {.size = 26, .is_bold = true});
    write_pngs(std::array{PngPicture{png, draw_renderer(page, picture_width, picture_height)}});
}

} // namespace

void render_cut(const std::filesystem::path& png, const CutInput& input, const ColorScale& scale,
                const std::string& title, double half_width)
{
    require_display(png);
    const Section section = section_of(input, half_width > 0.0 ? half_width : fitting_half_width(input));
    save_page(
        png, title,
        [&](vtkRenderer* page)
        {
            add_panel(page, section, input.theta, {"cortex fraction [-]", 0.0, 1.0, ColorMap::tissue}, left_panel);
            add_panel(page, section, input.scalar, scale, right_panel);
            add_text(page, caption_of({input.axis, input.coordinate}), 0.5 * picture_width, 25, {.size = 20});
        });
}

void render_cut_pair(const std::filesystem::path& png, const std::array<CutInput, 2>& inputs,
                     const std::array<std::string, 2>& captions, const ColorScale& scale, const std::string& title)
{
    require_display(png);
    const double half_width = std::max(fitting_half_width(inputs[0]), fitting_half_width(inputs[1]));
    save_page(png, title,
              [&](vtkRenderer* page)
              {
                  for (std::size_t i = 0; i < inputs.size(); ++i)
                  {
                      const int left = i == 0 ? left_panel : right_panel;
                      const double middle = left + 0.5 * panel_width;
                      add_panel(page, section_of(inputs[i], half_width), inputs[i].scalar, scale, left);
                      add_text(page, captions[i], middle, panel_bottom + panel_height + 15, {.size = 20});
                      add_text(page, caption_of({inputs[i].axis, inputs[i].coordinate}), middle, 25, {.size = 18});
                  }
              });
}

} // namespace corticle::view
