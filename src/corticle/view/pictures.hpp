// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/formats/field.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/view/color_map.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <future>
#include <string>
#include <utility>
#include <vector>

namespace corticle::view
{

/// Colour scale of a picture.
struct ColorScale
{
    std::string label; ///< name and unit, shown beside the bar
    double low = 0.0;
    double high = 1.0;
    ColorMap map = ColorMap::viridis;
};

/// True when a picture can be rendered: a display, or Xvfb (which is started when there is no display).
/// When false, `reason` says what is missing and how to get it.
bool can_render(std::string& reason);

/// Gets the renderer ready in a thread of its own, for 0.4 s: the first picture of a process then takes no longer than
/// the others. To be called where can_render is true; nothing may be drawn until the future, which waits when it goes,
/// is ready.
std::future<void> start_renderer();

/// One picture of a surface: its colours.
struct SurfacePicture
{
    std::filesystem::path png;
    std::span<const double> scalar; ///< of each vertex; empty: 0 everywhere
    ColorScale scale;
};

/// Renders a surface from two sides, smooth-shaded with clear relief, coloured by a point scalar with a colour bar and
/// a title: PNGs of 1600x800, one for each scalar. `half_width` [mm] fixes the scale (0: fits the body), so that a
/// series of pictures has one scale. Shading costs most and is done once for all.
void render_surface(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    std::span<const SurfacePicture> pictures, const std::string& title, double half_width = 0.0);

/// A surface and what to write below it.
struct SurfaceInput
{
    std::string caption;
    std::span<const Vec3> points; ///< [mm]
    std::span<const Triangle> triangles;
    std::span<const double> scalar; ///< of each vertex
};

/// Two surfaces side by side, each from two sides, with one colour scale and one scale of length (that of the larger).
/// PNG 1600x1550.
void render_surface_pair(const std::filesystem::path& png, const std::array<SurfaceInput, 2>& surfaces,
                         const ColorScale& scale, const std::string& title);

/// One of many surfaces; no points: nothing but its caption is drawn.
struct SurfaceTile
{
    std::string caption;
    std::vector<Vec3> points; ///< [mm]
    std::vector<Triangle> triangles;
    std::vector<double> scalar; ///< of each vertex
};

/// Many surfaces from above, in rows of `columns` from the top left, with one colour scale. Tiles are asked for one
/// after the other. Each surface fills its tile; what has left the body far behind is cut off.
void render_surface_grid(const std::filesystem::path& png, std::size_t count, std::size_t columns,
                         const std::function<SurfaceTile(std::size_t)>& tile, const ColorScale& scale,
                         const std::string& title);

/// Particles, surface and plane of a cross-section, in the current configuration.
struct CutInput
{
    std::span<const Vec3> positions;      ///< particles [mm]
    std::span<const Vec3> origins;        ///< where the particles were before deformation [mm]
    std::span<const Mat3> F;              ///< deformation gradients of the particles [-]
    std::span<const double> theta;        ///< share of cortex in each particle [-]
    std::span<const double> scalar;       ///< what the right panel shows, of each particle
    double spacing = 0.0;                 ///< of the particles before deformation [mm]
    std::span<const Vec3> surface_points; ///< [mm]
    std::span<const Triangle> triangles;
    int axis = 1;            ///< normal to the plane
    double coordinate = 0.0; ///< of the plane along its axis [mm]
};

/// Cross-section: inside the surface every pixel shows the particle that the material there is nearest to, before
/// deformation (see material_section.hpp); the outline of the surface is drawn in black, outside is white. Two panels
/// side by side: left `theta` (cortex red, white matter blue-grey), right `scalar` on its scale. PNG 1600x800.
void render_cut(const std::filesystem::path& png, const CutInput& input, const ColorScale& scale,
                const std::string& title, double half_width = 0.0);

/// Cross-sections of two bodies side by side, as above, each coloured by its scalar, with one colour scale and one
/// scale of length (that of the larger); `captions` go above them. PNG 1600x800.
void render_cut_pair(const std::filesystem::path& png, const std::array<CutInput, 2>& inputs,
                     const std::array<std::string, 2>& captions, const ColorScale& scale, const std::string& title);

struct Curve
{
    std::string label;
    std::vector<double> x;
    std::vector<double> y;
    bool is_points = false; ///< marks the points and draws no line
    bool is_marked = false; ///< marks the points of the line
};
struct Panel
{
    std::string x_label;
    std::string y_label;
    std::vector<Curve> curves;
    std::vector<std::pair<double, std::string>> x_ticks{}; ///< x and what stands there; empty: numbers
};

/// Line plots, panels in a grid (three to a row). The ending of the name decides: PNG, or SVG or PDF, which
/// are lines and letters (write_vector_plot).
void render_plot(const std::filesystem::path& file, std::span<const Panel> panels, const std::string& title);

} // namespace corticle::view
