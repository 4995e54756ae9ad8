#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The standard sphere at several resolutions: does it fold to the end at each, and what do the measures tend to?

Runs are made with $CORTICLE into $CORTICLE_OUT (s20, s45, ...: thousands of particles), or read with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
import _sphere  # noqa: E402

SIZES = [8000, 20000, 45000, 120000, 250000]
TIMES = (0.3, 0.5, 1.0)
MOST_OVERLAP = 0.001
ONSET_T = (0.229, 0.253)  # theory 0.241, see sphere_onset
FEWEST_FOR_ONSET = 20000  # below, the cortex is thinner than two spacings


def fold_table(results):
    def of(t, key):
        return lambda result: result["folds"][str(t)][key]

    columns = [("particles", lambda r: r["particles"], ",d")]
    for t in TIMES:
        columns += [(f"degree at t = {t}", of(t, "dominant_degree"), "d"),
                    ("wavelength mm", of(t, "dominant_wavelength_mm"), ".2f"),
                    ("of the mean degree mm", of(t, "mean_wavelength_mm"), ".2f")]
    return _runs.table(columns, results)


def differences(results):
    """What must not happen at any resolution."""
    for result in results:
        yield from _runs.faults(result, MOST_OVERLAP)
        onset, (low, high) = result["onset_t"], ONSET_T
        if result["particles"] >= FEWEST_FOR_ONSET and (onset is None or not low <= onset <= high):
            yield f"{result['particles']} particles: onset t is {onset}, expected {low} to {high}"


def main():
    arguments = _runs.parse_arguments(__doc__, SIZES)
    case = _runs.ROOT / "cases" / "sphere.toml"
    found = _runs.folders(arguments, case, "s", [], _runs.ROOT / "runs/validation/sphere_convergence")
    if not found:
        sys.exit("no complete run")
    results = [_runs.describe(folder) | {"folds": {str(t): _sphere.fold_width(folder, t) for t in TIMES}}
               for _, folder in found]
    _runs.write_results(HERE, "The standard sphere at several resolutions", results,
                        [("Onset and controls", _runs.control_table(results)),
                         ("Width of the folds", fold_table(results)),
                         ("Half of the growth", _runs.time_table(results, "half")),
                         ("All of the growth", _runs.time_table(results, "end"))])
    missing = len(arguments.sizes) - len(found) if not arguments.runs else 0
    _runs.finish([*differences(results), *([f"{missing} runs did not complete"] if missing else [])])


main()
