// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/options.hpp"
#include "corticle/imaging/voxel_grid.hpp"

#include <span>

namespace corticle
{

/// A mask and the grid it lives on.
struct GridMask
{
    VoxelGrid grid;
    Mask mask;
    bool touches_border = false; ///< of the image
};

/// The chosen labels, on their bounding box widened by `margin_mm` and some voxels; voxels beyond the image are
/// background. @throws InputError when a label is not in the image (listing those that are), or when none is.
GridMask select_labels(const LabelVolume& image, std::span<const std::int64_t> labels, double margin_mm);

/// Keeps the component with most voxels, of those that share faces; the first of equal ones.
/// Returns how many components there were.
std::int64_t keep_largest_component(const VoxelGrid& grid, Mask& mask);

/// Morphological closing by a ball [mm]: what lies within `radius` of the mask, less what lies within it of the rest.
/// For voxels with right angles; where they are skew, their edges are taken as if they were not.
void close_mask(const VoxelGrid& grid, double radius, Mask& mask);

/// Fills background that no path through faces connects with the outermost layer.
void fill_cavities(const VoxelGrid& grid, Mask& mask);

} // namespace corticle
