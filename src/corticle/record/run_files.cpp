// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/run_files.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/record/support_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::record
{

namespace
{

namespace fs = std::filesystem;

constexpr double same_time = 1e-9;

/// All files that a run may write.
std::vector<std::string> planned_files(const config::Options& options)
{
    std::vector<std::string> files = run_files();
    if (!options.supports.empty())
    {
        files.emplace_back(support_table_name);
    }
    if (options.output.pictures == config::PictureRule::on)
    {
        files.emplace_back(measures_picture);
    }
    const std::vector<double> times = output_times(options);
    const std::vector<bool> with_pictures = picture_flags(options, times);
    for (std::size_t k = 0; k < times.size(); ++k)
    {
        std::ranges::copy(frame_files(frame_name(k)), std::back_inserter(files));
        if (with_pictures[k])
        {
            std::ranges::copy(frame_pictures(frame_name(k)), std::back_inserter(files));
        }
    }
    return files;
}

void require_reachable_end(const RunRequest& request, const Checkpoint& checkpoint)
{
    const double reached = reached_time(checkpoint, (request.out / "checkpoint.h5").string());
    if (request.options.time.end < reached - same_time)
    {
        throw InputError(fmt::format("--resume {}: the run has reached t = {:.6g}; got time.end = {:.6g}, expected at "
                                     "least that",
                                     request.out.string(), reached, request.options.time.end));
    }
}

std::size_t nearest(std::span<const double> times, double t)
{
    return static_cast<std::size_t>(std::min_element(times.begin(), times.end(),
                                                     [&](double a, double b)
                                                     { return std::abs(a - t) < std::abs(b - t); }) -
                                    times.begin());
}

} // namespace

std::string surface_picture(std::string_view kind, const std::string& name)
{
    return fmt::format("pictures/surface_{}_{}.png", kind, name);
}

std::string cut_picture(const std::string& name)
{
    return fmt::format("pictures/cut_{}.png", name);
}

std::vector<std::string> frame_pictures(const std::string& name)
{
    return {surface_picture("J", name), surface_picture("growth", name), surface_picture("sulcal_depth", name),
            surface_picture("mean_curvature", name), cut_picture(name)};
}

std::vector<std::string> run_files()
{
    return {"case.toml",   "run.log",       "checkpoint.h5", "measures.csv",
            "surface.pvd", "particles.pvd", "summary.json",  "report.html"};
}

std::vector<std::string> frame_files(const std::string& name)
{
    return {"surface_" + name + ".vtp", "particles_" + name + ".vtu"};
}

void require_usable_folder(const ResultFolder& folder, const RunRequest& request)
{
    if (folder.is_used() && !request.resume && !request.overwrite)
    {
        throw InputError(fmt::format("{}: holds a run already; expected another folder, --resume to go on with it or "
                                     "--overwrite to replace it",
                                     folder.name()));
    }
    folder.require_free(planned_files(request.options));
}

std::optional<Checkpoint> find_checkpoint(const RunRequest& request, const std::string& case_text)
{
    if (!request.resume)
    {
        return std::nullopt;
    }
    const auto require_same_case = [&](const std::string& earlier, std::string_view where)
    {
        const std::vector<std::string> differences = config::differing_keys(earlier, case_text);
        if (!differences.empty())
        {
            throw InputError(fmt::format("--resume {}: the case differs from that of {} in {}; expected the same case",
                                         request.out.string(), where, fmt::join(differences, ", ")));
        }
    };
    const fs::path file = request.out / "checkpoint.h5";
    const fs::path case_file = request.out / "case.toml";
    std::error_code error;
    if (fs::exists(file, error))
    {
        Checkpoint checkpoint = read_checkpoint(file);
        require_same_case(checkpoint.case_text, "the checkpoint");
        require_reachable_end(request, checkpoint);
        return checkpoint;
    }
    if (fs::exists(case_file, error))
    {
        // Stopped before its first checkpoint: starts again, but only if it is the same run.
        require_same_case(config::to_toml(config::read_case(case_file, {})), "its case.toml");
    }
    return std::nullopt;
}

std::vector<double> output_times(const config::Options& options)
{
    const double start = options.time.start;
    const double end = options.time.end;
    std::vector<double> chosen = options.output.times;
    for (const double week : options.output.weeks)
    {
        chosen.push_back(material::growth_time(options.time.clock, week));
    }
    std::vector<double> times{start};
    if (chosen.empty())
    {
        for (std::int64_t k = 1; k <= options.output.count; ++k)
        {
            times.push_back(start + (end - start) * static_cast<double>(k) / static_cast<double>(options.output.count));
        }
    }
    else
    {
        std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(times),
                     [&](double t) { return t > start + model::same_output_time && t < end; });
    }
    times.push_back(end);
    std::sort(times.begin(), times.end());
    times.erase(
        std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < model::same_output_time; }),
        times.end());
    times.back() = end;
    return times;
}

std::vector<bool> picture_flags(const config::Options& options, std::span<const double> times)
{
    std::vector<bool> flags(times.size(), false);
    if (options.output.pictures != config::PictureRule::on)
    {
        return flags;
    }
    for (const double t : options.output.picture_times)
    {
        flags[nearest(times, t)] = true;
    }
    flags.back() = flags.back() || options.output.picture_times.empty();
    return flags;
}

std::string frame_name(std::size_t row)
{
    return fmt::format("{:04}", row);
}

void write_tables(const fs::path& folder, std::span<const metrics::Measures> rows)
{
    std::vector<std::pair<double, std::string>> surfaces;
    std::vector<std::pair<double, std::string>> particles;
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        surfaces.emplace_back(rows[k].t, "surface_" + frame_name(k) + ".vtp");
        particles.emplace_back(rows[k].t, "particles_" + frame_name(k) + ".vtu");
    }
    formats::write_pvd(folder / "surface.pvd", surfaces);
    formats::write_pvd(folder / "particles.pvd", particles);
    formats::write_text_atomically(folder / "measures.csv", metrics::measures_csv(rows));
}

} // namespace corticle::record
