#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""White matter that grows as it is stretched: wavelength and depth of folds against its rate.

Runs of cases/hypotheses/stress_growth.toml are made with $CORTICLE into $CORTICLE_OUT (g0_s1, g3_s2, ...: rate, seed of
the imperfection), or read with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402

CASES = _runs.ROOT / "cases" / "hypotheses"
RATES = (0.0, 1.0, 3.0, 10.0)
SEEDS = (1, 2)
CORTEX_RATE = 1.8284271247461903  # alpha_t per growth time
MOST_ERROR = 0.01  # of the energy balance


def runs_of(arguments, base):
    """(rate, folder) of every run that is complete."""
    for rate in RATES:
        for seed in SEEDS:
            folder = base / f"g{rate:g}_s{seed}"
            if not arguments.runs:
                case = CASES / ("stress_growth.toml" if rate else "differential_growth.toml")
                settings = [f"imperfection.seed={seed}", "output.pictures=off", "output.report=off"]
                _runs.make_run(arguments, case, folder, settings + ([f"stress_growth.rate={rate}"] if rate else []))
            if _runs.is_complete(folder):
                yield rate, folder
            else:
                print(f"{folder}: no complete run, left out")


def describe(rate, folders):
    """Means over the seeds, at the end."""
    rows = [_runs.read_measures(folder)[-1] for folder in folders]

    def mean(key):
        return sum(row[key] for row in rows) / len(rows)

    keys = ("t", "gi_hull", "fold_wavelength_reference_mm", "sulcal_depth_mean_mm", "energy_remodelling", "work_growth")
    return {"rate": rate, "ratio": rate / CORTEX_RATE, "seeds": len(rows), **{key: mean(key) for key in keys},
            "most_error": max(row["energy_balance_error"] for row in rows)}


def results_of(arguments, base):
    folders = {}
    for rate, folder in runs_of(arguments, base):
        folders.setdefault(rate, []).append(folder)
    return [describe(rate, of_rate) for rate, of_rate in folders.items()]


def table(results):
    columns = [("G_s", lambda r: r["rate"], "g"), ("G_s / G_c", lambda r: r["ratio"], ".2f"),
               ("wavelength on the reference mm", lambda r: r["fold_wavelength_reference_mm"], ".2f"),
               ("mean sulcal depth mm", lambda r: r["sulcal_depth_mean_mm"], ".3f"),
               ("hull index", lambda r: r["gi_hull"], ".3f"),
               ("taken by growth, of the work", lambda r: r["energy_remodelling"] / r["work_growth"], ".3f"),
               ("energy balance error", lambda r: r["most_error"], ".5f")]
    return _runs.table(columns, results)


def differences(results):
    """What does not go as published: depth falls, and wavelength does not, as white matter follows faster."""
    for slower, faster in zip(results, results[1:]):
        name = f"G_s {slower['rate']:g} to {faster['rate']:g}"
        if faster["sulcal_depth_mean_mm"] > slower["sulcal_depth_mean_mm"]:
            yield f"{name}: folds become deeper"
    if results[-1]["fold_wavelength_reference_mm"] < 0.95 * results[0]["fold_wavelength_reference_mm"]:
        yield "the wavelength falls with the rate of the white matter, expected to rise"
    for result in results:
        if result["most_error"] > MOST_ERROR:
            yield f"G_s {result['rate']:g}: energy balance off by {result['most_error']:.4f}"


def main():
    arguments = _runs.parse_arguments(__doc__, [])
    results = results_of(arguments, Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/hypotheses"))
    if not results:
        sys.exit("no complete run")
    _runs.write_results(HERE, "White matter that grows as it is stretched", results, [("Means over seeds", table(results))])
    _runs.finish(differences(results))


main()
