// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/frames.hpp"

#include "corticle/base/gather.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/model/node_stress.hpp"

#include <cmath>
#include <numeric>

namespace corticle::record
{

namespace
{

/// Arrays of one point per particle that a frame's files show besides those of Frame.
struct ParticleArrays
{
    std::vector<double> J;
    std::vector<double> F;            ///< deformation gradient, 9 a particle, by rows [-]
    std::vector<double> stress;       ///< Cauchy stress, 9 a particle, by rows [mu_w]
    std::vector<double> displacement; ///< 3 a particle [mm]
    std::vector<double> normal;       ///< 3 a particle
};

/// (3/2 s : s)^(1/2) of the deviator s of each stress [mu_w].
std::vector<double> von_mises(std::span<const double> stress)
{
    std::vector<double> result(stress.size() / 9);
    for (std::size_t i = 0; i < result.size(); ++i)
    {
        const std::span<const double> sigma = stress.subspan(9 * i, 9);
        const double mean = (sigma[0] + sigma[4] + sigma[8]) / 3.0;
        double squares = 0.0;
        for (std::size_t k = 0; k < 9; ++k)
        {
            const double deviator = sigma[k] - (k % 4 == 0 ? mean : 0.0);
            squares += deviator * deviator;
        }
        result[i] = std::sqrt(1.5 * squares);
    }
    return result;
}

double growth_at(const model::Simulation& simulation, std::size_t i)
{
    return simulation.tissue().point(i, simulation.state().t).growth;
}

std::vector<double> times(std::span<const double> values, double factor)
{
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result)
    {
        value *= factor;
    }
    return result;
}

ParticleArrays particle_arrays(const model::Simulation& simulation, const Frame& frame)
{
    const material::TissueFields& tissue = simulation.model().tissue;
    const std::vector<Mat3>& F = *frame.F;
    const model::NodeStress stresses(simulation);
    const std::size_t count = F.size();
    ParticleArrays a{std::vector<double>(count), std::vector<double>(9 * count), std::vector<double>(9 * count),
                     std::vector<double>(3 * count), std::vector<double>(3 * count)};
    parallel_for(static_cast<std::int64_t>(count),
                 [&](std::int64_t signed_i)
                 {
                     const auto i = static_cast<std::size_t>(signed_i);
                     const Mat3 sigma = stresses.cauchy(i, F[i]);
                     const Vec3 u = frame.particles[i] - frame.origins[i];
                     a.J[i] = determinant(F[i]);
                     for (int row = 0; row < 3; ++row)
                     {
                         const auto r = static_cast<std::size_t>(row);
                         a.displacement[3 * i + r] = u[row];
                         a.normal[3 * i + r] = std::as_const(tissue.normal[i])[row];
                         for (int col = 0; col < 3; ++col)
                         {
                             a.F[9 * i + 3 * r + static_cast<std::size_t>(col)] = F[i](row, col);
                             a.stress[9 * i + 3 * r + static_cast<std::size_t>(col)] = sigma(row, col);
                         }
                     }
                 });
    return a;
}

} // namespace

double mean_spacing(std::span<const double> volumes)
{
    return std::cbrt(std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(volumes.size()));
}

Frame make_frame(const model::OutputView& view, const metrics::SurfaceArrays& arrays, std::string name)
{
    const model::Simulation& simulation = view.simulation;
    const model::PhysicalScale& scale = view.scale;
    const Cloud& cloud = simulation.model().cloud;
    Frame frame;
    frame.t = simulation.state().t;
    frame.week = scale.week;
    frame.length_scale = scale.length;
    frame.name = std::move(name);
    frame.particles = model::scaled(simulation.state().motion.x, scale.length);
    frame.origins = model::scaled(cloud.positions, scale.length);
    frame.F = view.F;
    frame.spacing = mean_spacing(cloud.volumes) * scale.length;
    frame.theta = simulation.state().nodes.theta;
    frame.surface = view.surface;
    frame.triangles = cloud.surface_triangles;
    std::vector<double> J;
    for (std::size_t i = 0; i < view.F->size(); ++i)
    {
        frame.particle_growth.push_back(growth_at(simulation, i));
        J.push_back(determinant((*view.F)[i]));
    }
    frame.surface_J = surface_values(cloud, J);
    frame.surface_growth = surface_values(cloud, frame.particle_growth);
    frame.sulcal_depth = arrays.folds.sulcal_depth;
    frame.mean_curvature = arrays.folds.curvature.mean;
    return frame;
}

void write_frame(const std::filesystem::path& folder, const model::OutputView& view, const Frame& frame,
                 const metrics::SurfaceArrays& arrays)
{
    const model::Simulation& simulation = view.simulation;
    const Cloud& cloud = simulation.model().cloud;
    const material::TissueFields& tissue = simulation.model().tissue;
    const ParticleArrays a = particle_arrays(simulation, frame);
    const std::vector<double> depth = times(tissue.depth, frame.length_scale);
    const std::vector<double> volume = times(cloud.volumes, std::pow(frame.length_scale, 3));
    std::vector<std::int32_t> ids(frame.particles.size());
    std::iota(ids.begin(), ids.end(), 0);
    const std::vector particle_fields{formats::Field{"J", 1, a.J},
                                      formats::Field{"theta", 1, frame.theta},
                                      formats::Field{"growth", 1, frame.particle_growth},
                                      formats::Field{"F", 9, a.F},
                                      formats::Field{"stress", 9, a.stress},
                                      formats::Field{"displacement", 3, a.displacement},
                                      formats::Field{"depth", 1, depth},
                                      formats::Field{"normal", 3, a.normal},
                                      formats::Field{"volume", 1, volume}};
    formats::write_particles_vtu(folder / ("particles_" + frame.name + ".vtu"), frame.particles, ids, particle_fields);

    const std::vector<double> id(cloud.surface_particles.begin(), cloud.surface_particles.end());
    const std::vector<double> theta = surface_values(cloud, frame.theta);
    const std::vector<double> displacement = surface_values(cloud, a.displacement, 3);
    const std::vector<double> stress = surface_values(cloud, von_mises(a.stress));
    const std::vector<double> boundary = flattened(arrays.boundary);
    const metrics::Curvature& curvature = arrays.folds.curvature;
    const std::vector<double> region =
        tissue.region.empty() ? std::vector<double>{} : surface_values(cloud, tissue.region);
    std::vector surface_fields{formats::Field{"J", 1, frame.surface_J},
                               formats::Field{"theta", 1, theta},
                               formats::Field{"growth", 1, frame.surface_growth},
                               formats::Field{"displacement", 3, displacement},
                               formats::Field{"mean_curvature", 1, curvature.mean},
                               formats::Field{"gaussian_curvature", 1, curvature.gaussian},
                               formats::Field{"shape_index", 1, curvature.shape_index},
                               formats::Field{"curvedness", 1, curvature.curvedness},
                               formats::Field{"sulcal_depth", 1, arrays.folds.sulcal_depth},
                               formats::Field{"local_gyrification", 1, arrays.folds.local_gyrification},
                               formats::Field{"thickness", 1, arrays.thickness},
                               formats::Field{"von_mises", 1, stress},
                               formats::Field{"cortex_boundary", 3, boundary},
                               formats::Field{"id", 1, id}};
    if (!region.empty())
    {
        surface_fields.push_back({"region", 1, region});
    }
    formats::write_surface_vtp(folder / ("surface_" + frame.name + ".vtp"), frame.surface, frame.triangles,
                               surface_fields);
}

} // namespace corticle::record
