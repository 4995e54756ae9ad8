// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/thesis/ellipsoid.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/error.hpp"
#include "corticle/material/layer.hpp"

#include <fmt/format.h>

#include <numeric>

namespace corticle::prepare
{

namespace
{

Box box_of(std::span<const Vec3> points)
{
    if (points.empty())
    {
        throw InputError("layer: an ellipsoid fitted to particles; got no particles, expected at least two");
    }
    return bounding_box(points);
}

} // namespace

Vec3 extents_centre(std::span<const Vec3> points)
{
    return box_of(points).center();
}

std::array<double, 3> fitted_semi_axes(std::span<const Vec3> points)
{
    const Vec3 size = box_of(points).size();
    std::array<double, 3> semi_axes{};
    for (int axis = 0; axis < 3; ++axis)
    {
        semi_axes[axis] = 0.5 * size[axis];
        if (!(semi_axes[axis] > 0.0))
        {
            throw InputError(fmt::format("layer: an ellipsoid fitted to {} particles: got an extent of {} mm along {}; "
                                         "expected a positive one",
                                         points.size(), 2.0 * semi_axes[axis], "xyz"[axis]));
        }
    }
    return semi_axes;
}

double ellipsoid_level(const Vec3& X, const std::array<double, 3>& semi_axes, const Vec3& centre)
{
    const Vec3 r = X - centre;
    return squared_norm(Vec3{r.x / semi_axes[0], r.y / semi_axes[1], r.z / semi_axes[2]});
}

std::vector<double> ellipsoid_layer_by_centres(std::span<const Vec3> positions, const std::array<double, 3>& semi_axes,
                                               double lambda, const Vec3& centre)
{
    std::vector<double> theta;
    theta.reserve(positions.size());
    for (const Vec3& X : positions)
    {
        theta.push_back(ellipsoid_level(X, semi_axes, centre) >= lambda ? 1.0 : 0.0);
    }
    return theta;
}

std::vector<double> ellipsoid_layer(std::span<const Vec3> positions, std::span<const double> volume,
                                    const std::array<double, 3>& semi_axes, double lambda, const Vec3& centre)
{
    std::vector<double> inside;
    inside.reserve(positions.size());
    for (const Vec3& position : positions)
    {
        const Vec3 X = position - centre;
        const Vec3 q{X.x / semi_axes[0], X.y / semi_axes[1], X.z / semi_axes[2]};
        const Vec3 slope{q.x / semi_axes[0], q.y / semi_axes[1], q.z / semi_axes[2]}; // gradient of |q|²/2
        const double radius = norm(q);
        // To first order the distance to the level |q| = sqrt(lambda) is the difference of levels over |grad |q||.
        inside.push_back(radius > 0.0 ? (radius - std::sqrt(lambda)) * radius / norm(slope)
                                      : -std::sqrt(lambda) * semi_axes[0]);
    }
    // The white matter is the ellipsoid shrunk by sqrt(lambda).
    const double total = std::accumulate(volume.begin(), volume.end(), 0.0);
    return material::sharp_layer(inside, volume, (1.0 - std::pow(lambda, 1.5)) * total);
}

} // namespace corticle::prepare
