// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace corticle::imaging
{

/// What one step of the clean-up did to the mask.
struct MaskStep
{
    std::string name;         ///< "labels", "largest component", "closing", "cavities", "hemisphere", ...
    std::int64_t added = 0;   ///< voxels
    std::int64_t removed = 0; ///< voxels
    double added_mm3 = 0.0;
    double removed_mm3 = 0.0;
};

/// A place where the topology was changed.
struct HandleChange
{
    Vec3 place;              ///< centre of the changed voxels, scanner frame [mm]
    std::int64_t voxels = 0; ///< how many
    bool filled = false;     ///< a tunnel was filled; else a handle was cut
};

struct MaskReport
{
    std::vector<MaskStep> steps;
    Vec3 voxel_mm;                   ///< edges of a voxel
    double closing_mm = 0.0;         ///< MaskOptions
    double smoothing_mm = 0.0;       ///< the same
    double mask_volume_mm3 = 0.0;    ///< of the clean mask, before smoothing
    double surface_volume_mm3 = 0.0; ///< enclosed by the surface
    double surface_area_mm2 = 0.0;
    Vec3 extent_mm;                    ///< of the surface along right, anterior, superior
    double iso_level = 0.0;            ///< of the smoothed mask, at the surface
    std::int64_t genus_before = 0;     ///< of the smoothed mask
    std::int64_t genus = 0;            ///< of the surface
    std::vector<HandleChange> handles; ///< what was changed to remove them
    std::vector<std::string> warnings; ///< one line each
};

/// What was done, in words, one line for each step that changed something and one for the result.
std::vector<std::string> describe(const MaskReport& report);

} // namespace corticle::imaging
