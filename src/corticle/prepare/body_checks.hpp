// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/prepare/prepare.hpp"

namespace corticle::prepare
{

/// Refuses a cortex that is the whole body at the start, and one whose thickness comes to 0 somewhere during the run.
/// @param tissue  with options, size, depth and the thickness map, at `places`
/// @throws InputError
void require_cortex(const PreparationOptions& options, std::span<const Vec3> places,
                    const material::TissueFields& tissue);

/// A line where a body from a file is far smaller or larger than any brain; empty where it is not.
std::string size_warning(const PreparationOptions& options, const model::Model& model);

} // namespace corticle::prepare
