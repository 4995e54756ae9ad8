// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/tracts/options.hpp"
#include "corticle/mechanics/tracts/tracts.hpp"
#include "corticle/model/model.hpp"

namespace corticle::prepare
{

/// The tracts of a body from a table with columns from and to, labels of map.region_file, or from_x, from_y, from_z,
/// to_x, to_y, to_z, places in the reference frame [mm]; and, where single tracts differ, stiffness, rest and
/// growth_rate.
/// @throws InputError for a table that cannot be read, labels and places that the body does not have, and a tract
/// whose ends lie in one place
tracts::Tracts read_tracts(const tracts::TractOptions& options, const model::Model& model);

} // namespace corticle::prepare
