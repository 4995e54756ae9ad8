# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Testing a hypothesis
# Hypotheses that the program has are sections of a case (docs/guide/hypotheses.md); those it does not have are ten lines.

# %%
import numpy as np
import numpy.typing as npt

import corticle

FloatArray = npt.NDArray[np.float64]
case = corticle.Case.sphere({"stress_growth.rate": 3.0, "relaxation.share": 0.3}, particles=1500, end=0.03)
case.fibres.direction, case.fibres.stiffness = "radial", 0.5
body = corticle.prepare(case)
print(corticle.Simulation(body).run().energies)

# %% [markdown]
# Fibres as any field of directions, here along z.

# %%
along_z = np.broadcast_to([0.0, 0.0, 1.0], (len(body), 3))
print(corticle.Simulation(body.with_fields(fibres=along_z)).run().energies)

# %% [markdown]
# A law of growth: the cortex grows more slowly where it is pressed together.

# %%
control = corticle.prepare(corticle.Case.sphere(particles=1500, end=0.03))
alpha = control.case.tissue.alpha_t


def slowed(week: float, fields: corticle.Fields) -> FloatArray:
    pressure = -np.trace(fields.stress, axis1=1, axis2=2) / 3.0
    rate = alpha * fields.theta / (1.0 + np.maximum(pressure, 0.0))
    return fields.growth + rate * (week - (fields.week or fields.t))


simulation = corticle.Simulation(control)
simulation.set_growth(slowed)
simulation.run()
plain = corticle.Simulation(control).run()
print(f"growth up to {simulation.growth.max():.4f}, by the keys {plain.growth.max():.4f}")
assert simulation.growth.max() < plain.growth.max()
