# SPDX-License-Identifier: GPL-3.0-or-later
"""A small sphere, folded step by step: the state at every output, and the end as arrays."""

import numpy as np

import corticle

case = corticle.Case.sphere(particles=2000, end=0.05)
case.tissue.alpha_t = 1.5
body = corticle.prepare(case)
print(body)


def show(simulation: corticle.Simulation) -> None:
    J = simulation.J
    print(f"t = {simulation.t:.3f}: {simulation.steps} steps, J from {J.min():.3f} to {J.max():.3f}")


simulation = corticle.Simulation(body)
simulation.run(every=0.01, on_output=show)

moved = np.linalg.norm(simulation.positions - body.positions, axis=1)
print(f"particles moved by up to {moved.max():.3f} mm; area {simulation.measures()['area_ratio']:.3f} times that at the start")
