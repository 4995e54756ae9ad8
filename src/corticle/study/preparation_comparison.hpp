// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/formats/field.hpp"
#include "corticle/model/model.hpp"
#include "corticle/study/regularity.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace corticle::study
{

/// The thesis's own choices in pre-processing (sections 2.4.1, 2.4.2 and 3.2).
struct ThesisPreparation
{
    double kernel_radius_mm = 3.0;                 ///< within which neighbours are counted (table 5)
    double lambda = 0.75;                          ///< of eq. 24
    std::vector<std::int32_t> divisions{4, 8, 16}; ///< for the normals (table 4)
    double dense_ratio = 2.1;                      ///< points before thinning over points after (figure 4)
    std::uint64_t seed = 1;                        ///< of the thinning
};

/// Angles between the normals of one choice and the exact ones, over all particles [degrees].
struct NormalErrors
{
    std::string choice;
    double mean = 0.0;
    double percentile_95 = 0.0;
    double largest = 0.0;
    double mean_in_cortex = 0.0; ///< over the exact cortex
};

/// Volumes of one choice against those of the cells integrated on four times as fine a lattice of lines.
struct VolumeErrors
{
    std::string choice;
    double sum = 0.0;           ///< (sum - enclosed volume) / enclosed volume
    double rms = 0.0;           ///< of (V - V_exact) / V_exact, over all particles
    double largest = 0.0;       ///< of |V - V_exact| / V_exact
    double surface_ratio = 0.0; ///< sum of V over sum of V_exact, particles on the surface
    double below_ratio = 0.0;   ///< the same, particles within a kernel of the surface and not on it
    double deep_ratio = 0.0;    ///< the same, particles deeper than that; 0 when there are none
};

/// Distances to the surface of one choice against the exact ones [mm].
struct DepthErrors
{
    std::string choice;
    double mean = 0.0; ///< of |y - y_exact|
    double largest = 0.0;
};

/// The sharp cortex of one choice against the exact one.
struct LayerErrors
{
    std::string choice;
    double cortex_share = 0.0;      ///< volume of the cortex over that of the body
    double misassigned_share = 0.0; ///< volume of the particles that are cortex and lie outside of it, or the reverse,
                                    ///< over that of the body
};

/// How evenly one choice spreads its particles.
struct CloudRegularity
{
    std::string choice;
    Regularity regularity;
};

/// How far each of the thesis's choices is from the exact answer, beside ours.
struct PreparationComparison
{
    ThesisPreparation thesis;
    std::string reference; ///< what the exact depths and normals are those of
    std::int64_t particles = 0;
    double spacing_mm = 0.0;
    double exact_cortex_share = 0.0;
    std::vector<NormalErrors> normals;
    std::vector<VolumeErrors> volumes;
    std::vector<DepthErrors> depths;
    std::vector<LayerErrors> layers;
    std::vector<CloudRegularity> clouds;

    // For pictures and particle files, one value per particle; of the normals, the middle number of divisions.
    std::vector<double> normal_error;       ///< thesis [degrees]
    std::vector<double> volume_ratio;       ///< thesis over exact
    std::vector<double> thesis_theta;       ///< thesis
    std::vector<double> layer_disagreement; ///< thesis less exact: 1 or -1 where wrong
};

/// Compares on a prepared body. Thins a cloud `dense_ratio` times as dense, which it makes.
/// @param options  those the body was prepared with
/// @throws InputError where one of the thesis's choices cannot be made on this body
PreparationComparison compare_preparation(const model::Model& model, const config::Options& options,
                                          const ThesisPreparation& thesis = {});

/// The figures as a JSON object (without what is per particle): what `preparation.json` holds as "thesis_comparison".
std::string comparison_json(const PreparationComparison& comparison);

/// The figures as Markdown tables.
std::string comparison_text(const PreparationComparison& comparison);

/// What is per particle, for a particle file. The fields refer to the comparison.
std::vector<formats::Field> comparison_fields(const PreparationComparison& comparison);

/// Names of the pictures that write_comparison_pictures draws.
inline constexpr std::array thesis_pictures{"thesis_normals.png", "thesis_volumes.png", "thesis_layer.png"};

/// Cross-sections through the middle of the body: `thesis_normals.png`, `thesis_volumes.png`, `thesis_layer.png`, each
/// with the thesis's layer on the left. Needs a display or Xvfb, see view/pictures.hpp.
void write_comparison_pictures(const std::filesystem::path& folder, const model::Model& model,
                               const PreparationComparison& comparison);

} // namespace corticle::study
