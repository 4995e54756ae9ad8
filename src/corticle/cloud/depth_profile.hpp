// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/geometry/surface_tree.hpp"

#include <vector>

namespace corticle::cloud
{

/// How much of a body lies how deep, sampled at some ten thousand places: what the number of particles of a graded
/// cloud follows from. Deterministic.
class DepthProfile
{
  public:
    explicit DepthProfile(const geometry::SurfaceTree& surface);

    /// Particles at a spacing [mm] at the surface: the integral of 1 / spacing³ over the body.
    double count(double spacing, const Grading& grading) const;

    /// Spacing at the surface [mm] at which there are `count` particles.
    double spacing_for(double count, const Grading& grading) const;

  private:
    std::vector<double> depths_; ///< of places that stand for equal volumes [mm]
    double volume_;              ///< [mm³]
};

} // namespace corticle::cloud
