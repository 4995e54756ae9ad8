// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/vector_page.hpp"

#include <fmt/format.h>

namespace corticle::view
{

namespace
{

// Widths of the printable letters of ASCII in Helvetica, in thousandths of its size (Adobe font metrics).
constexpr std::array<int, 95> widths{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                     556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                     1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                     667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                     333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                     556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
constexpr int other_width = 556;

/// The characters of UTF-8 as numbers.
std::vector<std::uint32_t> characters(std::string_view text)
{
    std::vector<std::uint32_t> found;
    for (const char letter : text)
    {
        const auto byte = static_cast<unsigned char>(letter);
        if (byte < 0x80)
        {
            found.push_back(byte);
        }
        else if (byte >= 0xc0)
        {
            found.push_back(byte & (byte >= 0xf0 ? 0x07u : byte >= 0xe0 ? 0x0fu : 0x1fu));
        }
        else if (!found.empty())
        {
            found.back() = (found.back() << 6) | (byte & 0x3fu);
        }
    }
    return found;
}

/// As a string of a PDF, in the encoding of Windows for Western Europe.
std::string pdf_string(std::string_view text)
{
    std::string result;
    for (const std::uint32_t c : characters(text))
    {
        const std::uint32_t known = c == 0x3bc ? 0xb5u : c == 0x2212 ? 0x96u : c; // mu, and the minus sign
        const bool is_there = known == 0x96 || (known >= 0x20 && known < 0x7f) || (known >= 0xa0 && known < 0x100);
        if (known == '(' || known == ')' || known == '\\')
        {
            result += '\\';
        }
        result += is_there ? static_cast<char>(known) : '?';
    }
    return fmt::format("({})", result);
}

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text)
    {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string_view(&c, 1);
    }
    return result;
}

std::string css(const Color& color)
{
    return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(255 * color[0] + 0.5),
                       static_cast<int>(255 * color[1] + 0.5), static_cast<int>(255 * color[2] + 0.5));
}

} // namespace

double text_width(std::string_view letters)
{
    int width = 0;
    for (const std::uint32_t c : characters(letters))
    {
        width += c >= 0x20 && c < 0x7f ? widths[c - 0x20] : other_width;
    }
    return width / 1000.0;
}

void VectorPage::line(std::vector<PagePoint> points, const Color& color, double width)
{
    marks_.push_back({Kind::line, std::move(points), color, width, 0, false, {}});
}

void VectorPage::disc(const PagePoint& middle, double radius, const Color& color)
{
    marks_.push_back({Kind::disc, {middle}, color, radius, 0, false, {}});
}

void VectorPage::box(const PagePoint& corner, double width, double height)
{
    marks_.push_back({Kind::box, {corner, {width, height}}, {}, 0.0, 0, false, {}});
}

void VectorPage::text(const PagePoint& at, std::string letters, double size, int align, bool is_bold)
{
    marks_.push_back({Kind::text, {at}, {0.1, 0.1, 0.1}, size, align, is_bold, std::move(letters)});
}

std::string VectorPage::svg_of(const Mark& mark) const
{
    const PagePoint& first = mark.points.front();
    switch (mark.kind)
    {
    case Kind::line:
    {
        std::string places;
        for (const PagePoint& point : mark.points)
        {
            places += fmt::format("{}{:.2f},{:.2f}", places.empty() ? "" : " ", point.x, point.y);
        }
        return fmt::format("<polyline points=\"{}\" stroke=\"{}\" stroke-width=\"{:g}\"/>\n", places, css(mark.color),
                           mark.width);
    }
    case Kind::disc:
        return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:g}\" fill=\"{}\"/>\n", first.x, first.y,
                           mark.width, css(mark.color));
    case Kind::box:
        return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#ffffff\" "
                           "stroke=\"#b4b4b4\"/>\n",
                           first.x, first.y, mark.points[1].x, mark.points[1].y);
    case Kind::text:
        break;
    }
    const char* const anchor = mark.align < 0 ? "start" : mark.align > 0 ? "end" : "middle";
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", first.x,
        first.y, mark.width, anchor, css(mark.color), mark.is_bold ? " font-weight=\"bold\"" : "",
        escaped(mark.letters));
}

std::string VectorPage::pdf_of(const Mark& mark) const
{
    const double x = mark.points.front().x;
    const double y = height_ - mark.points.front().y; // a PDF counts from below
    const auto rgb = [&](const char* name)
    { return fmt::format("{:.3f} {:.3f} {:.3f} {}\n", mark.color[0], mark.color[1], mark.color[2], name); };
    switch (mark.kind)
    {
    case Kind::line:
    {
        std::string places;
        for (const PagePoint& point : mark.points)
        {
            places += fmt::format("{:.2f} {:.2f} {}\n", point.x, height_ - point.y, places.empty() ? "m" : "l");
        }
        return rgb("RG") + fmt::format("{:g} w\n{}S\n", mark.width, places);
    }
    case Kind::disc: // a point with round ends
        return rgb("RG") +
               fmt::format("{:g} w 1 J\n{:.2f} {:.2f} m {:.2f} {:.2f} l S 0 J\n", 2.0 * mark.width, x, y, x, y);
    case Kind::box:
        return fmt::format("1 1 1 rg 0.706 0.706 0.706 RG 1 w\n{:.2f} {:.2f} {:.2f} {:.2f} re B\n", x,
                           y - mark.points[1].y, mark.points[1].x, mark.points[1].y);
    case Kind::text:
        break;
    }
    const double width = mark.width * text_width(mark.letters);
    return rgb("rg") + fmt::format("BT /{} {:g} Tf {:.2f} {:.2f} Td {} Tj ET\n", mark.is_bold ? "F2" : "F1", mark.width,
                                   x - (mark.align < 0   ? 0.0
                                        : mark.align > 0 ? width
                                                         : 0.5 * width),
                                   y, pdf_string(mark.letters));
}

std::string VectorPage::svg() const
{
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
        "font-family=\"Helvetica, Arial, sans-serif\" fill=\"none\" stroke-linejoin=\"round\">\n"
        "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#ffffff\"/>\n",
        width_, height_);
    for (const Mark& mark : marks_)
    {
        text += svg_of(mark);
    }
    return text + "</svg>\n";
}

std::string VectorPage::pdf() const
{
    std::string drawing = "1 j\n";
    for (const Mark& mark : marks_)
    {
        drawing += pdf_of(mark);
    }
    const auto font = [](const char* name)
    { return fmt::format("<< /Type /Font /Subtype /Type1 /BaseFont /{} /Encoding /WinAnsiEncoding >>", name); };
    const std::array<std::string, 6> objects{
        "<< /Type /Catalog /Pages 2 0 R >>",
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:g} {:g}] /Contents 4 0 R /Resources << /Font << /F1 "
                    "5 0 R /F2 6 0 R >> >> >>",
                    width_, height_),
        fmt::format("<< /Length {} >>\nstream\n{}endstream", drawing.size(), drawing),
        font("Helvetica"),
        font("Helvetica-Bold")};
    std::string text = "%PDF-1.4\n";
    std::string places;
    for (std::size_t k = 0; k < objects.size(); ++k)
    {
        places += fmt::format("{:010} 00000 n \n", text.size());
        text += fmt::format("{} 0 obj\n{}\nendobj\n", k + 1, objects[k]);
    }
    return text +
           fmt::format("xref\n0 {0}\n0000000000 65535 f \n{1}trailer\n<< /Size {0} /Root 1 0 R >>\nstartxref\n{2}\n"
                       "%%EOF\n",
                       objects.size() + 1, places, text.size());
}

} // namespace corticle::view
