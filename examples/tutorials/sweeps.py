# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# # Sweeps
# docs/guide/sweep.md as a loop: one body, several simulations, in threads of their own.

# %%
from concurrent.futures import ThreadPoolExecutor

import corticle

body = corticle.prepare(corticle.Case.sphere(particles=1500, end=0.02))
corticle.set_threads(1)  # of each simulation


def area_ratio(alpha: float) -> float:
    case = body.case
    case.tissue.alpha_t = alpha
    return corticle.Simulation(body, case).run().measures()["area_ratio"]


# %%
rates = [0.5, 1.0, 2.0]
with ThreadPoolExecutor(max_workers=2) as pool:
    ratios = list(pool.map(area_ratio, rates))
for alpha, ratio in zip(rates, ratios):
    print(f"alpha_t = {alpha}: area ratio {ratio:.4f}")
assert ratios == sorted(ratios)
