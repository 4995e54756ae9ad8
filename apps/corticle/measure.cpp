// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/metrics/surface_rows.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace corticle
{

namespace
{

void print_json(std::span<const SurfaceRow> rows)
{
    nlohmann::ordered_json json;
    for (const SurfaceRow& row : rows)
    {
        json[row.key] = row.value;
    }
    fmt::print("{}\n", json.dump(2));
}

void print_text(std::span<const SurfaceRow> rows)
{
    for (const SurfaceRow& row : rows)
    {
        fmt::print("{:<28}{:.8g} {}\n", row.key, row.value, row.unit);
    }
}

} // namespace

int measure_command(const MeasureArguments& arguments)
{
    const TriangleMesh surface = read_real_surface(arguments.file, arguments.options);
    FoldOptions folds;
    folds.outer = arguments.outer == "closed" ? OuterSurface::closed : OuterSurface::hull;
    const std::vector<SurfaceRow> rows = surface_rows(surface.vertices, surface.triangles, folds);
    arguments.json ? print_json(rows) : print_text(rows);
    return exit_status::done;
}

} // namespace corticle
