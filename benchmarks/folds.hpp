// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle::bench
{

/// The surface of a sphere of so many particles, spacing 1, at rest and folded: grooves along parallels, whose banks
/// are straight and nearly touch.
struct FoldedSphere
{
    explicit FoldedSphere(std::int64_t particles)
    {
        const double radius = std::cbrt(3.0 * static_cast<double>(particles) / (4.0 * std::numbers::pi));
        rest = geometry::make_ellipsoid({radius, radius, radius}, 1.0);
        for (const Vec3& X : rest.vertices)
        {
            x.push_back(folded(X, radius));
        }
    }

    TriangleMesh rest;
    std::vector<Vec3> x;

  private:
    static constexpr double period = 8.0; ///< of the grooves at rest
    static constexpr double depth = 5.0;
    static constexpr double gap = 0.25;       ///< between banks: contact acts below 0.3
    static constexpr double smooth_cap = 0.4; ///< polar angle

    /// Crown, bank, floor, bank: the way along a period at rest is stretched over the way along the groove.
    static Vec3 folded(const Vec3& X, double radius)
    {
        const double polar = std::acos(std::clamp(X.z / radius, -1.0, 1.0));
        const double room = (std::numbers::pi - 2.0 * smooth_cap) * radius;
        const double along = (polar - smooth_cap) * radius;
        const double grooves = std::floor(room / period);
        if (along < 0.0 || along >= grooves * period)
        {
            return X;
        }
        const double start = std::floor(along / period) * period;
        double way = (along - start) / period * (period + 2.0 * depth);
        const double crown = period - gap;
        double across = std::min(way, crown);
        way = std::max(0.0, way - crown);
        double down = std::min(way, depth);
        way = std::max(0.0, way - depth);
        across += std::min(way, gap);
        down -= std::max(0.0, way - gap);
        const double folded_polar = smooth_cap + (start + across) / radius;
        const double azimuth = std::atan2(X.y, X.x);
        const double r = radius - down;
        return {r * std::sin(folded_polar) * std::cos(azimuth), r * std::sin(folded_polar) * std::sin(azimuth),
                r * std::cos(folded_polar)};
    }
};

} // namespace corticle::bench
