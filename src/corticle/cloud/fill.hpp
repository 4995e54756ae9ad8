// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud.hpp"
#include "corticle/cloud/cloud_options.hpp"
#include "corticle/geometry/surface_tree.hpp"

namespace corticle
{

/// Fills the inside of a closed surface whose edges are about `options.spacing` long.
Cloud fill_surface(const TriangleMesh& surface, const CloudOptions& options);

} // namespace corticle
