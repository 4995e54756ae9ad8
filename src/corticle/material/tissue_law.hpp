// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/options.hpp"

namespace corticle::material
{

/// The law of the tissue: of every method, and of the stresses in output files. Chosen here for all of them.
inline NeoHookean tissue_law(const TissueOptions& options)
{
    return {options.barrier_J};
}

} // namespace corticle::material
