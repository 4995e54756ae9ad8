// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace corticle::tracts
{

/// Tracts of axons between parts of the brain (keys under [tracts]); columns of the same names in the file hold for
/// single ones.
struct TractOptions
{
    std::string file;        ///< CSV: from and to, or the places of both ends; empty: there are none
    double stiffness = 1.0;  ///< force over elongation [mu_w mm]
    double rest = 1.0;       ///< rest length over the length at the start
    double ramp_time = 0.05; ///< t in which it gets there from the length at the start
    double rate = 0.0;       ///< at which a stretched tract grows in length [1/t, or 1/week with a clock]
    bool pushes = false;     ///< whether a tract shorter than its rest length pushes
    double radius_mm = 0.0;  ///< about an end that is a place: nodes that it holds on to; 0: two spacings
};

} // namespace corticle::tracts
