// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/fold_measures.hpp"

#include <string>

namespace corticle::metrics
{

/// A measure by name: key as in summary.json, unit ("-": a pure number).
struct SurfaceRow
{
    std::string key;
    std::string unit;
    double value = 0.0;
};

/// All measures of a closed surface [mm], in the order in which tables show them: the one ruler for simulated and real
/// surfaces. Every surface has the same keys.
std::vector<SurfaceRow> surface_rows(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                     const FoldOptions& options = {});

} // namespace corticle::metrics
