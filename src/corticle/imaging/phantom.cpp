// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/phantom.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace corticle::imaging
{

namespace
{

// All lengths below are those of a brain of 64 mm, in mm; x lateral, y anterior, z superior. Functions are about the
// distance to the shape, negative inside.

constexpr double nominal_length = 64.0;
constexpr Vec3 half_box{33.0, 37.0, 29.0};
constexpr double cortex_thickness = 1.8;
constexpr double fluid_width = 3.0;

/// An ellipsoid, tilted about the x axis [degrees]: positive lifts its anterior end.
struct Ellipsoid
{
    Vec3 centre;
    Vec3 semi_axes;
    double tilt = 0.0;

    /// First-order distance (Quilez): exact in the limit of small distances.
    double distance(const Vec3& p) const
    {
        const double angle = tilt * std::numbers::pi / 180.0;
        const Vec3 d = p - centre;
        const Vec3 q{d.x, std::cos(angle) * d.y + std::sin(angle) * d.z, std::cos(angle) * d.z - std::sin(angle) * d.y};
        const Vec3 u{q.x / semi_axes.x, q.y / semi_axes.y, q.z / semi_axes.z};
        const Vec3 v{u.x / semi_axes.x, u.y / semi_axes.y, u.z / semi_axes.z};
        const double radius = norm(u);
        const double slope = norm(v);
        return slope > 0.0 ? radius * (radius - 1.0) / slope : -std::min({semi_axes.x, semi_axes.y, semi_axes.z});
    }
};

/// min(a, b), rounded off where they differ by less than `width`.
double smooth_min(double a, double b, double width)
{
    const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * overlap * overlap;
}
double smooth_max(double a, double b, double width)
{
    return -smooth_min(-a, -b, width);
}

constexpr Ellipsoid frontal_lobe{{10.6, 14.9, 1.0}, {11.8, 17.3, 14.3}, -12.0};
constexpr Ellipsoid parietal_lobe{{12.5, -3.0, 4.5}, {13.2, 22.0, 15.0}};
constexpr Ellipsoid occipital_lobe{{12.2, -15.9, -1.0}, {11.2, 16.3, 12.5}, 12.0};
constexpr Ellipsoid temporal_lobe{{19.0, 0.0, -11.0}, {7.8, 16.0, 7.6}, -14.0};
constexpr Ellipsoid sylvian_fissure{{29.0, 5.5, -3.5}, {10.0, 14.0, 2.2}, -28.0};
constexpr Ellipsoid insula{{31.0, 9.0, -4.5}, {10.0, 8.0, 6.0}, -28.0};
constexpr Ellipsoid bridge{{0.0, -1.0, -0.5}, {10.0, 14.5, 9.0}};
constexpr Ellipsoid lateral_ventricle{{10.5, -7.0, 4.5}, {2.8, 13.0, 3.8}, 8.0};
constexpr Ellipsoid thalamus{{7.5, 0.0, -2.0}, {5.5, 9.0, 5.5}};
constexpr double half_fissure = 2.1;

double brain_distance(const Vec3& p)
{
    double distance = smooth_min(parietal_lobe.distance(p), frontal_lobe.distance(p), 6.0);
    distance = smooth_min(distance, occipital_lobe.distance(p), 6.0);
    distance = smooth_min(distance, temporal_lobe.distance(p), 4.0);
    distance = smooth_max(distance, -insula.distance(p), 5.0);
    distance = smooth_max(distance, -sylvian_fissure.distance(p), 3.0);
    distance = smooth_max(distance, half_fissure - p.x, 4.0);
    return smooth_min(distance, bridge.distance(p), 4.0);
}

std::int32_t label_at(const Vec3& p)
{
    const double distance = brain_distance(p);
    if (distance > 0.0)
    {
        return distance <= fluid_width ? phantom_label::fluid : 0;
    }
    if (distance > -cortex_thickness)
    {
        return phantom_label::cortex;
    }
    if (lateral_ventricle.distance(p) <= 0.0)
    {
        return phantom_label::ventricle;
    }
    return thalamus.distance(p) <= 0.0 ? phantom_label::deep : phantom_label::white;
}

std::int32_t lobe_at(const Vec3& p)
{
    constexpr std::int32_t on_the_right = 10;
    const Vec3 mirrored{std::abs(p.x), p.y, p.z};
    const std::array distances{frontal_lobe.distance(mirrored), parietal_lobe.distance(mirrored),
                               temporal_lobe.distance(mirrored), occipital_lobe.distance(mirrored)};
    const auto nearest = static_cast<std::int32_t>(std::ranges::min_element(distances) - distances.begin());
    return nearest + 1 + (p.x < 0.0 ? 0 : on_the_right);
}

/// The image of the phantom with, for each voxel, what `label` says of its place in the brain of nominal length.
template <class Label>
LabelVolume make_image(const PhantomOptions& options, const Label& label)
{
    constexpr double most_voxels = 5e8;
    const double scale = options.length_mm / nominal_length;
    const double voxels = 8.0 * half_box.x * half_box.y * half_box.z * std::pow(scale / options.voxel_mm, 3);
    if (!(options.length_mm > 0.0 && options.voxel_mm > 0.0 && voxels <= most_voxels))
    {
        throw InputError(fmt::format("phantom of {:g} mm with voxels of {:g} mm; expected positive sizes and at most "
                                     "5e8 voxels",
                                     options.length_mm, options.voxel_mm));
    }
    LabelVolume image;
    image.frame.linear = options.voxel_mm * Mat3::identity();
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto half = static_cast<std::int64_t>(std::ceil(half_box[axis] * scale / options.voxel_mm));
        image.size[axis] = 2 * half + 1;
        image.frame.origin[axis] = -static_cast<double>(half) * options.voxel_mm;
    }
    image.labels.resize(static_cast<std::size_t>(image.size[0] * image.size[1] * image.size[2]));
    parallel_for(static_cast<std::int64_t>(image.labels.size()),
                 [&](std::int64_t k)
                 {
                     const std::int64_t row = k / image.size[0];
                     const std::int64_t layer = row / image.size[1];
                     const Vec3 index{static_cast<double>(k % image.size[0]), static_cast<double>(row % image.size[1]),
                                      static_cast<double>(layer)};
                     const Vec3 p = image.frame.position(index) / scale;
                     image.labels[k] = label(p);
                 });
    return image;
}

} // namespace

LabelVolume make_brain_phantom(const PhantomOptions& options)
{
    return make_image(options, [](const Vec3& p) { return label_at({std::abs(p.x), p.y, p.z}); });
}

LabelVolume make_phantom_lobes(const PhantomOptions& options)
{
    return make_image(options, lobe_at);
}

} // namespace corticle::imaging
