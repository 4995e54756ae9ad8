// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/source_reports.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace corticle::prepare
{

namespace
{

using Json = nlohmann::ordered_json;

Json mask_json(const imaging::MaskReport& report)
{
    Json j;
    j["steps"] = Json::array();
    for (const imaging::MaskStep& step : report.steps)
    {
        j["steps"].push_back({{"name", step.name},
                              {"added_voxels", step.added},
                              {"removed_voxels", step.removed},
                              {"added_mm3", step.added_mm3},
                              {"removed_mm3", step.removed_mm3}});
    }
    j["voxel_mm"] = {report.voxel_mm.x, report.voxel_mm.y, report.voxel_mm.z};
    j["closing_mm"] = report.closing_mm;
    j["smoothing_mm"] = report.smoothing_mm;
    j["mask_volume_mm3"] = report.mask_volume_mm3;
    j["surface_volume_mm3"] = report.surface_volume_mm3;
    j["surface_area_mm2"] = report.surface_area_mm2;
    j["extent_mm"] = {report.extent_mm.x, report.extent_mm.y, report.extent_mm.z};
    j["iso_level"] = report.iso_level;
    j["genus_before"] = report.genus_before;
    j["genus"] = report.genus;
    j["handles"] = Json::array();
    for (const imaging::HandleChange& handle : report.handles)
    {
        j["handles"].push_back({{"place_mm", {handle.place.x, handle.place.y, handle.place.z}},
                                {"voxels", handle.voxels},
                                {"change", handle.filled ? "filled" : "cut"}});
    }
    return j;
}

Json repair_json(const geometry::RepairReport& report)
{
    Json j;
    j["duplicate_vertices"] = report.duplicate_vertices;
    j["dropped_triangles"] = report.dropped_triangles;
    j["boundary_edges"] = report.edges.boundary_edges;
    j["crowded_edges"] = report.edges.crowded_edges;
    j["opposed_edges"] = report.edges.opposed_edges;
    j["holes"] = report.edges.holes.size();
    j["inside_out"] = report.inside_out;
    j["crossing_pairs"] = report.crossing_pairs;
    j["shell_volumes_mm3"] = report.shell_volumes_mm3;
    j["wrapped"] = report.wrapped;
    if (report.wrapped)
    {
        j["bodies_before"] = report.bodies_before;
        j["genus_before"] = report.genus_before;
        j["genus_after"] = report.genus_after;
        j["left_out_mm"] = report.left_out_mm;
    }
    j["area_before_mm2"] = report.area_before_mm2;
    j["area_after_mm2"] = report.area_after_mm2;
    j["volume_before_mm3"] = report.volume_before_mm3;
    j["volume_after_mm3"] = report.volume_after_mm3;
    return j;
}

Json tets_json(const geometry::TetReport& report)
{
    Json j;
    j["merged_nodes"] = report.merged_nodes;
    j["repeated_tets"] = report.repeated_tets;
    j["flat_tets"] = report.flat_tets;
    j["flipped_tets"] = report.flipped_tets;
    j["is_left_handed"] = report.is_left_handed;
    j["dropped_nodes"] = report.dropped_nodes;
    j["sliver_tets"] = report.sliver_tets;
    j["smallest_mean_ratio"] = report.smallest_mean_ratio;
    return j;
}

Json tissues_json(const TissueReport& report)
{
    Json j;
    for (std::size_t kind = 0; kind < material::tissue_count; ++kind)
    {
        j["volume_mm3"][material::tissue_names[kind]] = report.volume_mm3[kind];
    }
    j["cortex_area_share"] = report.cortex_area_share;
    j["cortex_thickness_mm"] = report.thickness_mm;
    return j;
}

} // namespace

std::string describe(const TissueReport& report)
{
    std::string volumes;
    for (std::size_t kind = 0; kind < material::tissue_count; ++kind)
    {
        volumes += fmt::format("{}{} {:.4g}", kind == 0 ? "" : ", ", material::tissue_names[kind],
                               report.volume_mm3[kind] / 1000.0);
    }
    return fmt::format("tissues: {} cm3; cortex below {:.3g} % of the outer surface, {:.3g} mm thick there", volumes,
                       100.0 * report.cortex_area_share, report.thickness_mm);
}

std::string reports_json(const SourceReports& reports)
{
    Json j = Json::object();
    if (reports.mask)
    {
        j["mask"] = mask_json(*reports.mask);
    }
    if (reports.repair)
    {
        j["repair"] = repair_json(*reports.repair);
    }
    if (reports.tets)
    {
        j["tets"] = tets_json(*reports.tets);
    }
    if (reports.tissues)
    {
        j["tissues"] = tissues_json(*reports.tissues);
    }
    return j.dump();
}

} // namespace corticle::prepare
