// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/voxel_grid.hpp"
#include "corticle/material/tissue_kind.hpp"

#include <span>
#include <string>

namespace corticle::imaging
{

/// Labels of each tissue (keys under [tissue.labels]).
using TissueLabels = material::PerTissue<std::vector<std::int64_t>>;

/// What labels say of points.
struct LabelledPoints
{
    std::vector<double> cortex_inside; ///< distance from the inner boundary of the cortex, that with other tissue;
                                       ///< positive in the cortex [mm]
    std::vector<material::TissueKind> tissue; ///< nearest tissue but cortex
};

/// Tissues of a label volume, as distances. Those between voxel centres (squared_distance_to) are taken less half a
/// voxel, smoothed so that a boundary is no staircase, and interpolated. A point in no labelled voxel goes by what is
/// nearest.
class TissueReader
{
  public:
    /// @param body  labels of the body; empty: all but 0. Those in no list count as white matter.
    /// @param smoothing_mm  standard deviation
    /// @throws InputError for a label that no voxel has, and a body without cortex or without other tissue
    TissueReader(const LabelVolume& image, const TissueLabels& labels, std::span<const std::int64_t> body,
                 double smoothing_mm);

    LabelledPoints at(std::span<const Vec3> points) const;

    /// What counts as white matter for want of a list, one line; empty: nothing.
    std::string note;

  private:
    double interpolated(std::span<const float> values, const Vec3& point) const;

    VoxelGrid grid_;
    std::vector<float> cortex_inside_;                 ///< [mm]
    material::PerTissue<std::vector<float>> distance_; ///< to each tissue but cortex [mm]; empty: nowhere
};

} // namespace corticle::imaging
