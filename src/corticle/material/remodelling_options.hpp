// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::material
{

// Rates and times below are those of the clock: weeks where there is one, growth time t otherwise.

/// Which way fibres run.
enum class FibreField
{
    none,   ///< there are no fibres
    radial, ///< away from the centroid of the body
    depth,  ///< along the gradient of the distance to the surface
    file    ///< as a volume of vectors says
};

/// Axons of the white matter (keys under [fibres]).
struct FibreOptions
{
    FibreField direction = FibreField::none;
    double stiffness = 0.0;      ///< k of what is stretched; compressed, fibres buckle and carry nothing [mu]
    double active_stress = 0.0;  ///< tension at any length [mu]
    double ramp = 0.1;           ///< in which the active stress rises from 0 [time of the clock]
    double growth_rate = 0.0;    ///< rate at which their rest length follows their stretch [1 / time of the clock]
    double growth_stretch = 1.0; ///< elastic stretch above which it does [-]
};

/// Viscoelastic relaxation (keys under [relaxation]).
struct RelaxationOptions
{
    double share = 0.0; ///< of the shear modulus, which relaxes [-]
    double time = 0.1;  ///< tau [time of the clock]
};

/// White matter that grows as it is stretched (keys under [stress_growth]).
struct StressGrowthOptions
{
    double rate = 0.0;         ///< G_s [1 / time of the clock]
    double volume_ratio = 1.0; ///< J_0, elastic volume ratio above which it grows [-]
    bool shrinks = false;      ///< whether it shrinks below
};

/// What gives tissue a history.
struct RemodellingOptions
{
    FibreOptions fibres;
    RelaxationOptions relaxation;
    StressGrowthOptions stress_growth;

    bool has_fibres() const { return fibres.direction != FibreField::none; }
    bool any() const { return has_fibres() || relaxation.share > 0.0 || stress_growth.rate > 0.0; }
};

} // namespace corticle::material
