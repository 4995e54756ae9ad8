// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/volume_geometry.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

constexpr double round_off = 1e-5;

/// Largest entry of the linear part less the identity.
double departure(const Mat3& linear)
{
    double largest = 0.0;
    for (int row = 0; row < 3; ++row)
    {
        for (int column = 0; column < 3; ++column)
        {
            largest = std::max(largest, std::abs(linear(row, column) - (row == column ? 1.0 : 0.0)));
        }
    }
    return largest;
}

} // namespace

bool AffineMap::is_identity() const
{
    return departure(linear) <= round_off && norm(shift) <= round_off;
}

std::string describe(const AffineMap& map)
{
    const std::string shift =
        fmt::format("moved by ({:.6g}, {:.6g}, {:.6g}) mm", map.shift.x, map.shift.y, map.shift.z);
    if (departure(map.linear) <= round_off)
    {
        return shift;
    }
    const auto row = [&](int k)
    { return fmt::format("{:.6g} {:.6g} {:.6g}", map.linear(k, 0), map.linear(k, 1), map.linear(k, 2)); };
    return fmt::format("mapped by the matrix ({}; {}; {}) and {}", row(0), row(1), row(2), shift);
}

std::optional<AffineMap> tkras_to_scanner(const VolumeGeometry& volume)
{
    constexpr double rounding = 1e-2; // of direction cosines written in five decimals
    const VolumeGeometry conformed;
    const Mat3 axes{{volume.x_ras, volume.y_ras, volume.z_ras}};
    const Mat3 conformed_axes{{conformed.x_ras, conformed.y_ras, conformed.z_ras}};
    const AffineMap map{axes * transpose(conformed_axes), volume.c_ras};
    // Negated, so that NaN is refused.
    if (!(std::abs(std::abs(determinant(axes)) - 1.0) < rounding) || !is_finite(volume.c_ras))
    {
        return std::nullopt;
    }
    return map;
}

} // namespace corticle::formats
