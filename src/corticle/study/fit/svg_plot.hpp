// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace corticle::fit
{

/// What is drawn into a panel.
struct SvgMarks
{
    enum class Kind
    {
        points,
        line,
        band,     ///< between y and y_high
        whiskers, ///< from y to y_high
        bars      ///< from 0 to y, between x and x_high
    };
    Kind kind = Kind::points;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> y_high;
    std::vector<double> x_high;
    std::string colour = "#1f5fa8";
    double opacity = 1.0;
};

/// A plot with two axes. What is not finite is left out.
struct SvgPanel
{
    std::string title;
    std::string x_label;
    std::string y_label;
    bool is_log_y = false;
    std::vector<SvgMarks> marks;
    std::vector<std::string> x_names; ///< at x = 0, 1, 2 ... instead of numbers
};

/// Panels side by side, `columns` in a row, as SVG. The same panels give the same text.
std::string svg_plot(const std::vector<SvgPanel>& panels, int columns);

} // namespace corticle::fit
