// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/figures/anatomy.hpp"
#include "corticle/view/pictures.hpp"

#include <filesystem>
#include <vector>

namespace corticle::view
{

/// A surface as papers show it: several views on one page, with marks of the sides, a scale bar and a colour bar.
struct Figure
{
    std::span<const Vec3> points; ///< [mm]
    std::span<const Triangle> triangles;
    std::span<const Vec3>
        boundary; ///< of cortex and white matter below each vertex, or empty: shown where a half is cut
    std::span<const double> scalar; ///< of each vertex
    ColorScale scale;
    std::string title;
    std::span<const AnatomicalView> views;
    BodySides sides;
};

/// Sizes of a page and its one scale of length, so that pictures of a series have the same.
struct FigureLayout
{
    int width = 0; ///< of the page [px], as are all but the last two
    int height = 0;
    int columns = 1;
    int panel_width = 0;
    std::vector<int> panel_heights; ///< of each row, from above
    double mm_per_pixel = 1.0;
    double half_size = 1.0; ///< half of the length of the body [mm]
};

/// A page `width` pixels wide that all the shapes, in turn, fit; sizes are even, as videos need them.
FigureLayout figure_layout(std::span<const AnatomicalView> views, const BodySides& sides,
                           std::span<const std::span<const Vec3>> shapes, int width);

/// Draws a page as a PNG. Halves are cut in the middle across x, unless the body is one hemisphere; the face of the cut
/// shows cortex and white matter where the boundary is known.
/// @param is_transparent  nothing behind the body and the texts, instead of white
void render_figure(const std::filesystem::path& png, const Figure& figure, const FigureLayout& layout,
                   bool is_transparent);

} // namespace corticle::view
