// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/remodelled_pass.hpp"

#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/fem/force_pass.hpp"

namespace corticle::fem
{

std::unique_ptr<const ForcePass> remodelled_force_pass(const material::TissueOptions& options)
{
    return force_pass(material::RemodellingLaw{material::tissue_law(options), true});
}

} // namespace corticle::fem
