// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/model.hpp"

#include <array>
#include <filesystem>

namespace corticle::view
{

/// How well each particle of a prepared body sits, one number per particle.
struct BodyQuality
{
    std::vector<double> nearest_distance; ///< to the nearest particle it has a pair or a tet with [spacings]
    std::vector<double> volume_over_mean; ///< [-]
    std::vector<double> condition_number; ///< of the shape matrix [-]; with finite elements of its worst tet: the
                                          ///< reciprocal of the mean ratio
};

BodyQuality measure_body_quality(const model::Model& model);

/// Share of the body's volume that is cortex [-].
/// @param theta  of the particles [-]
double cortex_share(const model::Model& model, std::span<const double> theta);

/// Names of the pictures that render_body draws; those of maps only where the body has them.
inline constexpr std::array body_pictures{"cloud.png",     "layer.png",        "normals.png",     "surface.png",
                                          "thickness.png", "growth_onset.png", "growth_rate.png", "quality.png"};

/// Pictures of a prepared body: `cloud.png` (cells of the middle cut), `layer.png` (depth), `normals.png`, the surface
/// by regional growth (`surface.png`) and by each other map there is, and `quality.png` (histograms).
void render_body(const std::filesystem::path& folder, const model::Model& model, std::span<const double> theta,
                 const BodyQuality& quality);

} // namespace corticle::view
