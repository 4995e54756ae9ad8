// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/display.hpp"
#include "corticle/view/picture_window.hpp"
#include "corticle/view/pictures.hpp"
#include "corticle/view/vector_plot.hpp"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace corticle::view
{

namespace
{

constexpr int columns = 3;
constexpr int panel_width = 600;  // [px]
constexpr int panel_height = 420; // [px]
constexpr int title_height = 60;  // [px]

struct Range
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// The range with a margin on both sides; never empty.
    Range widened(double fraction) const
    {
        if (!(low <= high))
        {
            return {0.0, 1.0};
        }
        const double size = std::max(high - low, 1e-9 * std::max(std::abs(low), std::abs(high)));
        const double margin = size > 0.0 && high > low ? fraction * size : std::max(0.05 * std::abs(low), 1e-3);
        return {low - margin, high + margin};
    }
};

/// The points of a curve that are finite.
vtkNew<vtkTable> table_of(const Curve& curve, Range& x_range, Range& y_range)
{
    vtkNew<vtkDoubleArray> x;
    vtkNew<vtkDoubleArray> y;
    x->SetName("x");
    y->SetName(curve.label.empty() ? "y" : curve.label.c_str());
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
    {
        if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
        {
            x->InsertNextValue(curve.x[i]);
            y->InsertNextValue(curve.y[i]);
            x_range.include(curve.x[i]);
            y_range.include(curve.y[i]);
        }
    }
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    return table;
}

void style_axis(vtkAxis* axis, const std::string& label, const Range& range)
{
    axis->SetTitle(label);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(range.low, range.high);
    axis->GetTitleProperties()->SetFontSize(20);
    axis->GetTitleProperties()->SetBold(false);
    axis->GetLabelProperties()->SetFontSize(17);
    axis->GetGridPen()->SetColor(228, 228, 228);
    axis->GetPen()->SetColor(60, 60, 60);
    axis->GetPen()->SetWidth(1.5f);
}

void set_ticks(vtkAxis* axis, std::span<const std::pair<double, std::string>> ticks)
{
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> labels;
    for (const auto& [place, label] : ticks)
    {
        places->InsertNextValue(place);
        labels->InsertNextValue(label);
    }
    axis->SetCustomTickPositions(places, labels);
}

/// The corner of the panel where the fewest points lie, for the legend: (horizontal, vertical) alignment.
std::array<int, 2> free_corner(const Panel& panel, const Range& x_range, const Range& y_range)
{
    constexpr double corner_size = 0.35;
    constexpr int pieces = 16;                  // of a line from point to point
    std::array<std::array<int, 2>, 2> points{}; // [right][top]
    const auto count = [&](double x_here, double y_here)
    {
        const double x = (x_here - x_range.low) / (x_range.high - x_range.low);
        const double y = (y_here - y_range.low) / (y_range.high - y_range.low);
        if (std::min(x, 1.0 - x) < corner_size && std::min(y, 1.0 - y) < corner_size)
        {
            ++points[x > 0.5 ? 1 : 0][y > 0.5 ? 1 : 0];
        }
    };
    for (const Curve& curve : panel.curves)
    {
        for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
        {
            const std::size_t before = curve.is_points || i == 0 ? i : i - 1;
            for (int piece = 1; piece <= pieces; ++piece)
            {
                const double share = static_cast<double>(piece) / pieces;
                count(curve.x[before] + share * (curve.x[i] - curve.x[before]),
                      curve.y[before] + share * (curve.y[i] - curve.y[before]));
            }
        }
    }
    std::array<std::size_t, 2> best{0, 1};
    for (const auto& corner : {std::array<std::size_t, 2>{1, 1}, {1, 0}, {0, 0}})
    {
        best = points[corner[0]][corner[1]] < points[best[0]][best[1]] ? corner : best;
    }
    return {best[0] == 1 ? vtkChartLegend::RIGHT : vtkChartLegend::LEFT,
            best[1] == 1 ? vtkChartLegend::TOP : vtkChartLegend::BOTTOM};
}

void fill_chart(vtkChartXY* chart, const Panel& panel)
{
    Range x_range;
    Range y_range;
    for (std::size_t c = 0; c < panel.curves.size(); ++c)
    {
        const vtkNew<vtkTable> table = table_of(panel.curves[c], x_range, y_range);
        const bool is_points = panel.curves[c].is_points;
        if (table->GetNumberOfRows() < (is_points ? 1 : 2))
        {
            continue; // VTK draws no line through less, and complains
        }
        vtkPlot* line = chart->AddPlot(is_points ? vtkChart::POINTS : vtkChart::LINE);
        line->SetInputData(table, 0, 1);
        const auto& color = curve_colors[c % curve_colors.size()];
        line->SetColor(color[0], color[1], color[2], 255);
        line->SetWidth(is_points ? 6.0f : 2.5f);
        if (auto* marked = vtkPlotPoints::SafeDownCast(line); panel.curves[c].is_marked && marked != nullptr)
        {
            marked->SetMarkerStyle(vtkPlotPoints::CIRCLE);
            marked->SetMarkerSize(9.0f);
        }
        line->SetLabel(panel.curves[c].label);
    }
    // Points on the edge of a panel would be cut in half.
    const bool has_points = std::any_of(panel.curves.begin(), panel.curves.end(),
                                        [](const Curve& curve) { return curve.is_points || curve.is_marked; });
    const double margin = panel.x_ticks.empty() ? 0.04 : 0.12; // words at the ends need more room than numbers
    const Range shown_x = x_range.widened(has_points ? margin : 0.0);
    style_axis(chart->GetAxis(vtkAxis::BOTTOM), panel.x_label, shown_x);
    if (!panel.x_ticks.empty())
    {
        set_ticks(chart->GetAxis(vtkAxis::BOTTOM), panel.x_ticks);
    }
    // The label of the upright axis stands above the panel, where it can be read and does not meet the ticks.
    style_axis(chart->GetAxis(vtkAxis::LEFT), "", y_range.widened(0.05));
    chart->SetTitle(panel.y_label);
    chart->GetTitleProperties()->SetFontSize(21);
    const std::array<int, 2> corner = free_corner(panel, shown_x, y_range.widened(0.05));
    chart->SetShowLegend(panel.curves.size() > 1);
    chart->GetLegend()->SetLabelSize(17);
    chart->GetLegend()->SetInline(true);
    chart->GetLegend()->SetHorizontalAlignment(corner[0]);
    chart->GetLegend()->SetVerticalAlignment(corner[1]);
}

} // namespace

