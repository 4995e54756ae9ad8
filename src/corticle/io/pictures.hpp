// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/triangle_mesh.hpp"
#include "corticle/io/field.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace corticle
{

/// Colour scale of a picture.
struct ColorScale
{
    std::string label;                ///< name and unit, shown beside the bar
    double low = 0.0;
    double high = 1.0;
    std::string map = "viridis";      ///< "viridis" | "coolwarm" (diverging)
};

/// True when a picture can be rendered: a display, or Xvfb (which is started when there is no display).
/// When false, `reason` says what is missing and how to get it.
bool can_render(std::string& reason);

/// Renders a surface from two sides, smooth-shaded with clear relief, coloured by a point scalar with a colour bar and a title. PNG 1600x800.
/// `half_width` [mm] fixes the scale (0: fits the body), so that a series of pictures has one scale.
void render_surface(const std::filesystem::path& png, std::span<const Vec3> points, std::span<const Triangle> triangles,
                    std::span<const double> scalar, const ColorScale& scale, const std::string& title, double half_width = 0.0);

/// Cross-section through the plane `axis` = `coordinate` [mm]: inside the surface every pixel takes the colour of the nearest particle
/// (a Voronoi picture of the cloud), the outline of the surface is drawn in black, outside is white. Two panels side by side:
/// left the scalar `theta` (cortex red, white matter blue-grey), right `scalar` on its scale. PNG 1600x800.
void render_cut(const std::filesystem::path& png, std::span<const Vec3> particles, std::span<const double> theta, std::span<const double> scalar,
                std::span<const Vec3> surface_points, std::span<const Triangle> triangles, const ColorScale& scale, int axis, double coordinate,
                const std::string& title, double half_width = 0.0);

struct Curve
{
    std::string label;
    std::vector<double> x;
    std::vector<double> y;
};
struct Panel
{
    std::string x_label;
    std::string y_label;
    std::vector<Curve> curves;
};

/// Line plots, panels in a grid (three to a row).
void render_plot(const std::filesystem::path& png, std::span<const Panel> panels, const std::string& title);

} // namespace corticle
