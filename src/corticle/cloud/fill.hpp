// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/cloud.hpp"

namespace corticle::cloud
{

/// Spacing at which `count` particles fill a volume [mm³]: the cube root of volume per particle [mm].
double spacing_for_particles(double volume, std::int64_t count);

/// Fills the inside of a closed surface whose edges are about `options.spacing` long: a particle on every vertex, the
/// rest spread by short-range repulsion, so many that there are volume / spacing³ in all. The result depends on the
/// seed, not on the number of threads.
Cloud fill_surface(const TriangleMesh& surface, const CloudOptions& options);

} // namespace corticle::cloud
