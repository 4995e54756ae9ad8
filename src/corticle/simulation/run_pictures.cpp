// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/run_pictures.hpp"

#include "corticle/base/error.hpp"
#include "corticle/io/pictures.hpp"
#include "corticle/io/vtk_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

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

const std::vector<double>& field(const std::vector<std::pair<std::string, std::vector<double>>>& fields,
                                 const std::string& name, const std::filesystem::path& file)
{
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const auto& entry) { return entry.first == name; });
    if (found == fields.end())
    {
        throw InputError(fmt::format("{}: no array named {}", file.string(), name));
    }
    return found->second;
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

void render_frame(const std::filesystem::path& folder, const Frame& frame)
{
    const std::filesystem::path pictures = folder / "pictures";
    std::filesystem::create_directories(pictures);
    const std::string title = fmt::format("t = {:.3f}", frame.t);
    render_surface(pictures / fmt::format("surface_J_{}.png", frame.name), frame.surface, frame.triangles,
                   frame.surface_J, robust_scale("J = det F", frame.surface_J, "viridis"), title);
    render_surface(pictures / fmt::format("surface_growth_{}.png", frame.name), frame.surface, frame.triangles,
                   frame.surface_growth, robust_scale("growth g", frame.surface_growth, "viridis"), title);
    double low = frame.surface.front().x;
    double high = low;
    for (const Vec3& x : frame.surface)
    {
        low = std::min(low, x.x);
        high = std::max(high, x.x);
    }
    // Slightly off the middle: a brain's midline would cut its fissure along its length.
    const double middle = low + 0.46 * (high - low);
    render_cut(pictures / fmt::format("cut_{}.png", frame.name), frame.particles, frame.theta, frame.particle_growth,
               frame.surface, frame.triangles, robust_scale("growth g", frame.particle_growth, "viridis"), 0, middle,
               title);
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
        const std::filesystem::path surface_file = folder / surfaces[k].second;
        const std::filesystem::path particle_file = folder / particles[k].second;
        const SurfaceFile surface = read_surface_vtp(surface_file);
        const ParticleFile cloud = read_particles_vtu(particle_file);
        const std::string stem = surface_file.stem().string();
        render_frame(folder, {surfaces[k].first, stem.substr(stem.rfind('_') + 1), cloud.points,
                              field(cloud.fields, "theta", particle_file), field(cloud.fields, "growth", particle_file),
                              surface.mesh.vertices, surface.mesh.triangles, field(surface.fields, "J", surface_file),
                              field(surface.fields, "growth", surface_file)});
    }
    render_measures(folder, rows);
}

} // namespace corticle
