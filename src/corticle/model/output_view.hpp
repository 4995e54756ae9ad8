// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/physical_scale.hpp"
#include "corticle/model/simulation.hpp"

namespace corticle::model
{

/// A simulation at an output time, gathered and scaled once for all who look at it.
struct OutputView
{
    const Simulation& simulation;
    std::size_t number; ///< of the output, from 0 at the start of the run
    PhysicalScale scale;
    std::shared_ptr<const std::vector<Mat3>> F; ///< deformation gradients of the nodes [-], shared with who keeps them
    std::vector<Vec3> surface;                  ///< positions of the surface vertices [mm at the week]
    std::vector<Vec3> as_folded;                ///< the same in mm of the run

    const Model& model() const { return simulation.model(); }
    const State& state() const { return simulation.state(); }
    std::span<const Triangle> triangles() const { return model().cloud.surface_triangles; }
};

OutputView output_view(const Simulation& simulation, std::size_t number, const PhysicalScale& scale);
inline OutputView output_view(const Simulation& simulation, std::size_t number = 0)
{
    return output_view(simulation, number, physical_scale(simulation));
}

} // namespace corticle::model
