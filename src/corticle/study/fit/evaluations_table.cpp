// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/evaluations_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace corticle::fit
{

namespace
{

std::string csv_field(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text)
    {
        quoted += c == '"' ? "\"\"" : c == '\n' || c == '\r' ? " " : std::string(1, c);
    }
    return quoted + "\"";
}

std::string header(const ParameterSpace& space, std::span<const Quantity> quantities, bool has_misfits)
{
    std::string text = "number,stage";
    for (const FreeParameter& one : space.parameters)
    {
        text += "," + one.key;
    }
    text += has_misfits ? ",status,misfit" : ",status";
    for (const Quantity& one : quantities)
    {
        text += "," + csv_field(one.name());
    }
    return text + ",folder,reason\n";
}

} // namespace

std::string evaluations_table(const ParameterSpace& space, std::span<const Quantity> quantities,
                              std::span<const Evaluation> evaluations, std::span<const double> misfits)
{
    std::string text = header(space, quantities, !misfits.empty());
    const auto number = [](double value) { return std::isfinite(value) ? fmt::format(",{}", value) : ","; };
    for (std::size_t i = 0; i < evaluations.size(); ++i)
    {
        const Evaluation& one = evaluations[i];
        text += fmt::format("{},{},{},{}", i + 1, one.stage, fmt::join(one.values, ","),
                            one.failure.empty() ? "completed" : "failed");
        text += misfits.empty() ? "" : number(misfits[i]);
        for (std::size_t q = 0; q < quantities.size(); ++q)
        {
            text += number(q < one.predicted.size() ? one.predicted[q] : NAN);
        }
        text += "," + one.folder + "," + (one.failure.empty() ? "" : csv_field(one.failure)) + "\n";
    }
    return text;
}

} // namespace corticle::fit
