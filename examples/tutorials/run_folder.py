# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Reading a run folder
# What docs/guide/run-folder.md and docs/guide/report.md describe, as arrays: measures, frames, particles, the report.

# %%
from pathlib import Path

import numpy as np

import corticle

case = corticle.Case.sphere({"output.pictures": "off", "output.times": [0.02, 0.04]}, particles=1500, end=0.06)
corticle.run(case, "runs/folder", overwrite=True)

# %% [markdown]
# A run is opened by its folder; nothing but the list of outputs and measures is read until it is asked for.

# %%
run = corticle.open_run("runs/folder")
print(run.status, [frame.t for frame in run.frames])
print({name: run.units[name] for name in ("area_mm2", "gi_hull", "sulcal_depth_mean_mm")})

# %%
particles = run.frames.nearest(t=0.06).particles
print(len(particles), sorted(particles.arrays))
assert np.allclose(np.linalg.det(particles["F"]), particles["J"], rtol=1e-5)

# %% [markdown]
# Interrupted runs go on from their checkpoint with `resume=True`. The report is one HTML file.

# %%
print(Path(corticle.report("runs/folder")).stat().st_size > 10_000)