void render_plot(const std::filesystem::path& file, std::span<const Panel> panels, const std::string& title)
{
    if (file.extension() != ".png")
    {
        write_vector_plot(file, panels, title);
        return;
    }
    require_display(file);
    const int count = std::max(1, static_cast<int>(panels.size()));
    const int across = std::min(count, columns);
    const int rows = (count + columns - 1) / columns;
    const int width = across * panel_width;
    const int height = rows * panel_height + title_height;

    vtkRenderWindow* const window = picture_window(width, height);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    vtkNew<vtkContextActor> actor;
    renderer->AddActor(actor);
    vtkContextScene* scene = actor->GetScene();
    scene->SetRenderer(renderer);
    for (int i = 0; i < static_cast<int>(panels.size()); ++i)
    {
        vtkNew<vtkChartXY> chart;
        fill_chart(chart, panels[static_cast<std::size_t>(i)]);
        chart->SetAutoSize(false);
        const int left = (i % columns) * panel_width;
        const int bottom = (rows - 1 - i / columns) * panel_height;
        chart->SetSize(vtkRectf(static_cast<float>(left + 25), static_cast<float>(bottom + 10), panel_width - 50,
                                panel_height - 30));
        scene->AddItem(chart);
    }
    add_text(renderer, title, 0.5 * width, height - 0.5 * title_height, {.size = 26, .is_bold = true});
    window->Render(); // the first pass finds the room that labels need
    scene->SetDirty(true);
    const vtkSmartPointer<vtkImageData> drawn = grab_picture(window);
    window->RemoveRenderer(renderer);
    write_pngs(std::array{PngPicture{file, drawn}});
}

} // namespace corticle::view
