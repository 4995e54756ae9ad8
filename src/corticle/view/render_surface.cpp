// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/box.hpp"
#include "corticle/view/display.hpp"
#include "corticle/view/picture_window.hpp"
#include "corticle/view/pictures.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
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
constexpr double grey = 0.5; // what is lit, so that light can make colours brighter than they are

constexpr int tile_picture = 380; // of a grid
constexpr int tile_caption = 48;
constexpr int tile_width = 400;
constexpr int tile_height = tile_picture + tile_caption + 4;
constexpr int bar_room = 150;

constexpr std::array<int, 2> panel_left{10, 730};

/// From where a panel looks. Frame: x right, y anterior, z superior.
struct View
{
    Vec3 from;
    Vec3 up;
    const char* caption;
};

constexpr std::array<View, 2> views{
    {{{0, 0, 1}, {0, 1, 0}, "from above (+z)"}, {{1, 0, 0}, {0, 0, 1}, "from the right (+x)"}}};

vtkNew<vtkPolyData> polydata_of(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    const std::vector<Vec3> normals = vertex_normals(points, triangles);
    vtkNew<vtkPoints> positions;
    vtkNew<vtkFloatArray> directions;
    directions->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        positions->InsertNextPoint(points[i].x, points[i].y, points[i].z);
        directions->InsertNextTuple3(normals[i].x, normals[i].y, normals[i].z);
    }
    vtkNew<vtkCellArray> cells;
    for (const Triangle& triangle : triangles)
    {
        const std::array<vtkIdType, 3> corners{triangle[0], triangle[1], triangle[2]};
        cells->InsertNextCell(3, corners.data());
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(positions);
    surface->SetPolys(cells);
    surface->GetPointData()->SetNormals(directions);
    return surface;
}

/// A key light from the upper left and a weaker one beside the camera: sulci stay readable, gyri get a bright and a
/// dark flank.
void add_lights(vtkRenderer* renderer)
{
    const auto add = [&](const Vec3& from, double intensity)
    {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(from.x, from.y, from.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(intensity);
        renderer->AddLight(light);
    };
    renderer->SetAutomaticLightCreation(false);
    add({-1.0, 1.1, 1.4}, 0.72);
    add({0.7, -0.4, 1.0}, 0.45);
}

/// Darkens what lies in sulci (ambient occlusion in screen space) and softens edges; `radius` [mm] is how far away a
/// wall still shades.
void add_occlusion(vtkRenderer* renderer, double radius)
{
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> occlusion;
    occlusion->SetRadius(radius);
    occlusion->SetBias(0.05 * radius);
    occlusion->SetKernelSize(16);
    occlusion->BlurOn();
    occlusion->SetDelegatePass(steps);
    vtkNew<vtkOpenGLFXAAPass> smooth;
    smooth->SetDelegatePass(occlusion);
    renderer->SetPass(smooth);
}

void look(vtkRenderer* renderer, const View& view, const Vec3& center, double half_width)
{
    const Vec3 position = center + 10.0 * half_width * view.from;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(center.x, center.y, center.z);
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetViewUp(view.up.x, view.up.y, view.up.z);
    camera->SetParallelScale(half_width);
    camera->SetClippingRange(7.0 * half_width, 13.0 * half_width);
}

/// The body in grey.
vtkNew<vtkActor> body_of(vtkPolyData* surface)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    vtkNew<vtkActor> body;
    body->SetMapper(mapper);
    body->GetProperty()->SetInterpolationToPhong();
    body->GetProperty()->SetColor(grey, grey, grey);
    body->GetProperty()->SetDiffuse(0.9);
    body->GetProperty()->SetSpecularPower(25);
    return body;
}

/// One colouring of a body.
struct Coloring
{
    std::span<const double> scalar; ///< of each vertex; empty: 0 everywhere
    const ColorScale* scale;
};

