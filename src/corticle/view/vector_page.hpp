// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/color_map.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::view
{

/// A place on a page [px], from the upper left corner.
struct PagePoint
{
    double x = 0.0;
    double y = 0.0;
};

/// A page of lines and letters, as SVG or PDF.
class VectorPage
{
  public:
    VectorPage(double width, double height) : width_(width), height_(height) {}

    void line(std::vector<PagePoint> points, const Color& color, double width);
    void disc(const PagePoint& middle, double radius, const Color& color);
    /// A white rectangle with a thin frame.
    void box(const PagePoint& corner, double width, double height);
    /// UTF-8, of the letters of Western Europe; others become "?" in a PDF.
    /// @param align  -1 left, 0 centred, 1 right
    void text(const PagePoint& at, std::string letters, double size, int align, bool is_bold = false);

    std::string svg() const;
    std::string pdf() const;

  private:
    enum class Kind
    {
        line,
        disc,
        box,
        text
    };
    struct Mark
    {
        Kind kind = Kind::line;
        std::vector<PagePoint> points;
        Color color{};
        double width = 0.0; ///< of a line, radius of a disc, size of letters
        int align = 0;
        bool is_bold = false;
        std::string letters;
    };
    std::string svg_of(const Mark& mark) const;
    std::string pdf_of(const Mark& mark) const;

    double width_;
    double height_;
    std::vector<Mark> marks_;
};

/// Width of letters of Helvetica of size 1, which Arial shares; others than those of ASCII count as "n".
double text_width(std::string_view letters);

} // namespace corticle::view
