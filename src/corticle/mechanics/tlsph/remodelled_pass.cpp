// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/remodelled_pass.hpp"

#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/tlsph/deformation_pass.hpp"

namespace corticle::tlsph
{

std::unique_ptr<const DeformationPass> remodelled_deformation_pass(const material::TissueOptions& options)
{
    return deformation_pass(material::RemodellingLaw{material::tissue_law(options)});
}

} // namespace corticle::tlsph
