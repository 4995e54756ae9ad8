// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/base/error.hpp"
#include "corticle/metrics/surface_rows.hpp"
#include "corticle/study/point_surface.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace corticle
{

namespace
{

void print_json(std::span<const metrics::SurfaceRow> rows)
{
    nlohmann::ordered_json json;
    for (const metrics::SurfaceRow& row : rows)
    {
        json[row.key] = row.value;
    }
    fmt::print("{}\n", json.dump(2));
}

void print_text(std::span<const metrics::SurfaceRow> rows)
{
    for (const metrics::SurfaceRow& row : rows)
    {
        fmt::print("{:<28}{:.8g} {}\n", row.key, row.value, row.unit);
    }
}

void require_new_file(const MeasureArguments& arguments)
{
    std::error_code error;
    const auto status = std::filesystem::symlink_status(arguments.out, error);
    if (!arguments.out.empty() && std::filesystem::exists(status) && !arguments.overwrite)
    {
        throw InputError(fmt::format("--out {}: is there already; expected another name, or --overwrite to replace it",
                                     arguments.out.string()));
    }
}

/// On stderr, so that what is measured can be read by programs.
void print_lines(const char* kind, std::span<const std::string> lines)
{
    for (const std::string& line : lines)
    {
        std::fprintf(stderr, "corticle: %s: %s\n", kind, line.c_str());
    }
}

std::vector<metrics::SurfaceRow> measured(const MeasureArguments& arguments)
{
    if (arguments.surface == MeasuredSurface::delaunay)
    {
        require_new_file(arguments);
        return study::measure_point_surface({arguments.file, arguments.length_limit_mm, arguments.out});
    }
    if (arguments.length_limit_mm || !arguments.out.empty())
    {
        throw InputError(
            fmt::format("{} is given without --surface delaunay", arguments.out.empty() ? "--length-limit" : "--out"));
    }
    const study::RealSurfaceReading reading = study::read_real_surface(arguments.file, arguments.options);
    print_lines("note", reading.notes);
    print_lines("warning", reading.warnings);
    metrics::FoldOptions folds;
    folds.outer = arguments.outer;
    return study::surface_rows(reading, folds);
}

} // namespace

int measure_command(const MeasureArguments& arguments)
{
    const std::vector<metrics::SurfaceRow> rows = measured(arguments);
    arguments.json ? print_json(rows) : print_text(rows);
    return exit_status::done;
}

} // namespace corticle
