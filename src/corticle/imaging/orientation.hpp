// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

#include <span>
#include <string>

namespace corticle::imaging
{

/// Which way the axes of an image run, as the letters of right, left, anterior, posterior, superior and inferior:
/// "LAS" for a first axis that runs to the left. Oblique axes by their nearest direction.
std::string orientation_of(const VoxelFrame& frame);

/// Size, voxels and orientation of an image in one line.
std::string describe(const LabelVolume& image);

/// Where points lie in the scanner's coordinates, in one line: bounds, and on which side of x = 0. [mm]
std::string describe_place(std::span<const Vec3> points);

} // namespace corticle::imaging
