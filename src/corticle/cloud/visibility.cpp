// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/visibility.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mesh/sizes.hpp"

namespace corticle::cloud
{

namespace
{

struct Viewpoint
{
    Vec3 place;
    double depth;
};

double depth_of(const geometry::SurfaceTree& surface, const Vec3& place, double reach)
{
    const geometry::SurfacePoint foot = surface.closest_within(place, reach);
    return foot.triangle < 0 ? reach : -surface.signed_distance(place, foot);
}

/// The place from which a particle looks: half a spacing below the surface where it is nearer to it than that.
Viewpoint viewpoint(const geometry::SurfaceTree& surface, const Vec3& position, double spacing, double reach)
{
    const geometry::SurfacePoint foot = surface.closest_within(position, reach);
    const double depth = foot.triangle < 0 ? reach : -surface.signed_distance(position, foot);
    double wanted = 0.5 * spacing;
    if (depth >= wanted)
    {
        return {position, depth};
    }
    const Vec3 normal = surface.interpolated_normal(foot);
    // In a thin part the far side is near: go less deep until the place is safely inside.
    constexpr int most_halvings = 6;
    for (int halving = 0; halving < most_halvings; ++halving, wanted *= 0.5)
    {
        const Vec3 place = foot.position - wanted * normal;
        const double place_depth = depth_of(surface, place, reach);
        if (place_depth >= 0.5 * wanted)
        {
            return {place, place_depth};
        }
    }
    return {position, depth};
}

} // namespace

Visibility::Visibility(const Cloud& cloud, const geometry::SurfaceTree& surface, double support)
    : surface_(surface), viewpoints_(cloud.positions.size()), depths_(cloud.positions.size())
{
    require_positive("support of the neighbours [mm]", support);
    require_positive("spacing of the cloud [mm]", cloud.spacing);
    parallel_for(static_cast<std::int64_t>(cloud.positions.size()),
                 [&](std::int64_t i)
                 {
                     const Viewpoint view = viewpoint(surface, cloud.positions[i], cloud.spacing, support);
                     viewpoints_[i] = view.place;
                     depths_[i] = view.depth;
                 });
}

bool Visibility::see_each_other(std::int32_t i, std::int32_t j) const
{
    const Vec3& a = viewpoints_[i];
    const Vec3& b = viewpoints_[j];
    // The balls about the ends, as large as their depths, lie in the body; where they meet, so does the segment.
    if (depths_[i] > 0.0 && depths_[j] > 0.0 && depths_[i] + depths_[j] > norm(b - a))
    {
        return true;
    }
    return !surface_.segment_crosses(a, b);
}

} // namespace corticle::cloud
