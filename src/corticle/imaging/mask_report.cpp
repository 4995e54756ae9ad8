// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/mask_report.hpp"

#include <fmt/format.h>

namespace corticle::imaging
{

std::vector<std::string> describe(const MaskReport& report)
{
    std::vector<std::string> lines{fmt::format("mask of the labels: closed by {:.3g} mm, smoothed by {:.3g} mm",
                                               report.closing_mm, report.smoothing_mm)};
    for (const MaskStep& step : report.steps)
    {
        if (step.added > 0 || step.removed > 0)
        {
            lines.push_back(fmt::format("{}: {} voxels added ({:.4g} mm3), {} removed ({:.4g} mm3)", step.name,
                                        step.added, step.added_mm3, step.removed, step.removed_mm3));
        }
    }
    for (const HandleChange& handle : report.handles)
    {
        lines.push_back(fmt::format("a {} at ({:.1f}, {:.1f}, {:.1f}) mm: {} voxels",
                                    handle.filled ? "tunnel filled" : "handle cut", handle.place.x, handle.place.y,
                                    handle.place.z, handle.voxels));
    }
    lines.push_back(
        fmt::format("surface of the labels: {:.6g} mm3 (mask {:.6g} mm3), {:.5g} mm2, {:.4g} x {:.4g} x {:.4g} "
                    "mm, genus {} (before the removal of handles: {})",
                    report.surface_volume_mm3, report.mask_volume_mm3, report.surface_area_mm2, report.extent_mm.x,
                    report.extent_mm.y, report.extent_mm.z, report.genus, report.genus_before));
    return lines;
}

} // namespace corticle::imaging
