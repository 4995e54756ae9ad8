// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/simulation.hpp"

#include <limits>
#include <span>

namespace corticle::model
{

/// What turns the coordinates of a run, in mm of the body as it was given, into those of a brain at its week.
struct PhysicalScale
{
    double week = std::numeric_limits<double>::quiet_NaN(); ///< gestational age [weeks]; NaN without a clock
    double length = 1.0; ///< mm at this week per mm of the run; areas go with its square, volumes with its cube
};

/// The scale at the run's present time; length is 1 without a length law and with size.scaled = false.
/// With size.applies_to = "reference": L(week) / L(start week), the deformation coming on top (thesis, at eq. 15). With
/// "body": the same times the stretch of the body taken back, so that its length is its first one times that ratio.
PhysicalScale physical_scale(const Simulation& simulation);

/// `positions` times `factor`, about the origin [mm].
std::vector<Vec3> scaled(std::span<const Vec3> positions, double factor);

} // namespace corticle::model
