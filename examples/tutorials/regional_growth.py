# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Regional growth and thickness
# Maps as arrays, at the vertices of a surface or at the particles: docs/guide/regional-growth.md does it with files.

# %%
import numpy as np

import corticle

ball = corticle.prepare(corticle.Case.sphere(particles=2000)).surface
up = ball.vertices[:, 2] / ball.vertices[:, 2].max()

# %% [markdown]
# Numbers at the vertices: they are carried to the particles from the closest point of the surface.

# %%
body = corticle.prepare(ball, growth=1.0 + 0.5 * up, thickness=2.5 - 0.5 * up, particles=1500, end=0.03)
print(f"growth {body.growth.min():.2f} to {body.growth.max():.2f}")
assert body.thickness is not None
print(f"thickness {body.thickness.min():.2f} to {body.thickness.max():.2f} mm")

# %% [markdown]
# Regions and a table: labels at the vertices, and the factor of each.

# %%
halves = (ball.vertices[:, 0] > 0.0).astype(int)
regional = corticle.prepare(ball, regions=halves, region_growth={0: 0.5, 1: 1.5}, particles=1500, end=0.03)
grown = corticle.Simulation(regional).run().growth
x = regional.positions[:, 0]
print(f"largest growth: left {grown[x < -2.0].max():.4f}, right {grown[x > 2.0].max():.4f}")
assert grown[x > 2.0].max() > grown[x < -2.0].max()

# %% [markdown]
# Or at the particles, as any function of where they are.

# %%
still = corticle.Simulation(body.with_fields(growth=np.where(body.positions[:, 2] > 0.0, 1.0, 0.0))).run().growth
assert (still[body.positions[:, 2] <= 0.0] == 1.0).all()
