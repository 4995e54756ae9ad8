# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Fitting a parameter
# `corticle fit` (docs/guide/fitting.md) fits several parameters to a brain. One parameter to one number is a bisection: which
# growth gives this area? The answer is known here, as the area is that of a run.

# %%
import corticle

body = corticle.prepare(corticle.Case.sphere(particles=1000, end=0.02))


def area_ratio(alpha: float) -> float:
    case = body.case
    case.tissue.alpha_t = alpha
    return corticle.Simulation(body, case).run().measures()["area_ratio"]


# %%
truth = 1.3
wanted = area_ratio(truth)
low, high = 0.5, 2.5
while high - low > 0.01:
    middle = 0.5 * (low + high)
    low, high = (middle, high) if area_ratio(middle) < wanted else (low, middle)
print(f"alpha_t is between {low:.3f} and {high:.3f}")
assert low <= truth <= high
