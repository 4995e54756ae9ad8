// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/output_view.hpp"

namespace corticle::model
{

OutputView output_view(const Simulation& simulation, std::size_t number, const PhysicalScale& scale)
{
    std::vector<Vec3> as_folded = simulation.surface_positions();
    std::vector<Vec3> surface = scaled(as_folded, scale.length);
    auto F = std::make_shared<const std::vector<Mat3>>(simulation.deformation_gradients());
    return {simulation, number, scale, std::move(F), std::move(surface), std::move(as_folded)};
}

} // namespace corticle::model
