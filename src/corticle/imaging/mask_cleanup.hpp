// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/options.hpp"
#include "corticle/imaging/voxel_grid.hpp"

#include <span>

namespace corticle::imaging
{

/// A mask and the grid it lives on.
struct GridMask
{
    VoxelGrid grid;
    Mask mask;
    bool touches_border = false; ///< of the image
    double middle_x = 0.0;       ///< x of the image's middle [mm]
};

/// The chosen labels, on their bounding box widened by `margin_mm` and some voxels; voxels beyond the image are
/// background. @throws InputError, listing the labels that are there, when a label is not in the image, when none is,
/// and when labels are not chosen and what should be background has one: labels below 0, or a labelled border
GridMask select_labels(const LabelVolume& image, std::span<const std::int64_t> labels, double margin_mm);

/// The components of a mask, of voxels that share faces.
struct ComponentSizes
{
    std::int64_t count = 0;
    std::int64_t voxels = 0; ///< of all
    std::int64_t largest = 0;
    std::int64_t second = 0;
};

/// Keeps the component with most voxels; the first of equal ones.
ComponentSizes keep_largest_component(const VoxelGrid& grid, Mask& mask);

/// Keeps the components that hold a voxel of `seeds`.
void keep_components_of(const VoxelGrid& grid, const Mask& seeds, Mask& mask);

/// Morphological closing by a ball [mm]: what lies within `radius` of the mask, less what lies within it of the rest.
/// For voxels with right angles; where they are skew, their edges are taken as if they were not.
void close_mask(const VoxelGrid& grid, double radius, Mask& mask);

/// Fills background that no path through faces connects with the outermost layer.
void fill_cavities(const VoxelGrid& grid, Mask& mask);

} // namespace corticle::imaging
