// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/picture_window.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/quiet_vtk.hpp"
#include "corticle/view/color_map.hpp"
#include "corticle/view/robust_range.hpp"

#include <fmt/format.h>

#include <vtkActor2D.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::view
{

namespace
{

constexpr int bar_width = 28; // [px]
constexpr int tick_count = 5;
constexpr std::int64_t most_regions = 65535;

unsigned char byte_of(double intensity)
{
    return static_cast<unsigned char>(std::lround(255.0 * intensity));
}

/// The bar as an image, framed by a dark line of one pixel.
vtkNew<vtkImageData> bar_image(const ColorScale& scale, int width, int height)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < height; ++y)
    {
        const double share = static_cast<double>(y) / (height - 1);
        const Color color = scale.map == ColorMap::regions
                                ? region_color(std::lround(scale.low + share * (scale.high - scale.low)))
                                : map_color(scale.map, share);
        for (int x = 0; x < width; ++x)
        {
            const bool is_frame = x == 0 || y == 0 || x == width - 1 || y == height - 1;
            auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
            for (std::size_t i = 0; i < 3; ++i)
            {
                pixel[i] = is_frame ? 60 : byte_of(color[i]);
            }
        }
    }
    return image;
}

std::string tick_text(const ColorScale& scale, double value)
{
    const double span = std::abs(scale.high - scale.low);
    return fmt::format("{:.4g}", std::abs(value) < 1e-9 * span ? 0.0 : value);
}

} // namespace

vtkRenderWindow* picture_window(int width, int height)
{
    // Never deleted: at the end of the program the display may have gone before it.
    static vtkRenderWindow* const window = []
    {
        formats::silence_vtk();
        vtkRenderWindow* const made = vtkRenderWindow::New();
        made->SetShowWindow(false);
        made->SetOffScreenRendering(1);
        made->SetMultiSamples(0); // lines and text are smooth without, the edges of surfaces are smoothed afterwards
        return made;
    }();
    window->SetSize(width, height);
    return window;
}

void add_text(vtkRenderer* renderer, const std::string& text, double x, double y, const TextStyle& style)
{
    vtkNew<vtkTextActor> actor;
    actor->SetInput(text.c_str());
    actor->SetDisplayPosition(static_cast<int>(x), static_cast<int>(y));
    vtkTextProperty* property = actor->GetTextProperty();
    property->SetFontFamilyToArial();
    property->SetFontSize(style.size);
    property->SetColor(0.1, 0.1, 0.1);
    property->SetBold(style.is_bold);
    property->SetOrientation(style.angle);
    property->SetJustification(style.align + 1); // VTK: 0 left, 1 centred, 2 right
    property->SetVerticalJustificationToCentered();
    renderer->AddActor2D(actor);
}

void add_image(vtkRenderer* renderer, vtkImageData* image, double x, double y)
{
    vtkNew<vtkImageMapper> mapper;
    mapper->SetInputData(image);
    mapper->SetColorWindow(255);
    mapper->SetColorLevel(127.5);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(x, y);
    renderer->AddActor2D(actor);
}

void fill_lookup_table(vtkLookupTable* table, const ColorScale& scale)
{
    table->SetNanColor(0.5, 0.5, 0.5, 1.0);
    if (scale.map == ColorMap::regions)
    {
        const auto first = static_cast<std::int64_t>(std::lround(scale.low));
        const auto last = std::min(static_cast<std::int64_t>(std::lround(scale.high)), first + most_regions);
        table->SetNumberOfTableValues(last - first + 1);
        table->SetRange(static_cast<double>(first) - 0.5, static_cast<double>(last) + 0.5);
        for (std::int64_t label = first; label <= last; ++label)
        {
            const Color color = region_color(label);
            table->SetTableValue(label - first, color[0], color[1], color[2]);
        }
        return;
    }
    constexpr int colors = 256;
    table->SetNumberOfTableValues(colors);
    table->SetRange(scale.low, scale.high > scale.low ? scale.high : scale.low + 1.0);
    for (int i = 0; i < colors; ++i)
    {
        const Color color = map_color(scale.map, static_cast<double>(i) / (colors - 1));
        table->SetTableValue(i, color[0], color[1], color[2]);
    }
}

