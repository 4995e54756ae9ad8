// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/vector_plot.hpp"

#include "corticle/formats/atomic_file.hpp"
#include "corticle/view/robust_range.hpp"
#include "corticle/view/vector_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::view
{

namespace
{

constexpr int columns = 3; // places and sizes in [px]
constexpr double panel_width = 400.0;
constexpr double panel_height = 290.0;
constexpr double title_height = 44.0;
constexpr double left = 62.0; // of the axes in their panel
constexpr double right = 18.0;
constexpr double top = 34.0;
constexpr double bottom = 52.0;
constexpr double letter = 13.0;
constexpr Color grid_color{0.89, 0.89, 0.89};
constexpr Color axis_color{0.24, 0.24, 0.24};

bool is_shown(const Curve& curve, std::size_t i)
{
    return std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]);
}

std::size_t count_of(const Curve& curve)
{
    return std::min(curve.x.size(), curve.y.size());
}

/// From the least to the largest of the numbers that are shown, and some room beside.
Range range_of(const Panel& panel, std::vector<double> Curve::*numbers, double room)
{
    std::vector<double> all;
    for (const Curve& curve : panel.curves)
    {
        for (std::size_t i = 0; i < count_of(curve); ++i)
        {
            if (is_shown(curve, i))
            {
                all.push_back((curve.*numbers)[i]);
            }
        }
    }
    const Range full = full_range(all);
    const double size = full.high - full.low;
    const double margin = size > 0.0 ? room * size : std::max(0.05 * std::abs(full.low), 1e-3);
    return size > 0.0 || !all.empty() ? Range{full.low - margin, full.high + margin} : full;
}

/// Axes of a panel: from numbers to places on the page.
struct Axes
{
    PagePoint corner; ///< upper left, of the axes
    Range x;
    Range y;

    static constexpr double width = panel_width - left - right;
    static constexpr double height = panel_height - top - bottom;
    PagePoint at(double a, double b) const
    {
        return {corner.x + width * (a - x.low) / (x.high - x.low),
                corner.y + height * (1.0 - (b - y.low) / (y.high - y.low))};
    }
};

void draw_axes(VectorPage& page, const Panel& panel, const Axes& axes)
{
    const double step = axes.y.high - axes.y.low;
    const auto number = [](double value, double size)
    { return fmt::format("{:.6g}", std::abs(value) < 1e-9 * size ? 0.0 : value); };
    for (const double y : round_ticks(axes.y.low, axes.y.high, 5))
    {
        page.line({axes.at(axes.x.low, y), axes.at(axes.x.high, y)}, grid_color, 1.0);
        const PagePoint at = axes.at(axes.x.low, y);
        page.text({at.x - 6.0, at.y + 0.35 * letter}, number(y, step), letter, 1);
    }
    std::vector<std::pair<double, std::string>> ticks = panel.x_ticks;
    for (const double x : ticks.empty() ? round_ticks(axes.x.low, axes.x.high, 6) : std::vector<double>{})
    {
        ticks.emplace_back(x, number(x, axes.x.high - axes.x.low));
    }
    for (const auto& [x, words] : ticks)
    {
        page.line({axes.at(x, axes.y.low), axes.at(x, axes.y.high)}, grid_color, 1.0);
        const PagePoint at = axes.at(x, axes.y.low);
        page.text({at.x, at.y + 6.0 + letter}, words, letter, 0);
    }
    page.line({axes.at(axes.x.low, axes.y.high), axes.at(axes.x.low, axes.y.low), axes.at(axes.x.high, axes.y.low)},
              axis_color, 1.2);
    page.text({axes.corner.x + 0.5 * Axes::width, axes.corner.y + Axes::height + bottom - 10.0}, panel.x_label,
              letter + 1.0, 0);
    page.text({axes.corner.x + 0.5 * Axes::width, axes.corner.y - 12.0}, panel.y_label, letter + 2.0, 0);
}

