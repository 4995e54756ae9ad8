// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"

namespace corticle::prepare
{

/// The skull that the options ask for, at the resolution of the body's surface; without triangles where there is none.
/// @throws InputError where it crosses the body, touches it or leaves some of it outside
TriangleMesh skull_surface(const PreparationOptions& options, const model::Model& model);

} // namespace corticle::prepare
