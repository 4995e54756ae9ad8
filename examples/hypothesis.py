# SPDX-License-Identifier: GPL-3.0-or-later
"""Three hypotheses in ten lines each: growth that differs from place to place, a law of growth and a force that the program
does not have."""

import numpy as np
import numpy.typing as npt

import corticle

FloatArray = npt.NDArray[np.float64]

body = corticle.prepare(corticle.Case.sphere(particles=2000, end=0.02))

# Growth is higher towards +x.
towards_x = body.positions[:, 0] / body.positions[:, 0].max()
uneven = corticle.Simulation(body.with_fields(growth=1.0 + 0.5 * towards_x)).run()
print(f"growth from {uneven.growth.min():.4f} to {uneven.growth.max():.4f}")


# Growth is slower where the tissue is pressed together.
def slowed(t: float, fields: corticle.Fields) -> FloatArray:
    pressure = -np.trace(fields.stress, axis1=1, axis2=2) / 3.0
    rate = body.case.tissue.alpha_t * fields.theta / (1.0 + np.maximum(pressure, 0.0))
    return fields.growth + rate * (t - fields.t)


under_pressure = corticle.Simulation(body)
under_pressure.set_growth(slowed)
under_pressure.run()
print(f"growth up to {under_pressure.growth.max():.4f} under pressure")

# Fibres between opposite particles of the surface: springs across the body.
ends = body.surface_particles
start = body.positions[ends]
across = ends[np.argmin(start @ start.T, axis=1)]
stiffness = 0.01  # mu_w mm


def fibres(t: float, positions: FloatArray, velocities: FloatArray) -> "tuple[FloatArray, float]":
    stretch = (positions[across] - positions[ends]) - (body.positions[across] - body.positions[ends])
    forces = np.zeros_like(positions)
    np.add.at(forces, ends, stiffness * stretch)
    np.add.at(forces, across, -stiffness * stretch)
    return forces, 0.5 * stiffness * float((stretch**2).sum())


held = corticle.Simulation(body)
held.add_force(fibres, "fibres")
held.run()
free = corticle.Simulation(body).run()
print(f"area ratio {held.measures()['area_ratio']:.5f} with fibres, {free.measures()['area_ratio']:.5f} without")
print(f"energies: {held.energies}")
