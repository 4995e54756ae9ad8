// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/study/sweep/sweep_file.hpp"
#include "corticle/study/sweep/sweep_place.hpp"

namespace corticle::sweep
{

/// The [[axis]] tables, those with the same `zip` joined into one. @throws InputError
std::vector<SweepAxis> sweep_axes(const config::TomlNode& list, const SweepPlace& place);

} // namespace corticle::sweep
