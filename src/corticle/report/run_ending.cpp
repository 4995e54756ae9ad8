// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/run_ending.hpp"

#include "corticle/report/plain_text.hpp"
#include "corticle/report/report.hpp"
#include "corticle/report/run_facts.hpp"
#include "corticle/report/sources.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::report
{

namespace
{

/// Keys of summary.json, with their units.
constexpr std::array shown{
    std::pair{"week", ""},
    std::pair{"onset_t", ""},
    std::pair{"area_ratio", ""},
    std::pair{"volume_ratio", ""},
    std::pair{"gi_hull", ""},
    std::pair{"gi_sphere", ""},
    std::pair{"thickness_mean_mm", " mm"},
    std::pair{"sulcal_depth_mean_mm", " mm"},
    std::pair{"fold_wavelength_mm", " mm"},
    std::pair{"intersecting_triangles", ""},
    std::pair{"energy_balance_error", ""},
};

} // namespace

std::string run_ending(const std::filesystem::path& folder)
{
    const Json summary = read_summary(folder);
    std::string text =
        fmt::format("{}: {} at t = {:.4g}, {} particles, {} steps, {:.1f} s\n", folder.string(),
                    summary.value("status", "no summary"), summary.value("t", 0.0), summary.value("particles", 0),
                    summary.value("steps", 0), summary.value("wall_s", 0.0));
    for (const auto& [key, unit] : shown)
    {
        const Json value = summary.value(key, Json(nullptr));
        if (value.is_number())
        {
            text += fmt::format("  {:<38}{:.4g}{}\n", label_of(key), value.get<double>(), unit);
        }
    }
    for (const char* file : {report_file, "surface.pvd", "measures.csv"})
    {
        if (is_there(folder / file))
        {
            return text + fmt::format("open {}\n", (folder / file).string());
        }
    }
    return text;
}

} // namespace corticle::report
