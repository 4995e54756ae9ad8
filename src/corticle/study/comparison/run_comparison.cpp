// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/run_comparison.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::study
{

namespace
{

namespace fs = std::filesystem;

constexpr double same_time = 1e-9;
constexpr double near_time = 0.01; // share of the common time by which frames that are compared may lie apart

const std::vector<double>& times_of(const record::RunContents& run)
{
    return run.measures.find("t")->values;
}

/// First and last time that both runs cover.
struct Interval
{
    double begin;
    double end;
};

Interval common_interval(const std::array<record::RunContents, 2>& runs)
{
    const std::vector<double>& a = times_of(runs[0]);
    const std::vector<double>& b = times_of(runs[1]);
    const Interval common{std::max(a.front(), b.front()), std::min(a.back(), b.back())};
    const bool is_moment = a.size() == 1 || b.size() == 1;
    if (common.end < common.begin || (common.end == common.begin && !is_moment))
    {
        throw InputError(fmt::format("no common times: {} covers t = {:.6g} to {:.6g} and {} covers {:.6g} to {:.6g}",
                                     runs[0].folder.string(), a.front(), a.back(), runs[1].folder.string(), b.front(),
                                     b.back()));
    }
    return common;
}

std::vector<double> common_times(const std::array<record::RunContents, 2>& runs, const Interval& common)
{
    std::vector<double> times;
    for (const record::RunContents& run : runs)
    {
        std::copy_if(times_of(run).begin(), times_of(run).end(), std::back_inserter(times),
                     [&](double t) { return t >= common.begin && t <= common.end; });
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < same_time; }),
                times.end());
    return times;
}

/// As the weeks of a run without a clock.
bool holds_no_numbers(const formats::NumberColumn& column)
{
    return std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
}

double largest_magnitude(const MeasurePair& pair)
{
    double largest = 0.0;
    for (const std::vector<double>& values : pair.values)
    {
        for (const double value : values)
        {
            largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
        }
    }
    return largest;
}

