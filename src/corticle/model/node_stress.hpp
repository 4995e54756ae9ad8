// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/remodelling_view.hpp"
#include "corticle/model/simulation.hpp"

namespace corticle::model
{

/// Stresses at the nodes of a simulation as it is now, by the law of the run's formulation. Where tissue has a history
/// and is cut into tets, that of a node is the mean over its tets, weighted with their volume.
class NodeStress
{
  public:
    explicit NodeStress(const Simulation& simulation);
    NodeStress(const NodeStress&) = delete;
    NodeStress& operator=(const NodeStress&) = delete;

    /// Cauchy stress from the deformation gradient at a node [mu_w].
    Mat3 cauchy(std::size_t node, const Mat3& F) const;

  private:
    const Simulation& simulation_;
    const material::RemodellingView* view_ = nullptr; ///< of the nodes, or null
    material::RemodellingView averaged_view_;
    std::vector<double> averaged_[3]; ///< strain, growth, fibre length
};

} // namespace corticle::model
