// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_progress.hpp"

#include "corticle/base/terminal.hpp"
#include "corticle/study/sweep/sweep_jobs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace corticle::sweep
{

namespace
{

constexpr double redraw_s = 0.5;
constexpr int bar_width = 24;

/// The growth time of the last row of measures.csv; `begin` before the first.
double last_time(const std::filesystem::path& folder, double begin)
{
    constexpr std::streamoff longest_row = 4096;
    std::ifstream stream(folder / "measures.csv", std::ios::binary | std::ios::ate);
    const std::streamoff size = stream.is_open() ? static_cast<std::streamoff>(stream.tellg()) : 0;
    std::string text(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, longest_row)), '\0');
    stream.seekg(-static_cast<std::streamoff>(text.size()), std::ios::end);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.erase(text.find_last_not_of('\n') + 1);
    const std::size_t row = text.rfind('\n') + 1;
    double t = begin;
    std::from_chars(text.data() + row, text.data() + text.size(), t); // no number in the header: t stays
    return t;
}

std::string clock_text(double seconds)
{
    const auto whole = static_cast<std::int64_t>(std::min(std::ceil(seconds), 3.6e8));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

} // namespace

SweepProgress::SweepProgress(std::span<const SweepJob> jobs, std::size_t done, bool quiet)
    : jobs_(jobs), done_(done), total_(done + jobs.size()), quiet_(quiet), shown_(!quiet && isatty(STDERR_FILENO) == 1),
      start_(Clock::now()), drawn_at_(start_)
{
    for (const SweepJob& job : jobs)
    {
        cost_ += job.cost;
    }
}

void SweepProgress::finish(std::size_t job, const RunState& state)
{
    if (state.is_finished())
    {
        ++done_;
        failed_ += state.status == "failed" ? 1 : 0;
    }
    done_cost_ += jobs_[job].cost;
    if (quiet_)
    {
        return;
    }
    if (shown_)
    {
        show(stderr, "\r\033[K");
    }
    const auto wall = state.numbers.find("wall_s");
    show(stdout, fmt::format("{} of {}: {} {}{}{}\n", done_, total_, jobs_[job].folder.filename().string(),
                             state.status, wall == state.numbers.end() ? "" : fmt::format(", {:.1f} s", wall->second),
                             state.reason.empty() ? "" : ": " + state.reason));
    for (const std::string& warning : state.warnings)
    {
        show(stderr, fmt::format("corticle: warning: {}: {}\n", jobs_[job].folder.filename().string(), warning));
    }
}

void SweepProgress::update(std::span<const std::size_t> running)
{
    const auto seconds = [](Clock::time_point from)
    { return std::chrono::duration<double>(Clock::now() - from).count(); };
    if (!shown_ || seconds(drawn_at_) < redraw_s)
    {
        return;
    }
    double share = done_cost_;
    for (const std::size_t job : running)
    {
        const SweepJob& one = jobs_[job];
        share +=
            one.cost * (last_time(one.folder, one.t_begin) - one.t_begin) / std::max(one.t_end - one.t_begin, 1e-9);
    }
    share = std::clamp(share / cost_, 0.0, 1.0);
    const int width = static_cast<int>(bar_width * share);
    const std::string left = share > 0.0 ? clock_text(seconds(start_) * (1.0 - share) / share) + " left" : "";
    show(stderr, fmt::format("\r[{:=<{}}{: <{}}] {} of {} runs done, {} running, {} failed  {}\033[K", "", width, "",
                             bar_width - width, done_, total_, running.size(), failed_, left));
    drawn_at_ = Clock::now();
}

} // namespace corticle::sweep
