// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/comparison.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/study/comparison/real_comparison.hpp"
#include "corticle/study/comparison/run_comparison.hpp"
#include "corticle/study/comparison/run_variation.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* report_file = "report.md";
constexpr const char* numbers_file = "comparison.json";
constexpr const char* maps_file = "variation.vtp";

bool is_folder(const std::string& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

/// A path as a part of a name, different where the paths are: "a-run" of a/run. The folder that runs go to by default
/// is left out.
std::string name_of(const std::string& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    const fs::path from_here = whole.lexically_relative(fs::current_path(error));
    const bool is_below = !from_here.empty() && *from_here.begin() != ".." && *from_here.begin() != ".";
    fs::path shown = is_below ? from_here : whole.relative_path();
    if (!is_folder(path))
    {
        shown.replace_extension();
    }
    std::string name;
    for (const fs::path& part : shown)
    {
        if (!part.empty() && !(name.empty() && part == "runs"))
        {
            name += name.empty() ? "" : "-";
            name += part.string();
        }
    }
    return name;
}

fs::path chosen_folder(const ComparisonRequest& request)
{
    if (!request.out.empty())
    {
        return request.out;
    }
    const std::string& other = request.others.front();
    const std::string second = request.others.size() > 1 ? is_folder(other) ? "others" : "real"
                               : is_folder(other)        ? name_of(other)
                                                         : name_of(other.substr(0, other.rfind('@')));
    return fmt::format("compare_{}_{}", name_of(request.run.string()), second);
}

void require_no_report(const record::ResultFolder& folder, const ComparisonRequest& request)
{
    if (record::is_run_folder(folder.path()))
    {
        throw InputError(fmt::format("{}: holds a run; expected another folder for the comparison", folder.name()));
    }
    if (folder.is_used() && !request.overwrite)
    {
        throw InputError(fmt::format(
            "{}: holds a report already; expected another folder, or --overwrite to replace it", folder.name()));
    }
    folder.require_free(std::array<std::string, 2>{report_file, numbers_file});
}

template <class Comparison>
ComparisonOutcome write(record::ResultFolder& folder, const ComparisonRequest& request, const Comparison& comparison)
{
    Pictures pictures;
    std::vector<std::string> files{report_file, numbers_file};
    if (view::can_render(pictures.reason))
    {
        pictures.files = comparison_pictures(comparison);
        files.insert(files.end(), pictures.files.begin(), pictures.files.end());
    }
    constexpr bool has_maps = std::is_same_v<Comparison, RunVariation>;
    if constexpr (has_maps)
    {
        files.emplace_back(maps_file);
    }
    folder.make();
    require_no_report(folder, request); // again: the comparison may have taken a while
    folder.require_free(files);
    folder.remove_written();
    folder.claim(files);
    if (!pictures.files.empty())
    {
        draw_comparison(folder.path(), comparison);
    }
    if constexpr (has_maps)
    {
        write_variation(folder.path() / maps_file, comparison);
    }
    ComparisonOutcome outcome{folder.path(), comparison_json(comparison, pictures), comparison_summary(comparison),
                              pictures};
    formats::write_text_atomically(folder.path() / numbers_file, outcome.json);
    formats::write_text_atomically(folder.path() / report_file, comparison_report(comparison, pictures));
    return outcome;
}

} // namespace

ComparisonOutcome compare(const ComparisonRequest& request)
{
    record::ResultFolder folder(chosen_folder(request), "comparison");
    require_no_report(folder, request);
    const auto run = std::find_if(request.others.begin(), request.others.end(), is_folder);
    if (run == request.others.end())
    {
        const RealComparison comparison = compare_with_real(request);
        ComparisonOutcome outcome = write(folder, request, comparison);
        outcome.warnings = comparison.warnings();
        return outcome;
    }
    const auto other = std::ranges::find_if_not(request.others, is_folder);
    if (other != request.others.end())
    {
        throw InputError(
            fmt::format("{}: not a folder, among run folders; expected other runs, or surfaces FILE@WEEK", *other));
    }
    if (request.others.size() > 1)
    {
        std::vector<fs::path> folders{request.run};
        folders.insert(folders.end(), request.others.begin(), request.others.end());
        ComparisonOutcome outcome = write(folder, request, compare_many_runs(folders, request.picture_times));
        outcome.has_page = false;
        return outcome;
    }
    return write(folder, request, compare_runs({request.run, fs::path(*run)}, request.picture_times));
}

} // namespace corticle::study
