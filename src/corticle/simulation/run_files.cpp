// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/run_files.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/io/atomic_file.hpp"
#include "corticle/io/vtk_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace corticle
{

namespace
{

namespace fs = std::filesystem;

/// What a process that was killed left of a file it was writing aside.
bool is_leftover(const fs::path& file)
{
    return file.filename().string().starts_with('.') && file.extension() == ".tmp";
}

bool belongs_to_a_run(const fs::path& file)
{
    const std::string name = file.filename().string();
    const auto is = [&](std::string_view start, std::string_view extension)
    { return name.starts_with(start) && file.extension() == extension; };
    return name == "case.toml" || name == "summary.json" || name == "measures.csv" || name == "checkpoint.h5" ||
           name == "run.log" || name == "surface.pvd" || name == "particles.pvd" || is("surface_", ".vtp") ||
           is("particles_", ".vtu") || is("surface_", ".png") || is("cut_", ".png") || name == "measures.png";
}

template <class Chosen>
void remove_files(const fs::path& folder, Chosen&& chosen)
{
    for (const fs::path& place : {folder, folder / "pictures"})
    {
        std::vector<fs::path> files;
        if (fs::is_directory(place))
        {
            for (const auto& item : fs::directory_iterator(place))
            {
                if (item.is_regular_file() && chosen(item.path()))
                {
                    files.push_back(item.path());
                }
            }
        }
        for (const fs::path& file : files)
        {
            fs::remove(file);
        }
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

void require_writable_folder(const fs::path& out)
{
    std::error_code error;
    fs::path existing = fs::absolute(out).lexically_normal();
    while (!fs::exists(existing, error) && existing.has_relative_path())
    {
        existing = existing.parent_path();
    }
    if (!fs::is_directory(existing, error) || access(existing.c_str(), W_OK | X_OK) != 0)
    {
        throw InputError(fmt::format("--out {}: {} is not a folder that can be written; expected one", out.string(),
                                     existing.string()));
    }
}

void require_usable_folder(const RunRequest& request)
{
    require_writable_folder(request.out);
    std::error_code error;
    if (fs::exists(request.out / "case.toml", error) && !request.resume && !request.overwrite)
    {
        throw InputError(fmt::format("--out {}: holds a run already; expected another folder, --resume to go on with "
                                     "it or --overwrite to replace it",
                                     request.out.string()));
    }
}

std::optional<Checkpoint> find_checkpoint(const RunRequest& request, const std::string& case_text)
{
    if (!request.resume)
    {
        return std::nullopt;
    }
    const auto require_same_case = [&](const std::string& earlier, std::string_view where)
    {
        const std::vector<std::string> differences = differing_keys(earlier, case_text);
        if (!differences.empty())
        {
            throw InputError(fmt::format("--resume {}: the case differs from that of {} in {}; expected the same case",
                                         request.out.string(), where, fmt::join(differences, ", ")));
        }
    };
    const fs::path file = request.out / "checkpoint.h5";
    const fs::path case_file = request.out / "case.toml";
    if (fs::exists(file))
    {
        Checkpoint checkpoint = read_checkpoint(file);
        require_same_case(checkpoint.case_text, "the checkpoint");
        return checkpoint;
    }
    if (fs::exists(case_file)) // stopped before its first checkpoint: starts again, but only if it is the same run
    {
        require_same_case(to_toml(read_case(case_file, {})), "its case.toml");
    }
    return std::nullopt;
}

void create_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
    {
        throw InputError(fmt::format("--out {}: cannot be made: {}; expected a folder that can be written",
                                     folder.string(), error.message()));
    }
}

void remove_leftovers(const fs::path& folder)
{
    remove_files(folder, is_leftover);
}

void remove_run(const fs::path& folder)
{
    remove_files(folder, [](const fs::path& file) { return belongs_to_a_run(file) || is_leftover(file); });
}

std::vector<double> output_times(const Options& options)
{
    const double start = options.time.start;
    const double end = options.time.end;
    std::vector<double> chosen = options.output.times;
    for (const double week : options.output.weeks)
    {
        chosen.push_back(growth_time(options.time.clock, week));
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
                     [&](double t) { return t > start + same_output_time && t < end; });
    }
    times.push_back(end);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < same_output_time; }),
                times.end());
    times.back() = end;
    return times;
}

std::vector<bool> picture_flags(const Options& options, std::span<const double> times)
{
    std::vector<bool> flags(times.size(), false);
    if (options.output.pictures != "on")
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

void write_tables(const fs::path& folder, std::span<const Measures> rows)
{
    std::vector<std::pair<double, std::string>> surfaces;
    std::vector<std::pair<double, std::string>> particles;
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        surfaces.emplace_back(rows[k].t, "surface_" + frame_name(k) + ".vtp");
        particles.emplace_back(rows[k].t, "particles_" + frame_name(k) + ".vtu");
    }
    write_pvd(folder / "surface.pvd", surfaces);
    write_pvd(folder / "particles.pvd", particles);
    write_text_atomically(folder / "measures.csv", measures_csv(rows));
}

} // namespace corticle
