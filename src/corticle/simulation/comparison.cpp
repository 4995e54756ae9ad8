// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/comparison.hpp"

#include "corticle/base/error.hpp"
#include "corticle/io/atomic_file.hpp"
#include "corticle/simulation/real_comparison.hpp"
#include "corticle/simulation/run_comparison.hpp"
#include "corticle/simulation/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle
{

namespace
{

namespace fs = std::filesystem;

bool is_folder(const std::string& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

/// The last part of a path, without what a file name ends in.
std::string short_name(const std::string& path)
{
    const fs::path whole = fs::absolute(fs::path(path) / ".").lexically_normal().parent_path();
    return is_folder(path) ? whole.filename().string() : whole.stem().string();
}

fs::path chosen_folder(const ComparisonRequest& request)
{
    if (!request.out.empty())
    {
        return request.out;
    }
    const std::string& other = request.others.front();
    const std::string second = request.others.size() > 1 ? "real"
                               : is_folder(other)        ? short_name(other)
                                                         : short_name(other.substr(0, other.rfind('@')));
    return fmt::format("compare_{}_{}", short_name(request.run.string()), second);
}

void require_own_folder(const fs::path& folder)
{
    require_writable_folder(folder);
    if (is_run_folder(folder))
    {
        throw InputError(
            fmt::format("--out {}: holds a run; expected another folder for the comparison", folder.string()));
    }
}

/// Pictures of an earlier comparison in the same folder: the new report may show others.
void remove_earlier_pictures(const fs::path& folder)
{
    std::vector<fs::path> files;
    if (fs::exists(folder / "comparison.json"))
    {
        for (const auto& item : fs::directory_iterator(folder))
        {
            const std::string name = item.path().filename().string();
            const bool is_ours = name == "measures.png" || name.starts_with("surface_J_") || name.starts_with("cut_J_");
            if (is_ours && item.path().extension() == ".png")
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

template <class Comparison>
ComparisonOutcome write(const fs::path& folder, const Comparison& comparison)
{
    create_folder(folder);
    remove_earlier_pictures(folder);
    const Pictures pictures = draw_comparison(folder, comparison);
    ComparisonOutcome outcome{folder, comparison_json(comparison, pictures), comparison_summary(comparison), pictures};
    write_text_atomically(folder / "comparison.json", outcome.json);
    write_text_atomically(folder / "report.md", comparison_report(comparison, pictures));
    return outcome;
}

} // namespace

ComparisonOutcome compare(const ComparisonRequest& request)
{
    const fs::path folder = chosen_folder(request);
    require_own_folder(folder);
    const auto run = std::find_if(request.others.begin(), request.others.end(), is_folder);
    if (run == request.others.end())
    {
        const RealComparison comparison = compare_with_real(request);
        ComparisonOutcome outcome = write(folder, comparison);
        outcome.warnings = comparison.warnings();
        return outcome;
    }
    if (request.others.size() > 1)
    {
        throw InputError(fmt::format("{}: a folder among {} arguments; expected one other run, or surfaces FILE@WEEK",
                                     *run, request.others.size()));
    }
    return write(folder, compare_runs({request.run, fs::path(*run)}, request.picture_times));
}

} // namespace corticle
