// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/cloud.hpp"

namespace corticle::cloud
{

/// Decides which particles see each other through the body.
class Visibility
{
  public:
    /// Prepares the test for pairs closer than `support` [mm]. Keeps a reference to the surface.
    Visibility(const Cloud& cloud, const geometry::SurfaceTree& surface, double support);

    /// Does the segment between the two, its ends moved inward where they lie near the surface, stay in the body?
    bool see_each_other(std::int32_t i, std::int32_t j) const;

  private:
    const geometry::SurfaceTree& surface_;
    std::vector<Vec3> viewpoints_; ///< positions, at least half a spacing deep where the body is thick enough [mm]
    std::vector<double> depths_;   ///< of the viewpoints, or the support where they are deeper [mm]
};

} // namespace corticle::cloud
