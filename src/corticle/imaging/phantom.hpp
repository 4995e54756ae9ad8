// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/label_volume.hpp"

namespace corticle::imaging
{

/// Labels of the phantom, as tissue segmentations of fetal brains have them.
namespace phantom_label
{
inline constexpr std::int32_t fluid = 1;     ///< around the brain and in its fissures
inline constexpr std::int32_t cortex = 2;    ///< cortical grey matter
inline constexpr std::int32_t white = 3;     ///< white matter
inline constexpr std::int32_t ventricle = 5; ///< lateral ventricles
inline constexpr std::int32_t deep = 7;      ///< deep grey matter
} // namespace phantom_label

struct PhantomOptions
{
    double length_mm = 64.0; ///< from the frontal to the occipital pole; all else scales with it (64 mm: 23 weeks)
    double voxel_mm = 0.8;
};

/// A smooth fetal cerebrum about the origin: two mirrored hemispheres, an interhemispheric fissure bridged in the depth
/// (corpus callosum, diencephalon), temporal lobes below a Sylvian fissure, a hint of an insula. Ellipsoids joined and
/// carved with smooth minima. Labels 2, 3, 5 and 7 together are the body: at 64 mm its volume is about 64 cm³.
/// @throws InputError for sizes that are not positive, or make more than 5 * 10^8 voxels.
LabelVolume make_brain_phantom(const PhantomOptions& options);

/// Lobes of the phantom, for every voxel of its image, body or not: 1 frontal, 2 parietal, 3 temporal, 4 occipital on
/// the left (x < 0), 11 to 14 on the right. A voxel belongs to the lobe whose ellipsoid is nearest.
/// @throws InputError as make_brain_phantom().
LabelVolume make_phantom_lobes(const PhantomOptions& options);

} // namespace corticle::imaging
