// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"
#include "corticle/imaging/mask_report.hpp"
#include "corticle/imaging/options.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::imaging
{

struct ImagedSurface
{
    TriangleMesh surface; ///< scanner millimetres (RAS), closed, outward
    MaskReport report;
};

/// From tissue labels to a clean closed surface of one component: the chosen labels; their largest component (of a
/// hemisphere, if asked: split by the plane of symmetry first); closing; cavities filled; Gaussian smoothing, with the
/// isosurface that encloses the volume of the mask; handles removed (docs/theory/imaging.md). The surface is not
/// self-intersecting; its triangles are about half a voxel.
/// @throws InputError, one line, for options out of range, a label that is not there, a mask without background, a mask
/// most of which a step would drop or that ends up empty, and a hemisphere asked of one hemisphere.
ImagedSurface surface_from_labels(const LabelVolume& image, const MaskOptions& options);

} // namespace corticle::imaging
