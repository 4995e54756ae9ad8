// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/export.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/gather.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/gifti.hpp"
#include "corticle/formats/surfaces/freesurfer.hpp"
#include "corticle/formats/surfaces/surface_writer.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/formats/xml_tag.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/study/hemispheres.hpp"
#include "corticle/view/figures/anatomy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <system_error>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;
using Frames = std::vector<std::pair<double, std::string>>;

Frames read_frames(const fs::path& run)
{
    const fs::path file = run / "surface.pvd";
    std::error_code error;
    if (!fs::exists(file, error))
    {
        throw InputError(
            fmt::format("{}: holds no surface.pvd; expected a run folder made by corticle run", run.string()));
    }
    Frames frames = formats::read_pvd(file);
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

/// As many decimals as distinguish all times, at least three.
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
std::vector<std::pair<formats::Field, std::string>> scalar_fields(const formats::SurfaceFile& surface)
{
    std::vector<std::pair<formats::Field, std::string>> scalars;
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
        scalars.emplace_back(formats::Field{name, 1, values}, part);
    }
    return scalars;
}

/// A file to write, and what writes it.
using FileWriter = std::pair<std::string, std::function<void(const fs::path&)>>;

using Scalars = std::vector<std::pair<formats::Field, std::string>>;

/// What a run's surface is called where the user does not say.
std::string structure_of(const ExportRequest& request)
{
    switch (view::body_sides(request.run).part)
    {
    case imaging::Hemisphere::left:
        return "CortexLeft";
    case imaging::Hemisphere::right:
        return "CortexRight";
    case imaging::Hemisphere::both:
        break;
    }
    return "Cortex";
}

/// The whole surface as one part, or one part for each hemisphere.
std::vector<SurfacePart> parts_of(const ExportRequest& request, const TriangleMesh& surface)
{
    const bool is_brain = view::body_sides(request.run).is_brain; // else there is no left and right
    if (request.split || (request.structure.empty() && is_brain && has_separate_hemispheres(surface)))
    {
        return hemispheres(surface, request.split && !has_separate_hemispheres(surface));
    }
    SurfacePart whole{request.structure.empty() ? structure_of(request) : request.structure, {}, {}, surface.triangles};
    whole.kept.resize(surface.vertices.size());
    std::iota(whole.kept.begin(), whole.kept.end(), 0);
    return {whole};
}

/// Surfaces, their arrays, and the specification file that opens them all in Connectome Workbench.
void add_gifti(const ExportRequest& request, const std::string& stem, const formats::SurfaceFile& surface,
               const Scalars& scalars, std::vector<FileWriter>& files)
{
    std::string entries;
    const auto enter = [&](const SurfacePart& part, const char* type, const std::string& file)
    {
        entries += fmt::format("   <DataFile Structure=\"{}\" DataFileType=\"{}\" Selected=\"true\">\n      {}\n"
                               "   </DataFile>\n",
                               formats::escape_xml(part.structure), type, formats::escape_xml(file));
    };
    for (const SurfacePart& part : parts_of(request, surface.mesh))
    {
        const std::string name = part.letter.empty() ? stem : stem + "." + part.letter;
        files.emplace_back(name + ".surf.gii",
                           [&surface, part](const fs::path& file)
                           {
                               formats::write_surface_gifti(file, gather<Vec3>(surface.mesh.vertices, part.kept),
                                                            part.triangles, part.structure);
                           });
        enter(part, "SURFACE", files.back().first);
        for (const auto& [field, label] : scalars)
        {
            files.emplace_back(fmt::format("{}.{}.shape.gii", name, label),
                               [scalar = field, part](const fs::path& file)
                               {
                                   const std::vector<double> values = gather<double>(scalar.values, part.kept);
                                   const formats::Field kept{scalar.name, 1, values};
                                   formats::write_scalars_gifti(file, {&kept, 1}, part.structure);
                               });
            enter(part, "METRIC", files.back().first);
        }
    }
    files.emplace_back(stem + ".spec",
                       [entries](const fs::path& file)
                       {
                           formats::write_text_atomically(file, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                                                "<CaretSpecFile Version=\"1.0\">\n   <MetaData/>\n" +
                                                                    entries + "</CaretSpecFile>\n");
                       });
}

/// The files of a frame. They refer to the request and the surface.
std::vector<FileWriter> frame_writers(const ExportRequest& request, const std::string& stem,
                                      const formats::SurfaceFile& surface)
{
    const std::vector<Vec3>& points = surface.mesh.vertices;
    const std::vector<Triangle>& triangles = surface.mesh.triangles;
    const auto scalars = scalar_fields(surface);
    std::vector<FileWriter> files;
    if (request.format == ExportFormat::ply)
    {
        std::vector<formats::Field> fields;
        for (const auto& [field, part] : scalars)
        {
            fields.push_back({part, 1, field.values});
        }
        files.emplace_back(stem + ".ply", [&, fields](const fs::path& file)
                           { formats::write_surface_ply(file, points, triangles, fields); });
    }
    else if (request.format == ExportFormat::stl)
    {
        files.emplace_back(stem + ".stl",
                           [&](const fs::path& file) { formats::write_surface_stl(file, points, triangles); });
    }
    else if (request.format == ExportFormat::freesurfer)
    {
        files.emplace_back(stem + ".surf",
                           [&](const fs::path& file) { formats::write_surface_freesurfer(file, points, triangles); });
        for (const auto& [field, part] : scalars)
        {
            files.emplace_back(fmt::format("{}.{}.curv", stem, part),
                               [&triangles, values = field.values](const fs::path& file)
                               { formats::write_scalars_freesurfer(file, values, triangles.size()); });
        }
    }
    else
    {
        add_gifti(request, stem, surface, scalars, files);
    }
    return files;
}

/// Refuses to write over anything that was not asked for.
void require_new(const record::ResultFolder& folder, const ExportRequest& request, std::span<const std::string> files)
{
    folder.require_free(files);
    const auto earlier = std::ranges::find_if(files, [&](const std::string& file) { return folder.has_written(file); });
    if (earlier != files.end() && !request.overwrite)
    {
        throw InputError(fmt::format("{}: holds {} of an earlier export; expected another folder, or --overwrite to "
                                     "replace it",
                                     folder.name(), *earlier));
    }
}

} // namespace

std::vector<ExportedFrame> export_run(const ExportRequest& request)
{
    const Frames frames = read_frames(request.run);
    const auto chosen = chosen_frames(frames, request.times);
    const int decimals = decimals_for(frames);
    const auto stem = [&](std::size_t index) { return fmt::format("surface_t{:.{}f}", frames[index].first, decimals); };
    record::ResultFolder folder(request.out.empty() ? request.run / "export" : request.out, "export");
    std::vector<ExportedFrame> exported;
    std::vector<std::string> all;
    for (const auto& [index, asked] : chosen) // all names first: nothing is written where one is taken
    {
        const formats::SurfaceFile surface = formats::read_surface_vtp(request.run / frames[index].second);
        exported.push_back({frames[index].first, asked, {}});
        for (const auto& [name, write] : frame_writers(request, stem(index), surface))
        {
            exported.back().files.push_back(name);
            all.push_back(name);
        }
    }
    require_new(folder, request, all);
    folder.make();
    folder.claim(all);
    for (const auto& [index, asked] : chosen)
    {
        const formats::SurfaceFile surface = formats::read_surface_vtp(request.run / frames[index].second);
        for (const auto& [name, write] : frame_writers(request, stem(index), surface))
        {
            write(folder.path() / name);
        }
    }
    return exported;
}

} // namespace corticle::study
