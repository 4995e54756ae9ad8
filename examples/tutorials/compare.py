# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Comparing
# Two runs side by side, as `corticle compare` does (docs/guide/compare.md), and two surfaces by hand.

# %%
import numpy as np

import corticle

case = corticle.Case.sphere({"output.pictures": "off", "output.count": 2}, particles=1500, end=0.04)
control = corticle.run(case, "runs/control", overwrite=True)
case.tissue.alpha_t = 2.5
stronger = corticle.run(case, "runs/stronger", overwrite=True)

# %%
result = corticle.compare(control, stronger, "comparison", overwrite=True)
print(sorted(result))

# %% [markdown]
# The same particles in both: how far apart they are.

# %%
apart = control.frames[-1].particles.positions - stronger.frames[-1].particles.positions
print(f"particles are up to {np.linalg.norm(apart, axis=1).max():.3f} mm apart")
