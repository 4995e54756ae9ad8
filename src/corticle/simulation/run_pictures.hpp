// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/geometry/triangle_mesh.hpp"
#include "corticle/io/pictures.hpp"
#include "corticle/simulation/measures.hpp"

#include <filesystem>

namespace corticle
{

/// One output time of a run, as its files hold it.
struct Frame
{
    double t = 0.0;
    double week = std::numeric_limits<double>::quiet_NaN(); ///< not a number where it is not known
    std::string name;                                       ///< "0007": part of every file name of the frame
    std::vector<Vec3> particles;                            ///< current positions [mm]
    std::vector<Vec3> origins;                              ///< reference positions of the particles [mm]
    std::vector<Mat3> F;                                    ///< deformation gradients of the particles [-]
    double spacing = 0.0;                                   ///< of the particles in the reference configuration [mm]
    double length_scale = 1.0;                              ///< mm here per mm of the run, known while the run goes on
    std::vector<double> theta;                              ///< [-]
    std::vector<double> particle_growth;                    ///< g [-]
    std::vector<Vec3> surface;                              ///< current positions of the surface vertices [mm]
    std::vector<Triangle> triangles;
    std::vector<double> surface_J;
    std::vector<double> surface_growth;
    std::vector<double> sulcal_depth;   ///< of the surface vertices [mm]
    std::vector<double> mean_curvature; ///< of the surface vertices [1/mm]
};

/// Edge of a cube of the mean volume [mm]; not a number where there are no volumes [mm³].
double mean_spacing(std::span<const double> volumes);

/// A colour range that shows the bulk of the values (at least one): the 2nd to 98th percentile, widened to tenths.
ColorScale robust_scale(std::string label, std::span<const double> values, std::string map);

/// The cut through the middle of a frame, across y, that shows `scalar` of its particles. Refers to both.
CutInput middle_cut(const Frame& frame, std::span<const double> scalar);

/// Where the plot of the measures lies in a run folder.
inline constexpr const char* measures_picture = "pictures/measures.png";

/// Names of the pictures of a frame, relative to the run folder.
std::vector<std::string> frame_pictures(const std::string& name);

/// Pictures of one frame: surface by J, growth, sulcal depth and mean curvature, cut through the middle across y
/// (coronal where x points to the right and y to the front). `folder` is the run folder.
void render_frame(const std::filesystem::path& folder, const Frame& frame);

/// Plot of the measures against t.
void render_measures(const std::filesystem::path& folder, std::span<const Measures> rows);

/// Remakes all pictures of a run folder from its files.
/// @throws InputError when it is not a run folder, a run still writes to it, or a file that the program did not write
/// would be replaced
void render_run(const std::filesystem::path& folder);

} // namespace corticle
