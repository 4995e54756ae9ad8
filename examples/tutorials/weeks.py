# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Weeks and millimetres
# A run in weeks of gestation, with sizes in mm at each week: docs/guide/weeks.md and docs/guide/to-week-38.md. A few days
# here, with few particles; give `end_week=38.0` and as many particles as `case.check()` asks for.

# %%
from pathlib import Path

import corticle

if not Path("labels.nii.gz").exists():
    corticle.phantom("labels.nii.gz", voxel_mm=2.0)
case = corticle.Case.brain("labels.nii.gz", labels=[2, 3, 5, 7], particles=2000, clock="wang", pictures="off")
case.time.start_week, case.time.end_week = 23.0, 23.3
case.size.law, case.size.applies_to = "quadratic", "body"
case.tissue.thickness_mm = 2.5
case.output.weeks = [23.1, 23.2]

# %%
run = corticle.run(case, "runs/weeks", overwrite=True)
print(run.measures[["week", "length_mm", "area_mm2", "gi_hull"]])

# %% [markdown]
# A simulation knows its week too; steps end where they are asked to.

# %%
simulation = corticle.Simulation(corticle.prepare(case))
simulation.run(week=23.1)
assert simulation.week is not None and abs(simulation.week - 23.1) < 1e-6
week_23 = run.frames.nearest(week=23.3).surface
week_23.save("week23.surf.gii")
week_23.save_shape("sulcal_depth", "week23.sulcal_depth.shape.gii")
