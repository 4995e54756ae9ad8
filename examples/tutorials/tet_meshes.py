# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Finite elements and tet meshes
# The same body by two methods, and as tets of your own: docs/guide/finite-elements.md and docs/guide/tet-meshes.md.

# %%
import corticle

case = corticle.Case.sphere(particles=1500, end=0.03)
particles = corticle.Simulation(corticle.prepare(case)).run()
case.solver.method = "fem"
elements = corticle.Simulation(corticle.prepare(case)).run()
for name, simulation in (("particles", particles), ("tets", elements)):
    print(f"{name}: {len(simulation.body)} nodes, {simulation.steps} steps, area ratio {simulation.measures()['area_ratio']:.5f}")

# %% [markdown]
# A block of tets, six a cube, written by meshio: its nodes are those of the body.

# %%
import itertools  # noqa: E402

import meshio  # noqa: E402
import numpy as np  # noqa: E402

n = 9  # nodes along an edge of 24 mm
nodes = np.stack(np.meshgrid(*[np.linspace(-12.0, 12.0, n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
corner = np.arange(n**3).reshape(n, n, n)[:-1, :-1, :-1].ravel()
step = {"x": n * n, "y": n, "z": 1}
tets = []
for order in itertools.permutations("xyz"):
    tets.append(np.stack([corner + sum(step[axis] for axis in order[:k]) for k in range(4)], axis=1))
meshio.write("block.vtu", meshio.Mesh(nodes, [("tetra", np.concatenate(tets))]))

# %%
block = corticle.prepare("block.vtu", method="fem", arrangement="tet_nodes", thickness_mm=3.0, end=0.02)
print(block)
for note in block.notes:
    print(note)
print(corticle.Simulation(block).run().measures()["area_ratio"])
