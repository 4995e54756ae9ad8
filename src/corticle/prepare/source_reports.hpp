// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/geometry/repair.hpp"
#include "corticle/geometry/validate_tets.hpp"
#include "corticle/imaging/mask_report.hpp"

#include <optional>
#include <string>

namespace corticle::prepare
{

/// What the clean-up of the input found and did; one of these for a body from a file.
struct SourceReports
{
    std::optional<imaging::MaskReport> mask;      ///< of a label volume
    std::optional<geometry::RepairReport> repair; ///< of a surface
    std::optional<geometry::TetReport> tets;      ///< of a tet mesh
};

/// As a JSON object with one key, "mask", "repair" or "tets"; empty for a built-in shape.
std::string reports_json(const SourceReports& reports);

} // namespace corticle::prepare
