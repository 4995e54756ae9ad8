// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/wide_group.hpp"
#include "corticle/material/tissue.hpp"

namespace corticle::material
{

/// Moduli and growth of up to eight material points, and the normals they grow across.
struct WideTissue
{
    BasicMaterialPoint<WideLanes> point;
    WideVec3 normal;
};

/// Growth of Tissue::grows_plainly, which the compiler gets to see.
CORTICLE_INLINE WideTissue plain_tissue(const Tissue& tissue, double t, const WideGroup& group)
{
    const WideLanes theta = group.gather(tissue.state.theta.data());
    const WideLanes rate = group.gather(tissue.fields.regional_rate.data());
    return {material_point(tissue.options, theta, rate, t),
            group.gather_vectors([&](std::int64_t i) -> const Vec3& { return tissue.fields.normal[i]; })};
}

/// Any growth, point by point. @param F  of every point; an inverted one keeps the normal of the reference
CORTICLE_INLINE WideTissue any_tissue(const Tissue& tissue, double t, const WideGroup& group, const WideMat3& F)
{
    Mat3 gradients[wide_lanes];
    for (int c = 0; c < 3; ++c)
    {
        group.scatter_vectors(F.column[c],
                              [&](std::int64_t i) -> Vec3& { return gradients[i - group.first].column[c]; });
    }
    WideTissue result{};
    Vec3 normals[wide_lanes];
    for (int lane = 0; lane < wide_lanes; ++lane)
    {
        const auto i = static_cast<std::size_t>(group.at(lane));
        const MaterialPoint point = tissue.point(i, t);
        at_lane(result.point.growth, lane) = point.growth;
        at_lane(result.point.radial_growth, lane) = point.radial_growth;
        at_lane(result.point.growth_rate, lane) = point.growth_rate;
        at_lane(result.point.radial_growth_rate, lane) = point.radial_growth_rate;
        at_lane(result.point.shear_modulus, lane) = point.shear_modulus;
        at_lane(result.point.bulk_modulus, lane) = point.bulk_modulus;
        at_lane(result.point.shear_rate, lane) = point.shear_rate;
        at_lane(result.point.bulk_rate, lane) = point.bulk_rate;
        const Mat3& gradient = gradients[group.at(lane) - group.first];
        normals[lane] = determinant(gradient) > 0.0 ? tissue.growth_normal(i, gradient) : tissue.fields.normal[i];
    }
    result.normal =
        WideGroup{0, wide_lanes}.gather_vectors([&](std::int64_t lane) -> const Vec3& { return normals[lane]; });
    return result;
}

} // namespace corticle::material
