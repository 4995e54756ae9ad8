// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/model/output_view.hpp"

namespace corticle::metrics
{

/// What skull, fluid and tracts do to the brain; 0 where there is none. Forces, pressures and energies belong to the
/// run's own coordinates, volumes are in mm³ at the week.
struct BoundaryMeasures
{
    double skull_force = 0.0;          ///< of contact between brain and skull: sum of the magnitudes
    double skull_pressure = 0.0;       ///< that over the area of the skull
    double skull_contact_share = 0.0;  ///< of the area of the brain's surface
    double skull_intersections = 0.0;  ///< triangles of brain and skull that cross the other (exact predicates)
    double skull_volume_mm3 = 0.0;     ///< enclosed
    double energy_skull = 0.0;         ///< of its contact with the brain, its springs and its motion
    double fluid_pressure = 0.0;       ///< on the surface of the brain
    double fluid_volume_mm3 = 0.0;     ///< between brain and skull
    double energy_fluid = 0.0;         ///< outside and in the ventricles
    double ventricle_volume_mm3 = 0.0; ///< where a pressure acts in them
    double tract_tension = 0.0;        ///< sum over the tracts
    double tract_stretch = 0.0;        ///< mean of length over rest length
    double energy_tracts = 0.0;
};

BoundaryMeasures boundary_measures(const model::OutputView& view);

} // namespace corticle::metrics
