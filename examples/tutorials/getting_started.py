# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Getting started
# A sphere whose cortex grows, from the case to a table and a picture, as in docs/guide/getting-started.md. It is coarse,
# and ends early, so that each cell takes seconds; take the case as it is (45,000 particles, to t = 1) to see folds.

# %%
import corticle

case = corticle.Case.sphere(particles=2000, end=0.05)
case.output.count = 4
case.output.pictures = "off"
print(case.geometry)

# %% [markdown]
# `check` says what is allowed but probably not meant: here that the cortex is resolved poorly.

# %%
for line in case.check():
    print(line)

# %% [markdown]
# Run it into a folder, with the same files as those of the command.

# %%
run = corticle.run(case, "runs/sphere", overwrite=True)
print(run)
print(run.measures[["t", "area_mm2", "gi_hull", "J_min"]])

# %% [markdown]
# The last surface: vertices, triangles, and arrays at the vertices. In a notebook `surface` alone shows a picture.

# %%
surface = run.frames[-1].surface
print(surface)
print({name: values.shape for name, values in surface.arrays.items()})
surface
