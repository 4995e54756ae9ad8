// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/remodelling_view.hpp"
#include "corticle/material/wide_tissue.hpp"

namespace corticle::material
{

/// The law that a method goes by at eight points: itself, where it is the same everywhere.
/// @param now  the tissue there, which a law with a history lets grow
template <Material<WideLanes> Law>
CORTICLE_INLINE const Law& law_at(const Law& law, const Tissue& /*tissue*/, const WideGroup& /*group*/,
                                  const WideMat3& /*F*/, WideTissue& /*now*/)
{
    return law;
}

/// The law where tissue has a history.
struct RemodellingLaw : NeoHookean
{
    bool is_split = false; ///< volumes belong to nodes, whose pass has set the growth by stress already
};

/// A law whose points have histories: their growth is never plain.
template <class Law>
concept HasHistory = std::same_as<Law, RemodellingLaw>;

/// Tissue with a history, but for growth by stress. @param F  of every point
CORTICLE_INLINE WideTissue unstressed_tissue(const Tissue& tissue, double t, const WideGroup& group, const WideMat3& F)
{
    return tissue.has_plain_points() ? plain_tissue(tissue, t, group) : any_tissue(tissue, t, group, F);
}

/// The law at eight points.
struct WideRemodelled : BasicRemodelled<WideLanes>
{
    WideLanes released;    ///< energy of the history's step, per reference volume [mu_w]
    WideLanes growth_step; ///< theta_s now over that before the step, less 1
};

CORTICLE_INLINE WideMat3 strain_of(const WideGroup& group, const double* strain, std::size_t points)
{
    WideMat3 C_v;
    for (std::size_t k = 0; k < strain_size; ++k)
    {
        const auto [row, column] = strain_entries[k];
        C_v(row, column) = group.gather(strain + k * points);
        C_v(column, row) = C_v(row, column);
    }
    return C_v;
}

CORTICLE_INLINE void put(const WideGroup& group, WideLanes values, double* all)
{
    for (int lane = 0; lane < group.count; ++lane)
    {
        all[group.first + lane] = at_lane(values, lane);
    }
}

CORTICLE_INLINE BasicPointHistory<WideLanes> history_of(const RemodellingView& view, const WideGroup& group)
{
    const HistoryArrays<const double>& all = view.before;
    const WideLanes one = broadcast<WideLanes>(1.0);
    return {all.strain != nullptr ? strain_of(group, all.strain, view.points) : WideMat3::identity(),
            all.growth != nullptr ? group.gather(all.growth) : one,
            all.fibre_length != nullptr ? group.gather(all.fibre_length) : one};
}

CORTICLE_INLINE void keep(const RemodellingView& view, const WideGroup& group,
                          const BasicPointHistory<WideLanes>& history)
{
    if (view.after.strain != nullptr)
    {
        for (std::size_t k = 0; k < strain_size; ++k)
        {
            const auto [row, column] = strain_entries[k];
            put(group, history.strain(row, column), view.after.strain + k * view.points);
        }
    }
    if (view.after.fibre_length != nullptr)
    {
        put(group, history.fibre_length, view.after.fibre_length);
    }
}

/// Sets theta_s after the step. @param point  without growth by stress   @param J  det F
CORTICLE_INLINE WideLanes grow_by_stress(const Tissue& tissue, const WideGroup& group,
                                         const BasicMaterialPoint<WideLanes>& point, const WideLanes& J)
{
    const RemodellingView& view = *tissue.remodelling;
    if (view.before.growth == nullptr)
    {
        return broadcast<WideLanes>(1.0);
    }
    WideLanes growth = group.gather(view.before.growth);
    if (view.step.elapsed > 0.0)
    {
        growth = growth_by_stress(view.step, point, group.gather(tissue.fields.white_share.data()), J, growth);
    }
    put(group, growth, view.after.growth);
    return growth;
}

CORTICLE_INLINE BasicFibre<WideLanes> fibre_of(const Tissue& tissue, const WideGroup& group)
{
    if (tissue.fields.fibre.empty())
    {
        return {{WideLanes{}, WideLanes{}, WideLanes{}}, WideLanes{}};
    }
    return {group.gather_vectors([&](std::int64_t i) -> const Vec3& { return tissue.fields.fibre[i]; }),
            group.gather(tissue.fields.white_share.data())};
}

/// Energy per reference volume [mu_w]. @param is_split  without what depends on the volume of the nodes
CORTICLE_INLINE WideLanes energy_of(const BasicRemodelled<WideLanes>& law, const BasicMaterialPoint<WideLanes>& point,
                                    const ElasticDeformation<WideLanes>& e, bool is_split)
{
    const WideLanes shape = law.respond_to_shape(point.shear_modulus, e.F_e, e.cofactor_e, e.J_e).energy;
    return growth_volume(point) *
           (is_split ? shape : WideLanes{shape + law.respond_to_volume(point.bulk_modulus, e.J_e).energy});
}

CORTICLE_INLINE WideRemodelled law_at(const RemodellingLaw& law, const Tissue& tissue, const WideGroup& group,
                                      const WideMat3& F, WideTissue& now)
{
    const RemodellingView& view = *tissue.remodelling;
    const RemodellingStep& step = view.step;
    const BasicPointHistory<WideLanes> before = history_of(view, group);
    const BasicFibre<WideLanes> fibre = fibre_of(tissue, group);
    const BasicMaterialPoint<WideLanes> unstressed = now.point;
    BasicPointHistory<WideLanes> after = before;
    if (!law.is_split)
    {
        after.growth = grow_by_stress(tissue, group, unstressed, determinant(F));
    }
    else if (view.after.growth != nullptr)
    {
        after.growth = group.gather(view.after.growth);
    }
    now.point = grown_by_stress(unstressed, after.growth);
    WideLanes released{};
    if (step.elapsed > 0.0)
    {
        const auto e = elastic_deformation(now.point, now.normal, F);
        after = advanced(step, fibre, e, after);
        const BasicMaterialPoint<WideLanes> earlier = grown_by_stress(unstressed, before.growth);
        released = energy_of(remodelled(step, step.tension_before, law, fibre, before), earlier,
                             elastic_deformation(earlier, now.normal, F), law.is_split) -
                   energy_of(remodelled(step, step.tension, law, fibre, after), now.point, e, law.is_split);
    }
    keep(view, group, after);
    return {remodelled(step, step.tension, law, fibre, after), released,
            after.growth / before.growth - broadcast<WideLanes>(1.0)};
}

} // namespace corticle::material
