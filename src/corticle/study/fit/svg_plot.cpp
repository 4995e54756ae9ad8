// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::fit
{

namespace
{

constexpr double width = 360.0; // of a panel [px]
constexpr double height = 270.0;
constexpr double left = 64.0;
constexpr double right = 14.0;
constexpr double top = 28.0;
constexpr double bottom = 46.0;
constexpr double bottom_of_names = 104.0; // below a panel, more where names stand there
constexpr double margin = 0.05;           // of an axis
constexpr double ticks = 5.0;

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return result;
}

/// The part of an axis that is shown.
struct Span
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::isfinite(value) ? std::min(low, value) : low;
        high = std::isfinite(value) ? std::max(high, value) : high;
    }
    void widen()
    {
        if (!(low <= high))
        {
            low = 0.0;
            high = 1.0;
        }
        const double more = high > low ? margin * (high - low) : std::max(std::abs(low), 1.0) * margin;
        low -= more;
        high += more;
    }
    double share(double value) const { return (value - low) / (high - low); }
};

/// Distance of ticks: 1, 2 or 5 times a power of ten.
double tick_step(const Span& span)
{
    const double rough = (span.high - span.low) / ticks;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

/// One panel at a place of the picture.
class PanelWriter
{
  public:
    PanelWriter(const SvgPanel& panel, double x, double y) : panel_(panel), x_(x), y_(y)
    {
        for (const SvgMarks& marks : panel.marks)
        {
            for (const auto* values : {&marks.x, &marks.x_high})
            {
                std::ranges::for_each(*values, [&](double value) { across_.include(value); });
            }
            for (const auto* values : {&marks.y, &marks.y_high})
            {
                std::ranges::for_each(*values, [&](double value) { up_.include(on_axis(value)); });
            }
            if (marks.kind == SvgMarks::Kind::bars)
            {
                up_.include(0.0);
            }
        }
        across_.widen();
        up_.widen();
    }

    std::string write()
    {
        draw_axes();
        for (const SvgMarks& marks : panel_.marks)
        {
            draw(marks);
        }
        return text_;
    }

  private:
    double on_axis(double value) const { return panel_.is_log_y ? std::log10(value) : value; }
    double inner_bottom() const { return panel_.x_names.empty() ? bottom : bottom_of_names; }
    double px(double value) const { return x_ + left + across_.share(value) * (width - left - right); }
    double py(double value) const
    {
        return y_ + height - inner_bottom() - up_.share(on_axis(value)) * (height - top - inner_bottom());
    }

    void draw_axes();
    void draw_x_ticks();
    void draw(const SvgMarks& marks);
    void draw_one(const SvgMarks& marks, std::size_t i);
    void draw_path(const SvgMarks& marks);

    const SvgPanel& panel_;
    double x_;
    double y_;
    Span across_;
    Span up_;
    std::string text_;
};

void PanelWriter::draw_x_ticks()
{
    const double y = y_ + height - inner_bottom() + 14.0;
    for (std::size_t i = 0; i < panel_.x_names.size(); ++i)
    {
        const double x = px(static_cast<double>(i));
        text_ +=
            fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" transform=\"rotate(-40 {:.1f} {:.1f})\">{}"
                        "</text>\n",
                        x + 4.0, y, x + 4.0, y, escaped(panel_.x_names[i]));
    }
    const double step = tick_step(across_);
    for (double at = std::ceil(across_.low / step) * step; panel_.x_names.empty() && at <= across_.high; at += step)
    {
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.4g}</text>\n", px(at), y,
                             std::abs(at) < 1e-9 * step ? 0.0 : at);
    }
}

void PanelWriter::draw_axes()
{
    const double x = x_ + left;
    const double y = y_ + top;
    text_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#888\"/>\n", x, y,
        width - left - right, height - top - inner_bottom());
    draw_x_ticks();
    const double step = tick_step(up_);
    for (double at = std::ceil(up_.low / step) * step; at <= up_.high; at += step)
    {
        const double shown = std::abs(at) < 1e-9 * step ? 0.0 : at;
        const double place = y_ + height - inner_bottom() - up_.share(at) * (height - top - inner_bottom());
        text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#eee\"/>\n", x,
                             place, x_ + width - right, place);
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.4g}</text>\n", x - 4.0,
                             place + 4.0, panel_.is_log_y ? std::pow(10.0, shown) : shown);
    }
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n", x, y - 8.0,
                         escaped(panel_.title));
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                         0.5 * (x + x_ + width - right), y_ + height - 12.0, escaped(panel_.x_label));
    const double middle = y_ + 0.5 * (top + height - inner_bottom());
    text_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 {:.1f} {:.1f})\">{}"
                    "</text>\n",
                    x_ + 12.0, middle, x_ + 12.0, middle, escaped(panel_.y_label));
}

void PanelWriter::draw_path(const SvgMarks& marks)
{
    std::string points;
    for (std::size_t i = 0; i < marks.x.size(); ++i)
    {
        points +=
            std::isfinite(on_axis(marks.y[i])) ? fmt::format("{:.1f},{:.1f} ", px(marks.x[i]), py(marks.y[i])) : "";
    }
    const bool is_band = marks.kind == SvgMarks::Kind::band;
    for (std::size_t i = marks.x.size(); is_band && i-- > 0;)
    {
        points += fmt::format("{:.1f},{:.1f} ", px(marks.x[i]), py(marks.y_high[i]));
    }
    text_ += is_band ? fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", points, marks.colour,
                                   marks.opacity)
                     : fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\"{}\" "
                                   "stroke-width=\"1.5\"/>\n",
                                   points, marks.colour, marks.opacity);
}

void PanelWriter::draw_one(const SvgMarks& marks, std::size_t i)
{
    const double x = px(marks.x[i]);
    const double y = py(marks.y[i]);
    if (!std::isfinite(x) || !std::isfinite(y))
    {
        return;
    }
    if (marks.kind == SvgMarks::Kind::points)
    {
        text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\" fill-opacity=\"{}\"/>\n", x, y,
                             marks.colour, marks.opacity);
    }
    else if (marks.kind == SvgMarks::Kind::whiskers)
    {
        text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
                             "stroke-opacity=\"{}\" stroke-width=\"2\"/>\n",
                             x, y, x, py(marks.y_high[i]), marks.colour, marks.opacity);
    }
    else
    {
        text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
                             "fill-opacity=\"{}\"/>\n",
                             x, std::min(y, py(0.0)), px(marks.x_high[i]) - x, std::abs(py(0.0) - y), marks.colour,
                             marks.opacity);
    }
}

void PanelWriter::draw(const SvgMarks& marks)
{
    if (marks.kind == SvgMarks::Kind::line || marks.kind == SvgMarks::Kind::band)
    {
        draw_path(marks);
        return;
    }
    for (std::size_t i = 0; i < marks.x.size(); ++i)
    {
        draw_one(marks, i);
    }
}

} // namespace

std::string svg_plot(const std::vector<SvgPanel>& panels, int columns)
{
    const int across = std::max(1, std::min<int>(columns, static_cast<int>(panels.size())));
    const int rows = (static_cast<int>(panels.size()) + across - 1) / across;
    std::string text = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                                   "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
                                   "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
                                   width * across, height * rows);
    for (int i = 0; i < static_cast<int>(panels.size()); ++i)
    {
        text += PanelWriter(panels[static_cast<std::size_t>(i)], width * (i % across), height * (i / across)).write();
    }
    return text + "</svg>\n";
}

} // namespace corticle::fit
