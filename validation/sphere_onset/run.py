#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""When the standard sphere folds, and into how many folds, as loading gets slower: does it tend to theory?

By particles (s) and by finite elements (f). Runs are made with $CORTICLE into $CORTICLE_OUT (s45_L50, f100_L100, ...:
thousands of particles or tets, loading time), or read with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
import _sphere  # noqa: E402

LOADING_TIMES = {"s": {45000: (50, 100, 200, 400), 120000: (50, 100, 200)},
                 "f": {50000: (50, 100, 200, 400), 223000: (50, 100, 200)}}
NAMES = {"s": "TL-SPH", "f": "FEM"}
SETTINGS = {"s": ["time.end=0.3", "output.count=6", "output.pictures=off"],
            "f": ["solver.method=fem", "time.end=0.36", "output.count=6", "output.pictures=off"]}
SIZE_KEYS = {"s": "geometry.particles", "f": "solver.elements"}
MOST_OFF = 0.02             # of the slowest run's onset from theory
FOLDS_T = {"s": 0.3, "f": 0.36}  # folds are there, and not yet deep
DEGREE = (7, 10)            # of most power then, slowest run: 8 to 9, and one more or less


def describe(folder, method, size, loading_time):
    summary = _runs.read_summary(folder)
    return {"method": method, "size": size, "loading_time": loading_time, "particles": summary["particles"],
            "elements": summary.get("elements", 0), "steps": summary["steps"], "onset_t": summary["onset_t"],
            "kinetic_share": summary["kinetic_share"], "folds": _sphere.fold_width(folder, FOLDS_T[method]),
            "wall_s": summary["wall_s"]}


def results_of(arguments, base):
    for method, sizes in LOADING_TIMES.items():
        for size in (size for size in sizes if size in arguments.sizes):
            for loading_time in sizes[size]:
                folder = base / f"{method}{size // 1000}_L{loading_time}"
                if not arguments.runs:
                    case = _runs.ROOT / "cases" / "sphere.toml"
                    chosen = [f"{SIZE_KEYS[method]}={size}", f"solver.loading_time={loading_time}",
                              "solver.fastest_loading=1"]
                    _runs.make_run(arguments, case, folder, [*chosen, *SETTINGS[method]])
                if _runs.is_complete(folder):
                    yield describe(folder, method, size, loading_time)
                else:
                    print(f"{folder}: no complete run, left out")


def table(results):
    columns = [("method", lambda r: NAMES[r["method"]], ""), ("nodes", lambda r: r["particles"], ",d"),
               ("tets", lambda r: r["elements"] or None, ",d"), ("loading time", lambda r: r["loading_time"], "d"),
               ("onset t", lambda r: r["onset_t"], ".4f"),
               ("less theory", lambda r: r["onset_t"] - _sphere.THEORY_ONSET_T, "+.4f"),
               ("degree at the end", lambda r: r["folds"]["dominant_degree"], "d"),
               ("its wavelength mm", lambda r: r["folds"]["dominant_wavelength_mm"], ".2f"),
               ("mean degree", lambda r: r["folds"]["mean_degree"], ".2f"),
               ("kinetic share", lambda r: r["kinetic_share"], ".4f"), ("steps", lambda r: r["steps"], ",d"),
               ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    low, high = DEGREE
    for method, size in sorted({(result["method"], result["size"]) for result in results}):
        slowest = max((r for r in results if (r["method"], r["size"]) == (method, size)), key=lambda r: r["loading_time"])
        off = slowest["onset_t"] - _sphere.THEORY_ONSET_T
        name = f"{NAMES[method]} {size:,}"
        if abs(off) > MOST_OFF:
            yield f"{name}: onset is {off:+.4f} off theory, expected at most {MOST_OFF}"
        degree = slowest["folds"]["dominant_degree"]
        if not low <= degree <= high:
            yield f"{name}: the folds are of degree {degree}, expected {low} to {high}"


def main():
    arguments = _runs.parse_arguments(__doc__, sorted(size for sizes in LOADING_TIMES.values() for size in sizes))
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/sphere_onset")
    results = list(results_of(arguments, base))
    if not results:
        sys.exit("no complete run")
    _runs.write_results(HERE, "Onset of folding as loading gets slower", results, [("Onset", table(results))])
    _runs.finish(differences(results))


main()
