// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/simulation/physical_scale.hpp"
#include "corticle/simulation/run_pictures.hpp"
#include "corticle/simulation/simulation.hpp"

namespace corticle
{

/// The run at its present time, as its files show it: all lengths in mm at its week.
/// @param scale  physical_scale(simulation)
Frame make_frame(const Simulation& simulation, std::vector<Mat3> F, const PhysicalScale& scale, std::string name);

/// Writes surface_NAME.vtp (J, theta, growth, displacement, the arrays measured on the surface, id) and
/// particles_NAME.vtu (J, theta, growth, F, stress, displacement, depth, normal, volume, id), each whole or not at all.
void write_frame(const std::filesystem::path& folder, const Simulation& simulation, const Frame& frame,
                 const SurfaceArrays& arrays);

} // namespace corticle
