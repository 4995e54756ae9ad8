// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/output_view.hpp"

namespace corticle::model
{

OutputView output_view(const Simulation& simulation, std::size_t number, const PhysicalScale& scale)
{
    std::vector<Vec3> as_folded = simulation.surface_positions();
    std::vector<Vec3> surface = scaled(as_folded, scale.length);
    return {simulation, number, scale, simulation.deformation_gradients(), std::move(surface), std::move(as_folded)};
}

} // namespace corticle::model
