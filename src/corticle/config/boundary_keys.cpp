// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/boundary_keys.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace corticle::config
{

namespace
{

using Place = std::function<std::string(std::string_view)>;
using boundary::SupportKind;
using boundary::SupportOptions;

/// The keys of one support, for messages.
struct SupportKeys
{
    std::string table; ///< "support.2"
    const Place& place;

    std::string of(std::string_view name) const
    {
        const std::string key = fmt::format("{}.{}", table, name);
        return key + place(key);
    }
    bool is_given(std::string_view name) const { return !place(fmt::format("{}.{}", table, name)).empty(); }
};

void settle_week(std::string_view name, const std::optional<double>& week, const SupportKeys& keys,
                 const model::TimeOptions& time, double& t)
{
    if (!week)
    {
        return;
    }
    const std::string key = fmt::format("{}_week", name);
    if (time.clock == material::GestationalClock::none)
    {
        throw InputError(fmt::format("{} is given, but time.clock{} is \"none\": expected a clock, or {}.{}",
                                     keys.of(key), keys.place("time.clock"), keys.table, name));
    }
    if (keys.is_given(name))
    {
        throw InputError(fmt::format("{} and {} are both given: expected one", keys.of(name), keys.of(key)));
    }
    t = material::growth_time(time.clock, *week);
}

/// A support that is not moved has no use for what says how.
void refuse_motion(const SupportOptions& support, const SupportKeys& keys)
{
    const SupportOptions still;
    const std::array given{
        std::pair<std::string_view, bool>("displacement_mm", support.displacement_mm != still.displacement_mm),
        std::pair<std::string_view, bool>("start", support.start != still.start),
        std::pair<std::string_view, bool>("end", support.end != still.end),
        std::pair<std::string_view, bool>("start_week", support.start_week.has_value()),
        std::pair<std::string_view, bool>("end_week", support.end_week.has_value())};
    for (const auto& [name, is_given] : given)
    {
        if (is_given)
        {
            throw InputError(fmt::format("{} is given, but {} is \"{}\": expected kind = \"displacement\"",
                                         keys.of(name), keys.of("kind"),
                                         support.kind == SupportKind::fixed ? "fixed" : "roller"));
        }
    }
}

void check_axes(const SupportOptions& support, const SupportKeys& keys)
{
    if (support.kind == SupportKind::fixed && support.axes != boundary::Axes::none)
    {
        throw InputError(fmt::format("{} is given, but {} is \"fixed\", along all axes: expected kind = \"roller\"",
                                     keys.of("axes"), keys.of("kind")));
    }
    if (support.kind != SupportKind::fixed && support.axes == boundary::Axes::none &&
        support.plane == boundary::Face::none)
    {
        throw InputError(fmt::format("{} is missing: got neither a plane nor axes, expected the axes along which the "
                                     "support holds",
                                     keys.of("axes")));
    }
}

void check_region(const SupportOptions& support, const SupportKeys& keys)
{
    if (support.plane == boundary::Face::none && !keys.is_given("low_mm") && !keys.is_given("high_mm") &&
        support.low_mm == SupportOptions{}.low_mm && support.high_mm == SupportOptions{}.high_mm)
    {
        throw InputError(fmt::format("{} is missing: got neither a plane nor a box (low_mm, high_mm), expected which "
                                     "nodes are held",
                                     keys.of("plane")));
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        if (support.low_mm[axis] > support.high_mm[axis])
        {
            throw InputError(fmt::format("{} is out of range: got {:g} along {}, expected at most {} there, {:g}",
                                         keys.of("low_mm"), support.low_mm[axis], "xyz"[axis], keys.of("high_mm"),
                                         support.high_mm[axis]));
        }
    }
}

void check_motion(const SupportOptions& support, const SupportKeys& keys, const Options& options)
{
    if (!(support.start < support.end))
    {
        throw InputError(fmt::format("{} is out of range: got t = {:g}, expected more than that of {}, {:g}",
                                     keys.of("end"), support.end, keys.of("start"), support.start));
    }
    if (options.dynamics.integrator == dynamics::Integrator::rk4)
    {
        throw InputError(fmt::format("{} is \"displacement\", but solver.integrator{} is \"rk4\": expected "
                                     "\"symplectic_euler\"",
                                     keys.of("kind"), keys.place("solver.integrator")));
    }
    if (support.start < options.time.start)
    {
        throw InputError(fmt::format("{} is out of range: got t = {:g}, expected at least the start of the run, {:g}",
                                     keys.of("start"), support.start, options.time.start));
    }
}

} // namespace

void settle_supports(Options& options, const Place& place)
{
    for (std::size_t k = 0; k < options.supports.size(); ++k)
    {
        SupportOptions& support = options.supports[k];
        const SupportKeys keys{fmt::format("support.{}", k + 1), place};
        if (support.kind == SupportKind::none)
        {
            throw InputError(
                fmt::format("{} is missing: expected \"fixed\", \"roller\" or \"displacement\"", keys.of("kind")));
        }
        check_region(support, keys);
        check_axes(support, keys);
        if (support.kind != SupportKind::displacement)
        {
            refuse_motion(support, keys);
            continue;
        }
        settle_week("start", support.start_week, keys, options.time, support.start);
        settle_week("end", support.end_week, keys, options.time, support.end);
        check_motion(support, keys, options);
    }
}

} // namespace corticle::config