vtkNew<vtkDoubleArray> array_of(std::span<const double> scalar, std::size_t count)
{
    vtkNew<vtkDoubleArray> values;
    for (std::size_t i = 0; i < count; ++i)
    {
        values->InsertNextValue(scalar.empty() ? 0.0 : scalar[i]);
    }
    return values;
}

using Pictures = std::vector<vtkSmartPointer<vtkImageData>>;

/// What each view shows of each colouring, `size` pixels square: of the first colouring all views, then of the next.
/// Light and shade are drawn once for each view and laid over its colours. One view after the other: the shading of
/// sulci fills a window, not a part of one.
Pictures draw_views(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    std::span<const Coloring> colorings, const Vec3& center, double half_width,
                    std::span<const View> shown, int size)
{
    vtkRenderWindow* const window = picture_window(size, size);
    vtkNew<vtkRenderer> renderer;
    const vtkNew<vtkPolyData> surface = polydata_of(points, triangles);
    const vtkNew<vtkActor> body = body_of(surface);
    renderer->AddActor(body);
    add_lights(renderer);
    window->AddRenderer(renderer);

    body->GetProperty()->SetAmbient(0.16);
    body->GetProperty()->SetSpecular(0.1);
    body->GetMapper()->ScalarVisibilityOff();
    renderer->SetBackground(grey, grey, grey);
    add_occlusion(renderer, 0.12 * half_width);
    Pictures shades;
    for (const View& view : shown)
    {
        look(renderer, view, center, half_width);
        shades.push_back(grab_picture(window));
    }

    body->GetProperty()->LightingOff();
    body->GetProperty()->SetAmbient(1.0);
    body->GetProperty()->SetDiffuse(0.0);
    body->GetMapper()->ScalarVisibilityOn();
    renderer->SetBackground(1, 1, 1);
    renderer->GetPass()->ReleaseGraphicsResources(window);
    renderer->SetPass(nullptr);
    renderer->UseFXAAOn();
    Pictures pictures;
    for (const Coloring& coloring : colorings)
    {
        vtkNew<vtkLookupTable> colors;
        fill_lookup_table(colors, *coloring.scale);
        body->GetMapper()->SetLookupTable(colors);
        surface->GetPointData()->SetScalars(array_of(coloring.scalar, points.size()));
        for (std::size_t i = 0; i < shown.size(); ++i)
        {
            look(renderer, shown[i], center, half_width);
            pictures.push_back(grab_picture(window));
            multiply(pictures.back(), shades[i], 1.0 / grey);
        }
    }
    window->RemoveRenderer(renderer);
    return pictures;
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
    return std::async(std::launch::async,
                      []
                      {
                          const std::array<Vec3, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}};
                          const std::array<Triangle, 1> triangle{{{0, 1, 2}}};
                          const ColorScale scale{"one", 0.0, 1.0};
                          const std::array coloring{Coloring{{}, &scale}};
                          const Pictures drawn = draw_views(corners, triangle, coloring, corners[0], 1.0, views, 8);
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
    const Pictures pictures = draw_views(points, triangles, colorings, bounding_box(points).center(),
                                         half_width > 0.0 ? half_width : fitting_half_width(points), views, panel_size);
    std::vector<PngPicture> pages;
    for (std::size_t k = 0; k < colored.size(); ++k)
    {
        std::vector<PagePanel> panels;
        for (std::size_t i = 0; i < views.size(); ++i)
        {
            panels.push_back({pictures[k * views.size() + i], 0, i, views[i].caption});
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
        const Pictures pictures = draw_views(surface.points, surface.triangles, coloring,
                                             bounding_box(surface.points).center(), half_width, views, panel_size);
        for (std::size_t i = 0; i < views.size(); ++i)
        {
            panels.push_back({pictures[i], views.size() - 1 - i, column, surface.caption + ", " + views[i].caption});
        }
    }
    write_pngs(std::array{PngPicture{png, draw_page(panels, views.size(), scale, title)}});
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
                draw_views(one.points, one.triangles, coloring, center, half_width, {views.data(), 1}, tile_picture);
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
