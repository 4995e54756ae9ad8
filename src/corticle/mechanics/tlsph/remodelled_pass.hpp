// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/options.hpp"

#include <memory>

namespace corticle::tlsph
{

class DeformationPass;

/// The pass of tissue with a history (Tissue::remodelling), compiled apart from those without.
std::unique_ptr<const DeformationPass> remodelled_deformation_pass(const material::TissueOptions& options);

} // namespace corticle::tlsph
