// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/comparison/pattern_report.hpp"

#include "corticle/study/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace corticle::study
{

namespace
{

struct ScoreColumn
{
    const char* key;
    const char* title;
    double metrics::PatternScore::*member;
};

constexpr std::array columns{
    ScoreColumn{"depth_partial", "depth", &metrics::PatternScore::depth},
    ScoreColumn{"curvature_partial", "curvature", &metrics::PatternScore::curvature},
    ScoreColumn{"sulcal_dice", "sulcal area, Dice", &metrics::PatternScore::dice},
    ScoreColumn{"pits_within_5mm", "pits within 5 mm", &metrics::PatternScore::pits_5mm},
    ScoreColumn{"pits_within_10mm", "within 10 mm", &metrics::PatternScore::pits_10mm},
};

} // namespace

std::string pattern_section(const PlacedPattern& placed, const std::string& axis)
{
    const metrics::FoldPattern& pattern = placed.pattern;
    std::string text = fmt::format(
        "Where the folds are: the output at {} {} is brought onto the real surface by volume, centroid and iterated "
        "closest points (scale {:.4f}, {:.3g} mm left between them). Depth below the hull correlates by {:.3f}, but "
        "that "
        "of the first body, merely scaled, by {:.3f}: most of it is the shape of the whole brain. In the table depth "
        "and "
        "curvature are what the first body's do not explain; sulcal area is where the surface is concave; pits are "
        "shares of the real ones. The rows below the run are controls.\n\n",
        axis, table_number(placed.place), pattern.alignment.scale, pattern.residual_mm, pattern.plain_depth,
        pattern.trivial_depth);
    std::vector<std::string> header{"pattern"};
    std::ranges::transform(columns, std::back_inserter(header), [](const ScoreColumn& c) { return c.title; });
    std::vector<std::vector<std::string>> rows;
    for (const metrics::PatternScore& score : pattern.scores)
    {
        rows.push_back({score.name});
        for (const ScoreColumn& column : columns)
        {
            rows.back().push_back(fmt::format("{:.3f}", score.*column.member));
        }
    }
    return text + markdown_table(header, rows);
}

nlohmann::ordered_json pattern_json(const PlacedPattern& placed, const std::string& axis)
{
    const metrics::FoldPattern& pattern = placed.pattern;
    const metrics::Similarity& to = pattern.alignment;
    nlohmann::ordered_json json;
    json[axis] = placed.place;
    json["alignment"] = {{"scale", to.scale},
                         {"rotation_columns",
                          {{to.rotation.column[0].x, to.rotation.column[0].y, to.rotation.column[0].z},
                           {to.rotation.column[1].x, to.rotation.column[1].y, to.rotation.column[1].z},
                           {to.rotation.column[2].x, to.rotation.column[2].y, to.rotation.column[2].z}}},
                         {"shift_mm", {to.shift.x, to.shift.y, to.shift.z}},
                         {"residual_mm", pattern.residual_mm}};
    json["depth_plain"] = pattern.plain_depth;
    json["depth_plain_first_body"] = pattern.trivial_depth;
    for (const metrics::PatternScore& score : pattern.scores)
    {
        for (const ScoreColumn& column : columns)
        {
            json["scores"][score.name][column.key] = score.*column.member;
        }
    }
    return json;
}

std::string pattern_lines(const PlacedPattern& placed)
{
    std::string text = "  pattern             of the run  best of controls\n";
    const std::vector<metrics::PatternScore>& scores = placed.pattern.scores;
    for (const ScoreColumn& column : columns)
    {
        double best = 0.0;
        for (std::size_t k = 1; k < scores.size(); ++k)
        {
            best = std::max(best, scores[k].*column.member);
        }
        text += fmt::format("  {:<20}{:>10.3f}{:>18.3f}\n", column.key, scores.front().*column.member, best);
    }
    return text;
}

} // namespace corticle::study
