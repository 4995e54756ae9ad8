// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <span>
#include <vector>

namespace corticle::regions
{

/// For each place [mm, in the frame of the volume] the label of the nearest voxel that has one, at most `reach` voxels
/// away along each axis: the surface of a brain runs along the border of its labels. 0 where there is none.
std::vector<double> nearest_labels(const imaging::LabelVolume& volume, std::span<const Vec3> places, int reach = 3);

} // namespace corticle::regions
