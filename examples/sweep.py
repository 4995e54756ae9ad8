# SPDX-License-Identifier: GPL-3.0-or-later
"""One body, several simulations: they share it, and run in threads of their own."""

from concurrent.futures import ThreadPoolExecutor

import corticle

case = corticle.Case.sphere(particles=1500, end=0.02)
body = corticle.prepare(case)


def fold(alpha: float) -> float:
    changed = case.copy()
    changed.tissue.alpha_t = alpha
    simulation = corticle.Simulation(body, changed).run()
    return simulation.measures()["area_ratio"]


rates = [0.5, 1.0, 2.0]
with ThreadPoolExecutor(max_workers=2) as pool:
    for alpha, ratio in zip(rates, pool.map(fold, rates)):
        print(f"alpha_t = {alpha}: area ratio {ratio:.4f}")
