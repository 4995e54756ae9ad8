// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/geometry/validate.hpp"
#include "corticle/io/surface_reader.hpp"
#include "corticle/metrics/fold_measures.hpp"
#include "corticle/metrics/surface_measures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace corticle
{

namespace
{

struct Line
{
    std::string_view key;
    std::string_view unit;
    double value;
};

/// Keys as in summary.json.
std::vector<Line> lines_of(const TriangleMesh& surface)
{
    const SurfaceMeasures measures = measure_surface(surface.vertices, surface.triangles);
    const FoldFields fields = fold_fields(surface.vertices, surface.triangles);
    const FoldMeasures folds = measure_folds(surface.vertices, surface.triangles, fields);
    std::vector<Line> lines{{"area_mm2", "mm2", measures.area_mm2},
                            {"volume_mm3", "mm3", measures.volume_mm3},
                            {"area_per_volume", "1/mm", measures.area_per_volume},
                            {"hull_area_mm2", "mm2", measures.hull_area_mm2},
                            {"gi_hull", "-", measures.gi_hull},
                            {"gi_sphere", "-", measures.gi_sphere}};
    for (const FoldColumn& column : fold_columns())
    {
        lines.push_back({column.key, column.unit, folds.*column.value});
    }
    return lines;
}

void print_json(std::span<const Line> lines)
{
    nlohmann::ordered_json json;
    for (const Line& line : lines)
    {
        json[std::string(line.key)] = line.value;
    }
    fmt::print("{}\n", json.dump(2));
}

void print_text(std::span<const Line> lines)
{
    for (const Line& line : lines)
    {
        fmt::print("{:<28}{:.8g} {}\n", line.key, line.value, line.unit);
    }
}

} // namespace

int measure_command(const MeasureArguments& arguments)
{
    const TriangleMesh surface = read_surface(arguments.surface, millimetres_per(arguments.unit));
    require_valid_surface(surface, arguments.surface.string());
    const std::vector<Line> lines = lines_of(surface);
    arguments.json ? print_json(lines) : print_text(lines);
    return exit_status::done;
}

} // namespace corticle
