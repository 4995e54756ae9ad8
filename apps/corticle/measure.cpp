// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/geometry/validate.hpp"
#include "corticle/io/surface_reader.hpp"
#include "corticle/metrics/surface_measures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace corticle
{

namespace
{

void print_json(const SurfaceMeasures& measures)
{
    nlohmann::ordered_json json;
    json["area_mm2"] = measures.area_mm2;
    json["volume_mm3"] = measures.volume_mm3;
    json["area_per_volume"] = measures.area_per_volume;
    json["hull_area_mm2"] = measures.hull_area_mm2;
    json["gi_hull"] = measures.gi_hull;
    json["gi_sphere"] = measures.gi_sphere;
    fmt::print("{}\n", json.dump(2));
}

void print_text(const SurfaceMeasures& measures)
{
    fmt::print("area            {:.8g} mm2\n", measures.area_mm2);
    fmt::print("volume          {:.8g} mm3\n", measures.volume_mm3);
    fmt::print("area / volume   {:.6g} 1/mm\n", measures.area_per_volume);
    fmt::print("hull area       {:.8g} mm2\n", measures.hull_area_mm2);
    fmt::print("gi_hull         {:.6g}\n", measures.gi_hull);
    fmt::print("gi_sphere       {:.6g}\n", measures.gi_sphere);
}

} // namespace

int measure_command(const MeasureArguments& arguments)
{
    const TriangleMesh surface = read_surface(arguments.surface, millimetres_per(arguments.unit));
    require_valid_surface(surface, arguments.surface.string());
    const SurfaceMeasures measures = measure_surface(surface.vertices, surface.triangles);
    arguments.json ? print_json(measures) : print_text(measures);
    return exit_status::done;
}

} // namespace corticle
