// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/run_reader.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/vtk_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::record
{

namespace
{

namespace fs = std::filesystem;

using Fields = std::vector<std::pair<std::string, std::vector<double>>>;

/// An array of `components` finite values for each of `count` points.
const std::vector<double>& field(const Fields& fields, const std::string& name, std::size_t components,
                                 std::size_t count, const fs::path& file)
{
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const auto& entry) { return entry.first == name; });
    if (found == fields.end())
    {
        throw InputError(fmt::format("{}: no array named {}", file.string(), name));
    }
    if (found->second.size() != components * count)
    {
        throw InputError(fmt::format("{}: array {} holds {} values; expected {} for each of {} points", file.string(),
                                     name, found->second.size(), components, count));
    }
    if (!std::all_of(found->second.begin(), found->second.end(), [](double value) { return std::isfinite(value); }))
    {
        throw InputError(fmt::format("{}: array {} holds a value that is not finite", file.string(), name));
    }
    return found->second;
}

std::vector<Mat3> matrices(std::span<const double> by_rows)
{
    std::vector<Mat3> result(by_rows.size() / 9);
    for (std::size_t i = 0; i < by_rows.size(); ++i)
    {
        result[i / 9](static_cast<int>(i % 9 / 3), static_cast<int>(i % 3)) = by_rows[i];
    }
    return result;
}

void require_finite(std::span<const Vec3> points, const fs::path& file)
{
    if (points.empty() || !std::all_of(points.begin(), points.end(), is_finite))
    {
        throw InputError(fmt::format("{}: {}; expected points with finite coordinates", file.string(),
                                     points.empty() ? "no points" : "a point that is not finite"));
    }
}

} // namespace

std::string FrameFiles::name() const
{
    const std::string stem = surface.stem().string();
    return stem.substr(stem.rfind('_') + 1);
}

bool is_run_folder(const fs::path& folder)
{
    std::error_code error;
    return fs::is_directory(folder, error) &&
           (fs::exists(folder / "case.toml", error) || fs::exists(folder / "surface.pvd", error));
}

std::vector<FrameFiles> list_frames(const fs::path& folder)
{
    if (!is_run_folder(folder))
    {
        std::error_code error;
        throw InputError(fmt::format("{}: {}; expected a run folder made by corticle run", folder.string(),
                                     fs::exists(folder, error) ? "not a run folder" : "no such folder"));
    }
    std::error_code error;
    if (!fs::exists(folder / "surface.pvd", error))
    {
        throw InputError(fmt::format("{}: this run has no frames (no surface.pvd); expected at least one output time",
                                     folder.string()));
    }
    const auto surfaces = formats::read_pvd(folder / "surface.pvd");
    const auto particles = formats::read_pvd(folder / "particles.pvd");
    if (surfaces.size() != particles.size() || surfaces.empty())
    {
        throw InputError(fmt::format("{}: surface.pvd lists {} frames and particles.pvd {}; expected the same number, "
                                     "at least one",
                                     folder.string(), surfaces.size(), particles.size()));
    }
    std::vector<FrameFiles> frames;
    for (std::size_t k = 0; k < surfaces.size(); ++k)
    {
        const double t = surfaces[k].first;
        if (!std::isfinite(t) || particles[k].first != t || (k > 0 && t <= frames.back().t))
        {
            throw InputError(fmt::format("{}: frame {} at t = {} in surface.pvd and {} in particles.pvd; expected the "
                                         "same ascending times in both",
                                         folder.string(), k, t, particles[k].first));
        }
        frames.push_back({t, folder / surfaces[k].second, folder / particles[k].second});
    }
    return frames;
}

RunContents read_run(const fs::path& folder)
{
    RunContents run{folder, {}, list_frames(folder)};
    const fs::path file = folder / "measures.csv";
    run.measures = formats::read_number_table(file);
    const formats::NumberColumn* const t = run.measures.find("t");
    if (t == nullptr || t->values.empty())
    {
        throw InputError(fmt::format("{}: {}; expected the measures of a run", file.string(),
                                     t == nullptr ? "no column t" : "no rows"));
    }
    // Not (a < b): also where one is NaN.
    if (std::adjacent_find(t->values.begin(), t->values.end(), [](double a, double b) { return !(a < b); }) !=
            t->values.end() ||
        !std::isfinite(t->values.front()) || !std::isfinite(t->values.back()))
    {
        throw InputError(fmt::format("{}: t does not ascend from row to row; expected output times", file.string()));
    }
    return run;
}

double week_at(const formats::NumberTable& measures, double t)
{
    const formats::NumberColumn* const times = measures.find("t");
    const formats::NumberColumn* const weeks = measures.find("week");
    for (std::size_t k = 0; weeks != nullptr && times != nullptr && k < times->values.size(); ++k)
    {
        if (std::abs(times->values[k] - t) < model::same_output_time)
        {
            return weeks->values[k];
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

Frame read_frame(const FrameFiles& files)
{
    const formats::SurfaceFile surface = formats::read_surface_vtp(files.surface);
    const formats::ParticleFile cloud = formats::read_particles_vtu(files.particles);
    require_finite(surface.mesh.vertices, files.surface);
    require_finite(cloud.points, files.particles);
    const auto of_surface = [&](const std::string& name) -> const std::vector<double>&
    { return field(surface.fields, name, 1, surface.mesh.vertices.size(), files.surface); };
    const auto of_particles = [&](const std::string& name, std::size_t components) -> const std::vector<double>&
    { return field(cloud.fields, name, components, cloud.points.size(), files.particles); };
    Frame frame;
    frame.t = files.t;
    frame.name = files.name();
    frame.particles = cloud.points;
    const std::vector<double>& displacement = of_particles("displacement", 3);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
    {
        frame.origins.push_back(cloud.points[i] -
                                Vec3{displacement[3 * i], displacement[3 * i + 1], displacement[3 * i + 2]});
    }
    require_finite(frame.origins, files.particles);
    frame.F = std::make_shared<const std::vector<Mat3>>(matrices(of_particles("F", 9)));
    frame.spacing = mean_spacing(of_particles("volume", 1));
    frame.theta = of_particles("theta", 1);
    frame.particle_growth = of_particles("growth", 1);
    frame.surface = surface.mesh.vertices;
    frame.triangles = surface.mesh.triangles;
    frame.surface_J = of_surface("J");
    frame.surface_growth = of_surface("growth");
    frame.sulcal_depth = of_surface("sulcal_depth");
    frame.mean_curvature = of_surface("mean_curvature");
    if (!(frame.spacing > 0.0) || !std::isfinite(frame.spacing))
    {
        throw InputError(
            fmt::format("{}: the mean of array volume is not positive; expected volumes of particles [mm³]",
                        files.particles.string()));
    }
    return frame;
}

} // namespace corticle::record