Color color_of(std::size_t number)
{
    const auto& color = curve_colors[number % curve_colors.size()];
    return {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
}

void draw_curve(VectorPage& page, const Curve& curve, const Axes& axes, const Color& color)
{
    std::vector<PagePoint> piece;
    for (std::size_t i = 0; i < count_of(curve); ++i)
    {
        if (is_shown(curve, i))
        {
            piece.push_back(axes.at(curve.x[i], curve.y[i]));
            if (curve.is_points || curve.is_marked)
            {
                page.disc(piece.back(), 3.0, color);
            }
        }
    }
    if (!curve.is_points && piece.size() > 1) // across numbers that are missing
    {
        page.line(std::move(piece), color, 2.0);
    }
}

/// How many points of the curves lie in the upper left of the panel, less those in the upper right.
int left_heavy(const Panel& panel, const Axes& axes)
{
    int balance = 0;
    for (const Curve& curve : panel.curves)
    {
        for (std::size_t i = 0; i < count_of(curve); ++i)
        {
            const PagePoint at = axes.at(curve.x[i], curve.y[i]);
            if (is_shown(curve, i) && at.y < axes.corner.y + 0.4 * Axes::height)
            {
                balance += at.x < axes.corner.x + 0.5 * Axes::width ? 1 : -1;
            }
        }
    }
    return balance;
}

void draw_legend(VectorPage& page, const Panel& panel, const Axes& axes)
{
    constexpr double row = letter + 5.0;
    double widest = 0.0;
    for (const Curve& curve : panel.curves)
    {
        widest = std::max(widest, letter * text_width(curve.label));
    }
    const double width = 1.15 * widest + 40.0; // other fonts are wider
    const double x = left_heavy(panel, axes) > 0 ? axes.corner.x + Axes::width - width - 4.0 : axes.corner.x + 8.0;
    const double y = axes.corner.y + 4.0;
    page.box({x, y}, width, row * static_cast<double>(panel.curves.size()) + 6.0);
    for (std::size_t k = 0; k < panel.curves.size(); ++k)
    {
        const double middle = y + 3.0 + row * (static_cast<double>(k) + 0.5);
        if (panel.curves[k].is_points)
        {
            page.disc({x + 16.0, middle}, 3.0, color_of(k));
        }
        else
        {
            page.line({{x + 6.0, middle}, {x + 26.0, middle}}, color_of(k), 2.0);
        }
        page.text({x + 32.0, middle + 0.35 * letter}, panel.curves[k].label, letter, -1);
    }
}

} // namespace

void write_vector_plot(const std::filesystem::path& file, std::span<const Panel> panels, const std::string& title)
{
    const int count = std::max(1, static_cast<int>(panels.size()));
    const int rows = (count + columns - 1) / columns;
    const double width = std::min(count, columns) * panel_width;
    VectorPage page(width, title_height + rows * panel_height);
    page.text({0.5 * width, 0.7 * title_height}, title, letter + 5.0, 0, true);
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
        const Panel& panel = panels[i];
        const bool has_marks =
            std::ranges::any_of(panel.curves, [](const Curve& curve) { return curve.is_points || curve.is_marked; });
        const double column = static_cast<double>(i % columns);
        const double row = static_cast<double>(i / columns);
        const Axes axes{{column * panel_width + left, title_height + row * panel_height + top},
                        range_of(panel, &Curve::x, has_marks ? 0.06 : 0.0),
                        range_of(panel, &Curve::y, 0.05)};
        draw_axes(page, panel, axes);
        for (std::size_t k = 0; k < panel.curves.size(); ++k)
        {
            draw_curve(page, panel.curves[k], axes, color_of(k));
        }
        if (panel.curves.size() > 1)
        {
            draw_legend(page, panel, axes);
        }
    }
    formats::write_text_atomically(file, file.extension() == ".pdf" ? page.pdf() : page.svg());
}

} // namespace corticle::view