void add_color_bar(vtkRenderer* renderer, const ColorScale& scale, double x, double y, double height, double size)
{
    const int width = static_cast<int>(size * bar_width);
    const auto text = [size](int pixels) { return static_cast<int>(std::lround(size * pixels)); };
    add_image(renderer, bar_image(scale, width, static_cast<int>(height)), x, y);
    for (const double value : round_ticks(scale.low, scale.high, tick_count))
    {
        if (scale.map == ColorMap::regions && value != std::round(value))
        {
            continue; // labels are whole numbers
        }
        const double fraction = (value - scale.low) / (scale.high > scale.low ? scale.high - scale.low : 1.0);
        add_text(renderer, tick_text(scale, value), x + width + 8 * size, y + fraction * height,
                 {.size = text(20), .align = -1});
    }
    add_text(renderer, scale.label, x + width + 78 * size, y + 0.5 * height, {.size = text(22), .angle = 90});
}

vtkSmartPointer<vtkImageData> grab_picture(vtkRenderWindow* window)
{
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->Update();
    return grab->GetOutput();
}

vtkSmartPointer<vtkImageData> draw_renderer(vtkRenderer* page, int width, int height)
{
    vtkRenderWindow* const window = picture_window(width, height);
    window->AddRenderer(page);
    vtkSmartPointer<vtkImageData> drawn = grab_picture(window);
    window->RemoveRenderer(page);
    return drawn;
}

void multiply(vtkImageData* image, vtkImageData* other, double factor)
{
    const auto count = static_cast<std::ptrdiff_t>(3) * image->GetDimensions()[0] * image->GetDimensions()[1];
    auto* const to = static_cast<unsigned char*>(image->GetScalarPointer());
    const auto* const by = static_cast<const unsigned char*>(other->GetScalarPointer());
    for (std::ptrdiff_t k = 0; k < count; ++k)
    {
        to[k] = byte_of(std::min(1.0, factor * to[k] * by[k] / (255.0 * 255.0)));
    }
}

vtkSmartPointer<vtkImageData> with_alpha(vtkImageData* on_white, vtkImageData* on_black)
{
    vtkNew<vtkImageData> image;
    const int* const size = on_white->GetDimensions();
    image->SetDimensions(size[0], size[1], 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    const auto count = static_cast<std::ptrdiff_t>(size[0]) * size[1];
    const auto* const white = static_cast<const unsigned char*>(on_white->GetScalarPointer());
    const auto* const black = static_cast<const unsigned char*>(on_black->GetScalarPointer());
    auto* const to = static_cast<unsigned char*>(image->GetScalarPointer());
    for (std::ptrdiff_t k = 0; k < count; ++k)
    {
        int through = 255; // what of the background shows; colours are those on black over the rest
        for (int c = 0; c < 3; ++c)
        {
            through = std::min(through, std::max(0, white[3 * k + c] - black[3 * k + c]));
        }
        const int alpha = 255 - through;
        for (int c = 0; c < 3; ++c)
        {
            to[4 * k + c] = static_cast<unsigned char>(alpha == 0 ? 0 : std::min(255, 255 * black[3 * k + c] / alpha));
        }
        to[4 * k + 3] = static_cast<unsigned char>(alpha);
    }
    return image;
}

void write_pngs(std::span<const PngPicture> pictures)
{
    std::vector<vtkSmartPointer<vtkPNGWriter>> writers;
    for (const PngPicture& picture : pictures)
    {
        writers.push_back(vtkSmartPointer<vtkPNGWriter>::New());
        writers.back()->SetCompressionLevel(2);
        writers.back()->SetInputData(picture.image);
        writers.back()->WriteToMemoryOn();
    }
    parallel_blocks(
        std::ssize(writers), [&](std::int64_t k, std::int64_t /*end*/) { writers[k]->Write(); }, 1);
    for (std::size_t k = 0; k < pictures.size(); ++k)
    {
        vtkUnsignedCharArray* const result = writers[k]->GetResult();
        const vtkIdType size = result == nullptr ? 0 : result->GetNumberOfValues();
        if (size == 0 || writers[k]->GetErrorCode() != 0)
        {
            throw RunError(fmt::format("cannot draw {}: rendering failed", pictures[k].png.string()));
        }
        const auto* bytes = reinterpret_cast<const char*>(result->GetPointer(0));
        formats::write_text_atomically(pictures[k].png, std::string_view(bytes, static_cast<std::size_t>(size)));
    }
}

} // namespace corticle::view
