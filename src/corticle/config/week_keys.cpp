// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/week_keys.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;

/// The cortex can thin only where it is known beforehand how the reference state grows.
void check_thinning(const material::SizeOptions& size, const Place& place)
{
    if (size.thin_cortex &&
        (size.law == material::LengthLaw::none || size.applies_to != material::SizedState::reference))
    {
        throw InputError(fmt::format("size.thin_cortex{} is true: expected a size.law{} with size.applies_to{} = "
                                     "\"reference\"",
                                     place("size.thin_cortex"), place("size.law"), place("size.applies_to")));
    }
}

/// Without a clock no key may speak of weeks.
void refuse_weeks(const Options& options, const Place& place)
{
    const auto refuse = [&](std::string_view key, bool is_given)
    {
        if (is_given)
        {
            throw InputError(fmt::format("{}{} is given, but time.clock{} is \"none\": expected a clock, \"wang\" or "
                                         "\"cubic\"",
                                         key, place(key), place("time.clock")));
        }
    };
    refuse("time.start_week", options.time.start_week.has_value());
    refuse("time.end_week", options.time.end_week.has_value());
    refuse("output.weeks", !options.output.weeks.empty());
    refuse("size.law", options.size.law != material::LengthLaw::none);
    if (options.time.start >= options.time.end)
    {
        throw InputError(fmt::format("time.start{} is out of range: got {:g}, expected less than time.end = {:g}",
                                     place("time.start"), options.time.start, options.time.end));
    }
}

/// With a clock weeks replace t.
void refuse_times(const Options& options, const Place& place)
{
    const auto refuse = [&](std::string_view key, std::string_view instead)
    {
        if (!place(key).empty())
        {
            throw InputError(fmt::format("{}{} is given beside time.clock{}: expected {}", key, place(key),
                                         place("time.clock"), instead));
        }
    };
    refuse("time.start", "time.start_week");
    refuse("time.end", "time.end_week");
    if (!options.output.weeks.empty() && !options.output.times.empty())
    {
        throw InputError(fmt::format("output.weeks{} and output.times{} are both given: expected one",
                                     place("output.weeks"), place("output.times")));
    }
}

double week_in_range(const Options& options, std::string_view key, const std::optional<double>& week,
                     const Place& place)
{
    const auto [first, last] = material::week_range(options.time.clock);
    const auto expected = fmt::format("{:g} to {:g} weeks, as time.clock{} is \"{}\"", first, last, place("time.clock"),
                                      options.time.clock == material::GestationalClock::wang ? "wang" : "cubic");
    if (!week)
    {
        throw InputError(fmt::format("{} is missing: got none, expected {}", key, expected));
    }
    if (!(*week >= first && *week <= last))
    {
        throw InputError(fmt::format("{}{} is out of range: got {:g}, expected {}", key, place(key), *week, expected));
    }
    return *week;
}

} // namespace

void settle_weeks(Options& options, const Place& place)
{
    model::TimeOptions& time = options.time;
    check_thinning(options.size, place);
    if (time.clock == material::GestationalClock::none)
    {
        refuse_weeks(options, place);
        return;
    }
    refuse_times(options, place);
    const double start = week_in_range(options, "time.start_week", time.start_week, place);
    const double end = week_in_range(options, "time.end_week", time.end_week, place);
    if (!(start < end))
    {
        throw InputError(fmt::format("time.end_week{} is out of range: got {:g}, expected more than time.start_week = "
                                     "{:g}",
                                     place("time.end_week"), end, start));
    }
    for (const double week : options.output.weeks)
    {
        week_in_range(options, "output.weeks", week, place);
    }
    // The rounded coefficients of the cubic clock put 22 weeks at t = -2e-5.
    time.start = std::max(0.0, material::growth_time(time.clock, start));
    time.end = material::growth_time(time.clock, end);
}

} // namespace corticle::config
