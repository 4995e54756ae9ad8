// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/mesh/triangle_mesh.hpp"
#include "corticle/metrics/surface_arrays.hpp"
#include "corticle/model/physical_scale.hpp"
#include "corticle/model/simulation.hpp"

#include <filesystem>
#include <memory>

namespace corticle::record
{

/// One output time of a run, as its files hold it.
struct Frame
{
    double t = 0.0;
    double week = std::numeric_limits<double>::quiet_NaN(); ///< NaN where it is not known
    std::string name;                                       ///< "0007": part of every file name of the frame
    std::vector<Vec3> particles;                            ///< current positions [mm]
    std::vector<Vec3> origins;                              ///< reference positions of the particles [mm]
    std::shared_ptr<const std::vector<Mat3>> F;             ///< deformation gradients of the particles [-]
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

/// Edge of a cube of the mean volume [mm]; NaN where there are no volumes [mm³].
double mean_spacing(std::span<const double> volumes);

/// The run at its present time, as its files show it: all lengths in mm at its week.
/// @param scale  physical_scale(simulation)
Frame make_frame(const model::OutputView& view, const metrics::SurfaceArrays& arrays, std::string name);

/// Writes surface_NAME.vtp (J, theta, growth, displacement, the arrays measured on the surface,
/// von_mises, cortex_boundary, id, and region where the body has labels) and
/// particles_NAME.vtu (J, theta, growth, F, stress, displacement, depth, normal, volume, id), each whole or not at all.
void write_frame(const std::filesystem::path& folder, const model::OutputView& view, const Frame& frame,
                 const metrics::SurfaceArrays& arrays);

} // namespace corticle::record
