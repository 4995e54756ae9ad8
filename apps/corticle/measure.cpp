// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "corticle/metrics/region_areas.hpp"
#include "corticle/metrics/surface_rows.hpp"
#include "corticle/study/point_surface.hpp"
#include "corticle/study/regions/nearest_labels.hpp"

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

void require_new_file(const char* option, const std::filesystem::path& file, bool overwrite)
{
    std::error_code error;
    const auto status = std::filesystem::symlink_status(file, error);
    if (!file.empty() && std::filesystem::exists(status) && !overwrite)
    {
        throw InputError(fmt::format("{} {}: is there already; expected another name, or --overwrite to replace it",
                                     option, file.string()));
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

/// Area of each region of a surface; written as a table, too, where that is asked for.
void add_regions(const MeasureArguments& arguments, const TriangleMesh& surface, std::vector<metrics::SurfaceRow>& rows)
{
    if (arguments.regions.empty())
    {
        return;
    }
    const std::vector<double> labels = regions::nearest_labels(
        formats::read_labels(arguments.regions, {{}, arguments.options.coordinates}), surface.vertices);
    std::string table = "label,area_mm2\n";
    for (const auto& [label, area] : metrics::region_areas({surface.vertices, surface.triangles}, labels))
    {
        rows.push_back({fmt::format("region_{}_area_mm2", label), "mm2", area});
        table += label == 0 ? "" : fmt::format("{},{}\n", label, area);
    }
    if (!arguments.areas.empty())
    {
        formats::write_text_atomically(arguments.areas, table);
    }
}

std::vector<metrics::SurfaceRow> measured(const MeasureArguments& arguments)
{
    if (arguments.surface == MeasuredSurface::delaunay)
    {
        require_new_file("--out", arguments.out, arguments.overwrite);
        return study::measure_point_surface({arguments.file, arguments.length_limit_mm, arguments.out});
    }
    if (arguments.length_limit_mm || !arguments.out.empty())
    {
        throw InputError(
            fmt::format("{} is given without --surface delaunay", arguments.out.empty() ? "--length-limit" : "--out"));
    }
    if (arguments.regions.empty() && !arguments.areas.empty())
    {
        throw InputError(fmt::format("--areas {}: is given without --regions", arguments.areas.string()));
    }
    require_new_file("--areas", arguments.areas, arguments.overwrite);
    const study::RealSurfaceReading reading = study::read_real_surface(arguments.file, arguments.options);
    print_lines("note", reading.notes);
    print_lines("warning", reading.warnings);
    metrics::FoldOptions folds;
    folds.outer = arguments.outer;
    std::vector<metrics::SurfaceRow> rows = study::surface_rows(reading, folds);
    add_regions(arguments, reading.surface, rows);
    return rows;
}

} // namespace

int measure_command(const MeasureArguments& arguments)
{
    const std::vector<metrics::SurfaceRow> rows = measured(arguments);
    arguments.json ? print_json(rows) : print_text(rows);
    return exit_status::done;
}

} // namespace corticle
