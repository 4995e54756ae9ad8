// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/volume_geometry.hpp"

namespace corticle
{

std::optional<AffineMap> tkras_to_scanner(const VolumeGeometry& volume)
{
    constexpr double rounding = 1e-2; // of direction cosines written in five decimals
    const VolumeGeometry conformed;
    const Mat3 axes{{volume.x_ras, volume.y_ras, volume.z_ras}};
    const Mat3 conformed_axes{{conformed.x_ras, conformed.y_ras, conformed.z_ras}};
    const AffineMap map{axes * transpose(conformed_axes), volume.c_ras};
    // Negated, so that what is not a number is refused.
    if (!(std::abs(std::abs(determinant(axes)) - 1.0) < rounding) || !is_finite(volume.c_ras))
    {
        return std::nullopt;
    }
    return map;
}

} // namespace corticle
