// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/run_reader.hpp"
#include "corticle/view/figures/figure.hpp"

#include <vector>

namespace corticle::view
{

/// The surface of a run at one time, with the arrays that are drawn.
struct Shape
{
    double t = 0.0;
    double week = 0.0;        ///< NaN where it is not known
    std::vector<Vec3> points; ///< [mm]
    std::vector<Triangle> triangles;
    std::vector<Vec3> boundary;               ///< of cortex and white matter, or empty [mm]
    std::vector<std::vector<double>> scalars; ///< in the order asked for
};

/// Numbers of all output times.
std::vector<std::size_t> every_frame(const record::RunContents& run);

/// @throws InputError naming an array that the surface files do not hold, and those that they do
std::vector<Shape> read_shapes(const record::RunContents& run, std::span<const std::size_t> frames,
                               std::span<const std::string> arrays);

/// Between two shapes of the same triangles: linear, `share` of the second. A number that one of them lacks is missing.
Shape between(const Shape& a, const Shape& b, double share);

/// How the shapes of one series are looked at.
struct FigureLook
{
    std::span<const AnatomicalView> views;
    BodySides sides;
    FigureLayout layout;
    bool is_transparent = false;
};

FigureLook look_at(std::span<const AnatomicalView> views, const BodySides& sides, std::span<const Shape> shapes,
                   int width, bool is_transparent);

/// Draws a shape by its array `number`, under its week or time.
void render_shape(const std::filesystem::path& png, const Shape& shape, std::size_t number, const ColorScale& scale,
                  const FigureLook& look);

} // namespace corticle::view
