// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/export.hpp"

#include "corticle/base/error.hpp"
#include "corticle/io/freesurfer.hpp"
#include "corticle/io/gifti.hpp"
#include "corticle/io/surface_writer.hpp"
#include "corticle/io/vtk_files.hpp"
#include "corticle/simulation/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <system_error>

namespace corticle
{

namespace
{

namespace fs = std::filesystem;
using Frames = std::vector<std::pair<double, std::string>>;

constexpr std::array<std::string_view, 4> formats{"gifti", "freesurfer", "ply", "stl"};

Frames read_frames(const fs::path& run)
{
    const fs::path file = run / "surface.pvd";
    if (!fs::exists(file))
    {
        throw InputError(
            fmt::format("{}: holds no surface.pvd; expected a run folder made by corticle run", run.string()));
    }
    Frames frames = read_pvd(file);
    const bool finite = std::ranges::all_of(frames, [](const auto& frame) { return std::isfinite(frame.first); });
    if (frames.empty() || !finite)
    {
        throw InputError(fmt::format("{}: {}; expected the frames of a run", file.string(),
                                     frames.empty() ? "lists no frame" : "a time is not finite"));
    }
    return frames;
}

/// Index of each frame to write, with the times asked for that it is nearest to.
std::map<std::size_t, std::vector<double>> chosen_frames(const Frames& frames, const std::vector<double>& times)
{
    std::map<std::size_t, std::vector<double>> chosen;
    if (times.empty())
    {
        chosen[frames.size() - 1];
    }
    for (const double t : times)
    {
        if (!std::isfinite(t))
        {
            throw InputError(fmt::format("--time: got {}; expected a growth time", t));
        }
        const auto nearest =
            std::ranges::min_element(frames, {}, [&](const auto& frame) { return std::abs(frame.first - t); });
        chosen[static_cast<std::size_t>(nearest - frames.begin())].push_back(t);
    }
    return chosen;
}

/// As many decimals as tell all times apart, at least three.
int decimals_for(const Frames& frames)
{
    constexpr int fewest = 3;
    constexpr int most = 17;
    for (int decimals = fewest; decimals < most; ++decimals)
    {
        std::set<std::string> names;
        std::set<double> times;
        for (const auto& [t, file] : frames)
        {
            names.insert(fmt::format("{:.{}f}", t, decimals));
            times.insert(t);
        }
        if (names.size() == times.size())
        {
            return decimals;
        }
    }
    return most;
}

/// The scalar fields, each under a name that suits a file.
std::vector<std::pair<Field, std::string>> scalar_fields(const SurfaceFile& surface)
{
    std::vector<std::pair<Field, std::string>> scalars;
    std::set<std::string> taken;
    for (const auto& [name, values] : surface.fields)
    {
        if (values.size() != surface.mesh.vertices.size())
        {
            continue; // vectors and tensors
        }
        std::string part = name.empty() ? "array" : name;
        std::ranges::replace_if(
            part, [](char c) { return c == '/' || static_cast<unsigned char>(c) <= ' ' || c == 0x7f; }, '_');
        while (!taken.insert(part).second)
        {
            part += '_';
        }
        scalars.emplace_back(Field{name, 1, values}, part);
    }
    return scalars;
}

std::vector<std::string> write_frame(const ExportRequest& request, const fs::path& out, const std::string& stem,
                                     const SurfaceFile& surface)
{
    const auto& [points, triangles] = surface.mesh;
    const auto scalars = scalar_fields(surface);
    std::vector<std::string> files;
    const auto next = [&](const std::string& name) { return out / files.emplace_back(name); };
    if (request.format == "ply")
    {
        std::vector<Field> fields;
        fields.reserve(scalars.size());
        for (const auto& [field, part] : scalars)
        {
            fields.push_back({part, 1, field.values});
        }
        write_surface_ply(next(stem + ".ply"), points, triangles, fields);
    }
    else if (request.format == "stl")
    {
        write_surface_stl(next(stem + ".stl"), points, triangles);
    }
    else if (request.format == "freesurfer")
    {
        write_surface_freesurfer(next(stem + ".surf"), points, triangles);
        for (const auto& [field, part] : scalars)
        {
            write_scalars_freesurfer(next(fmt::format("{}.{}.curv", stem, part)), field.values, triangles.size());
        }
    }
    else
    {
        const std::string structure = request.structure.empty() ? "Cortex" : request.structure;
        write_surface_gifti(next(stem + ".surf.gii"), points, triangles, structure);
        for (const auto& [field, part] : scalars)
        {
            write_scalars_gifti(next(fmt::format("{}.{}.shape.gii", stem, part)), {&field, 1}, structure);
        }
    }
    return files;
}

} // namespace

std::vector<ExportedFrame> export_run(const ExportRequest& request)
{
    if (std::ranges::find(formats, request.format) == formats.end())
    {
        throw InputError(fmt::format("--format: got \"{}\"; expected {}", request.format, fmt::join(formats, ", ")));
    }
    const Frames frames = read_frames(request.run);
    const auto chosen = chosen_frames(frames, request.times);
    const int decimals = decimals_for(frames);
    const fs::path out = request.out.empty() ? request.run / "export" : request.out;
    std::vector<ExportedFrame> exported;
    for (const auto& [index, asked] : chosen)
    {
        const auto& [t, name] = frames[index];
        const SurfaceFile surface = read_surface_vtp(request.run / name);
        create_folder(out);
        exported.push_back(
            {t, asked, write_frame(request, out, fmt::format("surface_t{:.{}f}", t, decimals), surface)});
    }
    return exported;
}

} // namespace corticle
