# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Your own surface
# From arrays of vertices and triangles to a folded body, as docs/guide/own-surface.md does from a file. The surface here is
# an ellipsoid made of a sphere; yours may come from nibabel, trimesh or meshio.

# %%
import numpy as np

import corticle

ball = corticle.prepare(corticle.Case.sphere(particles=2000)).surface
surface = corticle.Surface(ball.vertices * np.array([1.4, 1.0, 1.0]), ball.triangles)

# %% [markdown]
# Measure it: a closed surface has a volume, an area and an index.

# %%
measures = surface.measures()
print(f"{measures['volume_mm3']:.0f} mm³, {measures['area_mm2']:.0f} mm², {measures['gi_hull']:.3f} times its hull")

# %% [markdown]
# Holes are refused with a message, not folded.

# %%
try:
    corticle.prepare(surface.vertices, surface.triangles[1:], particles=1500)
except corticle.InputError as error:
    print(error)

# %%
body = corticle.prepare(surface.vertices, surface.triangles, particles=1500, end=0.05)
print(body)
simulation = corticle.Simulation(body).run()
simulation.surface.save("own_surface.ply")
simulation.surface.save("own_surface.surf.gii")
print(f"area {simulation.measures()['area_ratio']:.3f} times that at the start")
