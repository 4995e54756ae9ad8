// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/depth_profile.hpp"

#include "corticle/cloud/interior.hpp"

#include <cmath>

namespace corticle::cloud
{

DepthProfile::DepthProfile(const geometry::SurfaceTree& surface)
    : volume_(enclosed_volume(surface.mesh().vertices, surface.mesh().triangles))
{
    constexpr double samples = 40000.0;
    for (const Vec3& place : places_inside(surface, std::cbrt(volume_ / samples)))
    {
        depths_.push_back(std::sqrt(surface.closest(place).squared_distance));
    }
}

double DepthProfile::count(double spacing, const Grading& grading) const
{
    double sum = 0.0;
    for (const double depth : depths_)
    {
        sum += std::pow(grading.spacing_at(spacing, depth), -3.0);
    }
    return volume_ * sum / static_cast<double>(depths_.size());
}

double DepthProfile::spacing_for(double count, const Grading& grading) const
{
    double high = std::cbrt(volume_ / count); // of a uniform cloud
    double low = high / grading.ratio;
    constexpr int halvings = 50;
    for (int k = 0; k < halvings; ++k)
    {
        const double middle = 0.5 * (low + high);
        (this->count(middle, grading) > count ? low : high) = middle;
    }
    return high;
}

} // namespace corticle::cloud
