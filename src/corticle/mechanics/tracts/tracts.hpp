// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace corticle::tracts
{

/// What a tract ends in: a force on it is shared among its nodes as their masses are.
struct TractEnd
{
    std::vector<std::int32_t> nodes; ///< ascending
    std::vector<double> shares;      ///< of each; their sum is 1
};

struct Tract
{
    std::int32_t from; ///< end
    std::int32_t to;   ///< end
    double stiffness;  ///< force over elongation [mu_w mm]
    double rest;       ///< rest length over the length at the start
    double rate;       ///< at which it grows in length while stretched [1/t, or 1/week with a clock]
};

/// All tracts of a body.
struct Tracts
{
    std::vector<TractEnd> ends;
    std::vector<Tract> tracts;
    bool push = false;       ///< whether tracts shorter than their rest length push
    double ramp_time = 0.05; ///< t in which rest lengths get from the length at the start to where they are to be
};

} // namespace corticle::tracts
