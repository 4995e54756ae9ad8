// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/pictures.hpp"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace corticle::view
{

/// From where a body is looked at. Frame: x right, y anterior, z superior.
struct View
{
    Vec3 from;           ///< unit, towards who looks
    Vec3 up;             ///< unit
    Vec3 center{};       ///< what stands in the middle of the picture [mm]
    int half = 0;        ///< -1: only what lies below `middle` on x is shown, 1: only what lies above, 0: all
    double middle = 0.0; ///< [mm]
};

/// The surface that is drawn.
struct Body
{
    std::span<const Vec3> points; ///< [mm]
    std::span<const Triangle> triangles;
};

/// One colouring of a body.
struct Coloring
{
    std::span<const double> scalar; ///< of each vertex; empty: 0 everywhere
    const ColorScale* scale;
};

/// Size and scale of the pictures of views.
struct Canvas
{
    int width = 0;  ///< [px]
    int height = 0; ///< [px]
    double mm_per_pixel = 1.0;
    double half_size = 1.0;  ///< half of the length of the body, which shading and depth go by [mm]
    double background = 1.0; ///< grey level, from 0 to 1
};

using Pictures = std::vector<vtkSmartPointer<vtkImageData>>;

/// What each view shows of each colouring: of the first colouring all views, then of the next. Light and shade are
/// drawn once for each view and laid over its colours. One view after the other: the shading of sulci fills a window,
/// not a part of one.
Pictures draw_views(const Body& body, std::span<const Coloring> colorings, std::span<const View> views,
                    const Canvas& canvas);

} // namespace corticle::view
