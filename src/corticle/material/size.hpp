// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/clock.hpp"

namespace corticle::material
{

/// Longitudinal length L of a brain at its gestational age.
enum class LengthLaw
{
    none,
    hyperbolic, ///< L = 59 / (1 - 0.55 t) mm: Tallinen et al. 2016, thesis eq. 15; belongs to the cubic clock
    quadratic   ///< L = -0.067 w² + 7.16 w - 66.05 mm: Wang et al. 2019, thesis eq. 16
};

/// Which length the law is taken for.
enum class SizedState
{
    reference, ///< the reference state is scaled, the simulated deformation comes on top (Tallinen, thesis)
    body       ///< outputs are scaled so that the deformed body has the law's length (BrainGrowth)
};

/// How lengths follow the weeks (keys under [size]).
struct SizeOptions
{
    LengthLaw law = LengthLaw::none;
    SizedState applies_to = SizedState::reference;
    bool thin_cortex = false; ///< whether the cortex keeps its mm while the reference state grows: H / s
    bool scaled = true;       ///< whether outputs are in mm at their week, or in those of the start
};

/// L [mm] at a gestational age; t of the hyperbolic law is that of the clock.
/// @throws InputError beyond the range of the clock
double brain_length(LengthLaw law, GestationalClock clock, double week);

/// Size of the reference state as time goes on.
struct ReferenceSize
{
    GestationalClock clock = GestationalClock::none;
    LengthLaw law = LengthLaw::none;
    double start_week = 0.0;

    /// s = L(week at t) / L(start_week) [-]; 1 without a law.
    double scale(double t) const;
    /// ds/dt
    double scale_rate(double t) const;
};

} // namespace corticle::material
