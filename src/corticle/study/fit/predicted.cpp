// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/metrics/comparison.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/study/comparison/real_comparison.hpp"
#include "corticle/study/fit/quantity.hpp"
#include "corticle/study/sweep/sweep_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace corticle::fit
{

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double from_table(const formats::NumberTable& measures, const Quantity& quantity)
{
    const formats::NumberColumn* values = measures.find(quantity.measure);
    const formats::NumberColumn* places = measures.find(quantity.place == Quantity::Place::t ? "t" : "week");
    return values == nullptr || places == nullptr ? none
                                                  : metrics::interpolate(places->values, values->values, quantity.at);
}

bool is_pattern(const std::string& measure)
{
    return measure.starts_with("pattern_");
}

double pattern_value(const metrics::PatternScore& score, const std::string& measure)
{
    return measure == "pattern_depth"       ? score.depth
           : measure == "pattern_curvature" ? score.curvature
           : measure == "pattern_dice"      ? score.dice
           : measure == "pattern_pits_5mm"  ? score.pits_5mm
                                            : score.pits_10mm;
}

/// By the code of `corticle compare`.
double from_surface(const std::filesystem::path& run_folder, const Quantity& quantity,
                    const study::RealComparison& comparison)
{
    const study::RealSurface& real = comparison.reals.front();
    if (is_pattern(quantity.measure))
    {
        return real.pattern ? pattern_value(real.pattern->pattern.scores.front(), quantity.measure) : none;
    }
    const auto row = std::ranges::find(real.rows, quantity.measure, &metrics::SurfaceRow::key);
    if (row == real.rows.end())
    {
        throw InputError(fmt::format("{}: no measure {}", run_folder.string(), quantity.measure));
    }
    return comparison.run_value(static_cast<std::size_t>(row - real.rows.begin()), real);
}

study::RealComparison compared(const std::filesystem::path& run_folder, const Quantity& quantity, bool patterns)
{
    study::ComparisonRequest request;
    request.run = run_folder;
    request.real = quantity.reading;
    request.patterns = patterns;
    request.others = {
        fmt::format("{}@{}{}", quantity.file.string(), quantity.place == Quantity::Place::t ? "t=" : "", quantity.at)};
    return study::compare_with_real(request);
}

} // namespace

std::vector<double> predicted_by(const std::filesystem::path& run_folder, std::span<const Quantity> quantities)
{
    const record::RunContents run = record::read_run(run_folder);
    const sweep::RunState state = sweep::read_state(run_folder);
    const bool patterns = std::ranges::any_of(quantities, is_pattern, &Quantity::measure);
    std::vector<double> values;
    std::optional<study::RealComparison> comparison; // of the surface at hand: quantities of one stand together
    const Quantity* compared_for = nullptr;
    for (const Quantity& quantity : quantities)
    {
        if (!quantity.file.empty())
        {
            if (compared_for == nullptr || compared_for->file != quantity.file || compared_for->at != quantity.at)
            {
                comparison = compared(run_folder, quantity, patterns);
                compared_for = &quantity;
            }
            values.push_back(from_surface(run_folder, quantity, *comparison));
        }
        else if (quantity.place == Quantity::Place::end)
        {
            const auto found = state.numbers.find(quantity.measure);
            values.push_back(found == state.numbers.end() ? none : found->second);
        }
        else
        {
            values.push_back(from_table(run.measures, quantity));
        }
    }
    return values;
}

} // namespace corticle::fit
