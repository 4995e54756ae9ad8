# SPDX-License-Identifier: GPL-3.0-or-later
"""White matter that grows as it is stretched: wavelength and depth of the folds of a strip against the ratio of the rates."""

import _runs
import _strip

RATES = (0.0, 0.4, 1.2, 4.0)  # G_s per growth time
SEEDS = (1,)
CORTEX_RATE = 0.8             # alpha_t: the film grows by this in the run
RATIO = 3.0
BULK = 10.0
LENGTH, DEPTH = 24.0, 7.0
CELLS = 2
LOADING = 50.0
MODES = 16
MOST_ERROR = 0.01             # of the energy balance
MOST_SHORTER = 0.05           # of the wavelength, from no growth of the white matter to the fastest


def plan(rate, seed):
    spacing = 1 / CELLS
    settings = {"geometry.size_mm": f"[{LENGTH}, {4 * spacing:.6f}, {DEPTH}]", "geometry.spacing_mm": spacing,
                "tissue.mu_cortex": RATIO, "tissue.bulk_modulus": BULK, "tissue.alpha_t": CORTEX_RATE,
                "solver.loading_time": LOADING, "imperfection.amplitude": 0.05, "imperfection.seed": seed, "output.count": 16}
    if rate:
        settings["stress_growth.rate"] = rate
    return [f"{key}={value}" for key, value in settings.items()]


def describe(rate, folders):
    """Means over the seeds, at the end."""
    rows = [_runs.read_measures(folder)[-1] for folder in folders]
    waves = [2 * LENGTH / _strip.mean_number(folder, CORTEX_RATE, MODES) for folder in folders]
    ends = [_strip.heights(folder, CORTEX_RATE)[-1][1] for folder in folders]
    return {"rate": rate, "ratio": rate / CORTEX_RATE, "seeds": len(rows), "wavelength": sum(waves) / len(waves),
            "depth": 2 * sum(ends) / len(ends), "wavelengths": waves, "depths": [2 * end for end in ends],
            "taken": sum(row["energy_remodelling"] / row["work_growth"] for row in rows) / len(rows),
            "most_error": max(row["energy_balance_error"] for row in rows),
            "wall_s": sum(_runs.read_summary(folder)["wall_s"] for folder in folders) / len(folders)}


def results_of(arguments, base):
    found = []
    for rate in RATES:
        complete = []
        for seed in SEEDS:
            folder = base / f"white_{rate:g}_s{seed}"
            if not arguments.runs:
                _runs.make_run(arguments, _strip.CASE, folder, plan(rate, seed))
            if _runs.is_complete(folder):
                complete.append(folder)
            else:
                print(f"{folder}: no complete run, left out")
        if complete:
            found.append(describe(rate, complete))
    return found


def table(results):
    columns = [("G_s", lambda r: r["rate"], "g"), ("G_s / G_c", lambda r: r["ratio"], ".2f"),
               ("wavelength", lambda r: r["wavelength"], ".2f"), ("depth", lambda r: r["depth"], ".3f"),
               ("taken by growth, of the work", lambda r: r["taken"], ".3f"),
               ("seeds", lambda r: r["seeds"], "d"), ("most energy balance error", lambda r: r["most_error"], ".1e"),
               ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    """What does not go as published: depth falls, and wavelength does not, as white matter follows faster."""
    for slower, faster in zip(results, results[1:]):
        if faster["depth"] > slower["depth"]:
            yield f"white matter, G_s {slower['rate']:g} to {faster['rate']:g}: folds become deeper"
    if results and results[-1]["wavelength"] < (1 - MOST_SHORTER) * results[0]["wavelength"]:
        yield "white matter: the wavelength falls with its rate, expected to rise"
    for result in results:
        if result["most_error"] > MOST_ERROR:
            yield f"white matter, G_s {result['rate']:g}: energy balance off by {result['most_error']:.4f}"


def panels(results):
    ratios = [r["ratio"] for r in results]
    yield ("Folds where white matter follows", "its rate over that of the film", [
        ("depth, thicknesses", ratios, [r["depth"] for r in results], "line"),
        ("wavelength, thicknesses", ratios, [r["wavelength"] for r in results], "line")])
