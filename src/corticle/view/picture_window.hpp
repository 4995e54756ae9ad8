// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/pictures.hpp"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <span>
#include <string>

class vtkLookupTable;
class vtkRenderer;
class vtkRenderWindow;

namespace corticle::view
{

/// The window in memory that all pictures are drawn in, now of `width` x `height` pixels: to make one takes as long as
/// to draw a picture. Who adds a renderer to it removes it again.
vtkRenderWindow* picture_window(int width, int height);

struct TextStyle
{
    int size = 24;      ///< [px]
    int align = 0;      ///< -1 left, 0 centred, 1 right
    double angle = 0.0; ///< [degrees]
    bool is_bold = false;
};
/// Text at a place of the viewport [px].
void add_text(vtkRenderer* renderer, const std::string& text, double x, double y, const TextStyle& style);

/// An image whose lower left corner is at (x, y) [px].
void add_image(vtkRenderer* renderer, vtkImageData* image, double x, double y);

/// 256 colours of a scale.
void fill_lookup_table(vtkLookupTable* table, const ColorScale& scale);

/// A vertical colour bar with ticks whose lower left corner is at (x, y) [px], `height` tall; its label stands upright
/// on its right. `size` scales texts and the width.
void add_color_bar(vtkRenderer* renderer, const ColorScale& scale, double x, double y, double height,
                   double size = 1.0);

/// Renders, and returns the picture.
vtkSmartPointer<vtkImageData> grab_picture(vtkRenderWindow* window);

/// From two pictures of the same, on white and on black: one with the share that is not the background as a fourth
/// component.
vtkSmartPointer<vtkImageData> with_alpha(vtkImageData* on_white, vtkImageData* on_black);

/// Multiplies the colours, as numbers from 0 to 1, with those of an image of the same size and with a factor; what
/// gets brighter than 1 is 1.
void multiply(vtkImageData* image, vtkImageData* other, double factor);

/// What one renderer shows in a window of `width` x `height` pixels.
vtkSmartPointer<vtkImageData> draw_renderer(vtkRenderer* page, int width, int height);

struct PngPicture
{
    std::filesystem::path png;
    vtkSmartPointer<vtkImageData> image;
};
/// Writes PNGs, each whole or not at all; they are compressed concurrently. @throws RunError
void write_pngs(std::span<const PngPicture> pictures);

} // namespace corticle::view
