// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/version.hpp"
#include "corticle/study/comparison/run_variation.hpp"
#include "corticle/study/markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace corticle::study
{

namespace
{

using Json = nlohmann::ordered_json;

struct AgreementRow
{
    const char* key;
    const char* meaning;
    metrics::PatternAgreement metrics::PatternVariation::*agreement;
};

constexpr std::array agreements{
    AgreementRow{"depth_correlation", "depth below the hull, what the first body does not explain",
                 &metrics::PatternVariation::depth},
    AgreementRow{"curvature_correlation", "mean curvature, what the first body does not explain",
                 &metrics::PatternVariation::curvature},
    AgreementRow{"sulcal_dice", "sulcal area, Dice", &metrics::PatternVariation::dice},
};

std::string when(const RunVariation& variation)
{
    return std::isnan(variation.week) ? fmt::format("t = {}", table_number(variation.t))
                                      : fmt::format("week {}", table_number(variation.week));
}

std::string agreement_table(const RunVariation& variation)
{
    std::vector<std::vector<std::string>> rows;
    for (const AgreementRow& row : agreements)
    {
        const metrics::PatternAgreement& one = variation.pattern.*row.agreement;
        rows.push_back({row.meaning, table_number(one.mean), table_number(one.lowest), table_number(one.highest)});
    }
    return markdown_table({"between two runs", "mean", "lowest", "highest"}, rows);
}

std::string measure_table(const RunVariation& variation)
{
    std::vector<std::vector<std::string>> rows;
    for (const MeasureSpread& one : variation.measures)
    {
        rows.push_back({fmt::format("`{}`", one.key), one.unit, table_number(one.mean), table_number(one.sd),
                        table_number(one.lowest), table_number(one.highest)});
    }
    return markdown_table({"measure", "unit", "mean", "standard deviation", "lowest", "highest"}, rows);
}

} // namespace

std::string comparison_json(const RunVariation& variation, const Pictures& pictures)
{
    Json json;
    json["kind"] = "variation";
    for (const record::RunContents& run : variation.runs)
    {
        json["runs"].push_back(run.folder.string());
    }
    json["t"] = variation.t;
    json["week"] = variation.week; // null where there is none
    for (const AgreementRow& row : agreements)
    {
        const metrics::PatternAgreement& one = variation.pattern.*row.agreement;
        json["pattern"][row.key] = {{"mean", one.mean}, {"lowest", one.lowest}, {"highest", one.highest}};
    }
    for (const MeasureSpread& one : variation.measures)
    {
        json["measures"][one.key] = {
            {"unit", one.unit}, {"mean", one.mean}, {"sd", one.sd}, {"lowest", one.lowest}, {"highest", one.highest}};
    }
    json["pictures"] = pictures.files;
    json["version"] = program_version();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparison_report(const RunVariation& variation, const Pictures& pictures)
{
    std::string text = fmt::format("# {} runs of one body at {}\n\n", variation.runs.size(), when(variation));
    for (const record::RunContents& run : variation.runs)
    {
        text += fmt::format("- {}\n", markdown_cell(run.folder.string()));
    }
    text +=
        "\n## The pattern of folds\n\nEach run beside each other one, vertex by vertex. The mean correlation is the "
        "share of the pattern's variance that all runs have in common: what geometry and growth decide, and not "
        "the imperfection that differs. 1: the same folds in every run; 0: folds anywhere.\n\n" +
        agreement_table(variation) +
        "`variation.vtp` holds the surface of the first run with `sulcal_share` (of the runs, how many are concave "
        "there), `depth_mean` and `depth_sd` [mm], `curvature_mean` [1/mm].\n";
    for (const std::string& file : pictures.files)
    {
        text += fmt::format("\n![{}]({})\n", file, file);
    }
    if (pictures.files.empty())
    {
        text += fmt::format("\nNo pictures were drawn: {}\n", pictures.reason);
    }
    return text + "\n## Measures\n\n" + measure_table(variation);
}

std::string comparison_summary(const RunVariation& variation)
{
    std::string text = fmt::format("{} runs of one body at {}\n", variation.runs.size(), when(variation));
    for (const AgreementRow& row : agreements)
    {
        const metrics::PatternAgreement& one = variation.pattern.*row.agreement;
        text += fmt::format("{:<24}mean {}, {} to {}\n", row.key, table_number(one.mean), table_number(one.lowest),
                            table_number(one.highest));
    }
    for (const MeasureSpread& one : variation.measures)
    {
        if (one.key == "area_ratio" || one.key == "gi_hull")
        {
            text += fmt::format("{:<24}{} +- {}\n", one.key, table_number(one.mean), table_number(one.sd));
        }
    }
    return text;
}

} // namespace corticle::study
