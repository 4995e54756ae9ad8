// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"

namespace corticle::prepare
{

// What the thesis does its own way in preparing a body, where the options ask for it.

/// Volumes by neighbour counts, which are of no cells: the particles themselves are the material points.
void apply_thesis_volumes(const PreparationOptions& options, Cloud& cloud);

/// Normals in divisions of the sphere.
void apply_thesis_normals(const PreparationOptions& options, model::Model& model);

/// Whether the cortex is that of thesis eq. 24.
bool has_layer_by_lambda(const PreparationOptions& options);

/// theta of thesis eq. 24 at places. @param volumes  of the places [mm³]
std::vector<double> layer_by_lambda(const PreparationOptions& options, std::span<const Vec3> nodes,
                                    std::span<const Vec3> places, std::span<const double> volumes);

/// Thickness of that cortex, along the shortest semi-axis [mm].
double thickness_by_lambda(const PreparationOptions& options, const model::Model& model);

} // namespace corticle::prepare
