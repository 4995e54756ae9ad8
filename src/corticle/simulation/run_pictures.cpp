// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/run_pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/io/pictures.hpp"
#include "corticle/io/vtk_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>

namespace corticle
{

namespace
{

/// A colour range that shows the bulk: the 2nd to 98th percentile, widened to a round number.
ColorScale robust_scale(std::string label, std::span<const double> values, std::string map)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share)
    { return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]; };
    double low = std::floor(at(0.02) * 10.0) / 10.0;
    const double high = std::ceil(at(0.98) * 10.0) / 10.0;
    low = high - low < 0.1 ? high - 0.1 : low;
    return {std::move(label), low, high, std::move(map)};
}

using Fields = std::vector<std::pair<std::string, std::vector<double>>>;

/// An array of `components` values for each of `count` points.
const std::vector<double>& field(const Fields& fields, const std::string& name, std::size_t components,
                                 std::size_t count, const std::filesystem::path& file)
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

/// A frame from its files; their names end in "_NAME.vtp" and "_NAME.vtu".
Frame read_frame(double t, const std::filesystem::path& surface_file, const std::filesystem::path& particle_file)
{
    const SurfaceFile surface = read_surface_vtp(surface_file);
    const ParticleFile cloud = read_particles_vtu(particle_file);
    const auto of_surface = [&](const std::string& name) -> const std::vector<double>&
    { return field(surface.fields, name, 1, surface.mesh.vertices.size(), surface_file); };
    const auto of_particles = [&](const std::string& name, std::size_t components) -> const std::vector<double>&
    { return field(cloud.fields, name, components, cloud.points.size(), particle_file); };
    const std::string stem = surface_file.stem().string();
    Frame frame;
    frame.t = t;
    frame.name = stem.substr(stem.rfind('_') + 1);
    frame.particles = cloud.points;
    const std::vector<double>& displacement = of_particles("displacement", 3);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
    {
        frame.origins.push_back(cloud.points[i] -
                                Vec3{displacement[3 * i], displacement[3 * i + 1], displacement[3 * i + 2]});
    }
    frame.F = matrices(of_particles("F", 9));
    frame.spacing = mean_spacing(of_particles("volume", 1));
    frame.theta = of_particles("theta", 1);
    frame.particle_growth = of_particles("growth", 1);
    frame.surface = surface.mesh.vertices;
    frame.triangles = surface.mesh.triangles;
    frame.surface_J = of_surface("J");
    frame.surface_growth = of_surface("growth");
    if (!(frame.spacing > 0.0) || !std::isfinite(frame.spacing))
    {
        throw InputError(
            fmt::format("{}: the mean of array volume is not positive; expected volumes of particles [mm³]",
                        particle_file.string()));
    }
    return frame;
}

std::string read_text(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
    {
        throw InputError(fmt::format("{}: cannot be read; expected a run folder made by corticle run", file.string()));
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

double mean_spacing(std::span<const double> volumes)
{
    return std::cbrt(std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(volumes.size()));
}

void render_frame(const std::filesystem::path& folder, const Frame& frame)
{
    const std::filesystem::path pictures = folder / "pictures";
    std::filesystem::create_directories(pictures);
    const std::string title = fmt::format("t = {:.3f}", frame.t);
    render_surface(pictures / fmt::format("surface_J_{}.png", frame.name), frame.surface, frame.triangles,
                   frame.surface_J, robust_scale("J = det F", frame.surface_J, "viridis"), title);
    render_surface(pictures / fmt::format("surface_growth_{}.png", frame.name), frame.surface, frame.triangles,
                   frame.surface_growth, robust_scale("growth g", frame.surface_growth, "viridis"), title);
    const auto [back, front] = std::minmax_element(frame.surface.begin(), frame.surface.end(),
                                                   [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    const CutInput cut{.positions = frame.particles,
                       .origins = frame.origins,
                       .F = frame.F,
                       .theta = frame.theta,
                       .scalar = frame.particle_growth,
                       .spacing = frame.spacing,
                       .surface_points = frame.surface,
                       .triangles = frame.triangles,
                       .axis = 1,
                       .coordinate = 0.5 * (back->y + front->y)};
    render_cut(pictures / fmt::format("cut_{}.png", frame.name), cut,
               robust_scale("growth g", frame.particle_growth, "viridis"), title);
}

void render_measures(const std::filesystem::path& folder, std::span<const Measures> rows)
{
    const auto curve = [&](std::string label, double Measures::*value)
    {
        Curve c{std::move(label), {}, {}};
        for (const Measures& row : rows)
        {
            c.x.push_back(row.t);
            c.y.push_back(row.*value);
        }
        return c;
    };
    const std::array panels{
        Panel{"t", "ratio to t = 0", {curve("area", &Measures::area_ratio), curve("volume", &Measures::volume_ratio)}},
        Panel{"t", "gyrification index", {curve("hull", &Measures::gi_hull), curve("sphere", &Measures::gi_sphere)}},
        Panel{"t",
              "J",
              {curve("least", &Measures::J_min), curve("mean", &Measures::J_mean), curve("largest", &Measures::J_max)}},
        Panel{"t",
              "energy [mu_w mm³]",
              {curve("elastic", &Measures::energy_elastic), curve("zero-energy control", &Measures::energy_zero_mode)}},
        Panel{"t",
              "energy [mu_w mm³]",
              {curve("kinetic", &Measures::energy_kinetic), curve("contact", &Measures::energy_contact)}},
        Panel{"t", "overlapping area share", {curve("overlap", &Measures::overlap_area_share)}},
    };
    std::filesystem::create_directories(folder / "pictures");
    render_plot(folder / "pictures" / "measures.png", panels, "Measures against growth time");
}

void render_run(const std::filesystem::path& folder)
{
    const std::vector<Measures> rows =
        parse_measures_csv(read_text(folder / "measures.csv"), (folder / "measures.csv").string());
    const auto surfaces = read_pvd(folder / "surface.pvd");
    const auto particles = read_pvd(folder / "particles.pvd");
    if (surfaces.size() != particles.size())
    {
        throw InputError(fmt::format("{}: surface.pvd lists {} frames and particles.pvd {}; expected the same number",
                                     folder.string(), surfaces.size(), particles.size()));
    }
    std::string reason;
    if (!can_render(reason))
    {
        throw RunError("pictures cannot be made: " + reason);
    }
    for (std::size_t k = 0; k < surfaces.size(); ++k)
    {
        render_frame(folder, read_frame(surfaces[k].first, folder / surfaces[k].second, folder / particles[k].second));
    }
    render_measures(folder, rows);
}

} // namespace corticle