std::vector<MeasurePair> compare_measures(const std::array<record::RunContents, 2>& runs, std::span<const double> times)
{
    std::vector<MeasurePair> pairs;
    for (const formats::NumberColumn& a : runs[0].measures.columns)
    {
        const auto& others = runs[1].measures.columns;
        const auto b = std::find_if(others.begin(), others.end(),
                                    [&](const formats::NumberColumn& other)
                                    { return measure_key(other) == measure_key(a) && other.unit == a.unit; });
        if (a.key == "t" || b == others.end() || holds_no_numbers(a) || holds_no_numbers(*b))
        {
            continue;
        }
        MeasurePair pair{measure_key(a), a.unit, {}, {}};
        for (const double t : times)
        {
            pair.values[0].push_back(metrics::interpolate(times_of(runs[0]), a.values, t));
            pair.values[1].push_back(metrics::interpolate(times_of(runs[1]), b->values, t));
        }
        const double scale = largest_magnitude(pair);
        for (std::size_t k = 0; k < times.size(); ++k)
        {
            pair.percent.push_back(metrics::telling_percent(pair.key, pair.values[0][k], pair.values[1][k], scale));
        }
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

std::size_t nearest_frame(std::span<const record::FrameFiles> frames, double t)
{
    return static_cast<std::size_t>(std::min_element(frames.begin(), frames.end(),
                                                     [&](const record::FrameFiles& a, const record::FrameFiles& b)
                                                     { return std::abs(a.t - t) < std::abs(b.t - t); }) -
                                    frames.begin());
}

/// Frames of both runs that lie nearest to each other, and near enough.
std::vector<FramePair> common_frames(const std::array<record::RunContents, 2>& runs, const Interval& common)
{
    std::vector<FramePair> pairs;
    const double tolerance = std::max(same_time, near_time * (common.end - common.begin));
    for (std::size_t i = 0; i < runs[0].frames.size(); ++i)
    {
        const record::FrameFiles& a = runs[0].frames[i];
        const record::FrameFiles& b = runs[1].frames[nearest_frame(runs[1].frames, a.t)];
        if (nearest_frame(runs[0].frames, b.t) == i && std::abs(a.t - b.t) <= tolerance)
        {
            pairs.push_back({{a, b}, {}, {}});
        }
    }
    if (pairs.empty())
    {
        throw InputError(fmt::format("no common times: no output time of {} lies near one of {}; expected output times "
                                     "at the same t",
                                     runs[0].folder.string(), runs[1].folder.string()));
    }
    return pairs;
}

metrics::FieldDifference compare_J(const std::array<record::Frame, 2>& frames)
{
    const std::array J{volume_ratios(frames[0]), volume_ratios(frames[1])};
    return metrics::mean_difference({frames[0].origins, J[0], frames[0].spacing},
                                    {frames[1].origins, J[1], frames[1].spacing});
}

void compare_frames(FramePair& pair, std::array<std::size_t, 2>& particles)
{
    const std::array frames{record::read_frame(pair.files[0]), record::read_frame(pair.files[1])};
    particles = {frames[0].F->size(), frames[1].F->size()};
    pair.J = compare_J(frames);
    pair.surface =
        metrics::surface_distance({frames[0].surface, frames[0].triangles}, {frames[1].surface, frames[1].triangles});
}

std::vector<std::size_t> pictured_frames(std::span<const FramePair> frames, std::span<const double> asked,
                                         const Interval& common)
{
    std::vector<double> times(asked.begin(), asked.end());
    if (times.empty())
    {
        times = {0.5 * (common.begin + common.end), common.end};
    }
    std::vector<std::size_t> chosen;
    for (const double t : times)
    {
        if (!(t >= common.begin - same_time && t <= common.end + same_time))
        {
            throw InputError(fmt::format("--time {}: expected a time that both runs cover, {:.6g} to {:.6g}", t,
                                         common.begin, common.end));
        }
        const auto nearest = std::min_element(frames.begin(), frames.end(),
                                              [&](const FramePair& a, const FramePair& b)
                                              { return std::abs(a.files[0].t - t) < std::abs(b.files[0].t - t); });
        chosen.push_back(static_cast<std::size_t>(nearest - frames.begin()));
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// The names of the folders; where these agree, the paths as given, and where these agree too, numbered.
std::array<std::string, 2> names_of(const std::array<fs::path, 2>& folders)
{
    const auto name = [](const fs::path& folder)
    { return fs::absolute(folder / ".").lexically_normal().parent_path().filename().string(); };
    std::array<std::string, 2> names{name(folders[0]), name(folders[1])};
    if (names[0] == names[1])
    {
        names = {folders[0].string(), folders[1].string()};
    }
    if (names[0] == names[1])
    {
        names = {names[0] + " (1)", names[1] + " (2)"};
    }
    return names;
}

} // namespace

std::string measure_key(const formats::NumberColumn& column)
{
    const bool is_length_or_so = column.unit == "mm" || column.unit == "mm2" || column.unit == "mm3";
    return is_length_or_so && !column.key.ends_with("_" + column.unit) ? column.key + "_" + column.unit : column.key;
}

std::vector<double> volume_ratios(const record::Frame& frame)
{
    std::vector<double> J;
    J.reserve(frame.F->size());
    for (const Mat3& F : *frame.F)
    {
        J.push_back(determinant(F));
    }
    return J;
}

RunComparison compare_runs(const std::array<fs::path, 2>& folders, std::span<const double> picture_times)
{
    RunComparison result;
    result.runs = {record::read_run(folders[0]), record::read_run(folders[1])};
    result.names = names_of(folders);
    const Interval common = common_interval(result.runs);
    result.times = common_times(result.runs, common);
    result.measures = compare_measures(result.runs, result.times);
    result.frames = common_frames(result.runs, common);
    result.pictured = pictured_frames(result.frames, picture_times, common);
    for (FramePair& pair : result.frames)
    {
        compare_frames(pair, result.particles);
    }
    return result;
}

JComparison compare_last_J(const std::array<fs::path, 2>& folders, double latest)
{
    const std::array runs{record::read_run(folders[0]), record::read_run(folders[1])};
    std::vector<FramePair> frames = common_frames(runs, common_interval(runs));
    std::erase_if(frames, [&](const FramePair& pair) { return pair.files[0].t > latest + same_time; });
    if (frames.empty())
    {
        throw InputError(fmt::format("no common output time of {} and {} up to t = {}", folders[0].string(),
                                     folders[1].string(), latest));
    }
    const auto& files = frames.back().files;
    return {{files[0].t, files[1].t}, compare_J({record::read_frame(files[0]), record::read_frame(files[1])})};
}

} // namespace corticle::study
