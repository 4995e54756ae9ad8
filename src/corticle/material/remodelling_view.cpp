// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/material/remodelling_view.hpp"

#include "corticle/material/tissue_law.hpp"

namespace corticle::material
{

namespace
{

BasicPointHistory<double> history_of(const RemodellingView& view, std::size_t i)
{
    const HistoryArrays<const double>& all = view.before;
    BasicPointHistory<double> history{Mat3::identity(), all.growth != nullptr ? all.growth[i] : 1.0,
                                      all.fibre_length != nullptr ? all.fibre_length[i] : 1.0};
    for (std::size_t k = 0; all.strain != nullptr && k < strain_size; ++k)
    {
        const auto [row, column] = strain_entries[k];
        history.strain(row, column) = history.strain(column, row) = all.strain[k * view.points + i];
    }
    return history;
}

} // namespace

Mat3 remodelled_stress(const RemodellingView& view, const Tissue& tissue, std::size_t i, const MaterialPoint& point,
                       const Mat3& F)
{
    const TissueFields& fields = tissue.fields;
    const BasicPointHistory<double> history = history_of(view, i);
    const BasicFibre<double> fibre =
        fields.fibre.empty() ? BasicFibre<double>{} : BasicFibre<double>{fields.fibre[i], fields.white_share[i]};
    const auto law = remodelled(view.step, view.step.tension, tissue_law(tissue.options), fibre, history);
    return respond(law, grown_by_stress(point, history.growth), tissue.growth_normal(i, F), F).P;
}

} // namespace corticle::material
