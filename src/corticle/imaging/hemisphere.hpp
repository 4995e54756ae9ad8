// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/mask_cleanup.hpp"
#include "corticle/imaging/symmetry_plane.hpp"

#include <string>
#include <vector>

namespace corticle::imaging
{

/// Drops what belongs to neither hemisphere: of each side of the plane of symmetry the largest component is found, and
/// the components of the mask that hold one of the two are kept. Hemispheres that do not touch are both kept so.
void keep_largest_of_each_side(const VoxelGrid& grid, Mask& mask);

/// Refuses a mask that is one hemisphere only, of which a plane of symmetry makes halves: both halves then lie on one
/// side of the scanner's x = 0, and of the image's middle too, or the mask is much narrower (x) than long (y). Where
/// only the scanner's x = 0 speaks against it, its origin may lie elsewhere: a warning.
/// @throws InputError
void require_both_hemispheres(const GridMask& body, const Plane& plane, std::string_view hemisphere,
                              std::vector<std::string>& warnings);

} // namespace corticle::imaging
