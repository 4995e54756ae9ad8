// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/repair.hpp"
#include "corticle/geometry/validate_tets.hpp"
#include "corticle/imaging/mask_report.hpp"
#include "corticle/material/tissue_kind.hpp"

#include <optional>
#include <string>

namespace corticle::prepare
{

/// Tissues of a body whose labels tell them apart.
struct TissueReport
{
    material::PerTissue<double> volume_mm3{}; ///< the cortex by its share
    double cortex_area_share = 0.0;           ///< of the outer surface
    double thickness_mm = 0.0;                ///< mean of the cortex below the surface, by area
};
/// One line.
std::string describe(const TissueReport& report);

/// What the clean-up of the input found and did; one of these for a body from a file.
struct SourceReports
{
    std::optional<imaging::MaskReport> mask;      ///< of a label volume
    std::optional<geometry::RepairReport> repair; ///< of a surface
    std::optional<geometry::TetReport> tets;      ///< of a tet mesh
    std::optional<TissueReport> tissues;          ///< of labels of tissues
};

/// As a JSON object with one key, "mask", "repair" or "tets", and "tissues" where labels tell them apart; empty for a
/// built-in shape.
std::string reports_json(const SourceReports& reports);

} // namespace corticle::prepare
