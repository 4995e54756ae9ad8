// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <optional>
#include <string>

namespace corticle::formats
{

/// x -> linear x + shift, between frames of coordinates [mm].
struct AffineMap
{
    Mat3 linear = Mat3::identity();
    Vec3 shift;

    Vec3 operator()(const Vec3& x) const { return linear * x + shift; }
    /// Turns right-handed frames into left-handed ones, so triangles change their sense.
    bool mirrors() const { return determinant(linear) < 0.0; }
    /// Moves nothing, but for round-off of single precision.
    bool is_identity() const;
};

/// "moved by (1, 2, 3) mm", "turned and moved ..." or "mapped ...", for a line of a report.
std::string describe(const AffineMap& map);

/// Where the volume that a FreeSurfer surface was made from lies in the scanner: directions of its three axes and its
/// centre, in scanner RAS [mm].
struct VolumeGeometry
{
    Vec3 x_ras{-1, 0, 0}, y_ras{0, 0, -1}, z_ras{0, 1, 0}; ///< those of a conformed volume
    Vec3 c_ras;
};

/// From FreeSurfer's surface coordinates (tkRAS: origin at the centre of the volume, axes of a conformed volume) to
/// scanner RAS: c_ras + [x_ras y_ras z_ras] C^-1 x, C the axes of a conformed volume. For those it is x + c_ras.
/// Nothing when the axes do not span space or are not finite.
std::optional<AffineMap> tkras_to_scanner(const VolumeGeometry& volume);

} // namespace corticle::formats
