#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""When the standard sphere folds, and into how many folds, as loading gets slower: does it tend to theory?

Runs are made with $CORTICLE into $CORTICLE_OUT (s45_L50, s45_L100, ...: thousands of particles, loading time), or read
with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
import _sphere  # noqa: E402

LOADING_TIMES = {45000: (50, 100, 200, 400), 120000: (50, 100, 200)}
SETTINGS = ["time.end=0.3", "output.count=6", "output.pictures=off"]
MOST_OFF = 0.02             # of the slowest run's onset from theory
FOLDS_T = 0.3               # folds are there, and not yet deep
DEGREE = (7, 10)            # of most power then, slowest run: 8 to 9, and one more or less


def describe(folder, size, loading_time):
    summary = _runs.read_summary(folder)
    return {"particles": summary["particles"], "size": size, "loading_time": loading_time, "steps": summary["steps"],
            "onset_t": summary["onset_t"], "kinetic_share": summary["kinetic_share"],
            "folds": _sphere.fold_width(folder, FOLDS_T), "wall_s": summary["wall_s"]}


def results_of(arguments, base):
    for size in arguments.sizes:
        for loading_time in LOADING_TIMES[size]:
            folder = base / f"s{size // 1000}_L{loading_time}"
            if not arguments.runs:
                case = _runs.ROOT / "cases" / "sphere.toml"
                chosen = [f"geometry.particles={size}", f"solver.loading_time={loading_time}"]
                _runs.make_run(arguments, case, folder, [*chosen, *SETTINGS])
            if _runs.is_complete(folder):
                yield describe(folder, size, loading_time)
            else:
                print(f"{folder}: no complete run, left out")


def table(results):
    columns = [("particles", lambda r: r["particles"], ",d"), ("loading time", lambda r: r["loading_time"], "d"),
               ("onset t", lambda r: r["onset_t"], ".4f"),
               ("less theory", lambda r: r["onset_t"] - _sphere.THEORY_ONSET_T, "+.4f"),
               ("degree at t = 0.3", lambda r: r["folds"]["dominant_degree"], "d"),
               ("its wavelength mm", lambda r: r["folds"]["dominant_wavelength_mm"], ".2f"),
               ("mean degree", lambda r: r["folds"]["mean_degree"], ".2f"),
               ("kinetic share at t = 0.3", lambda r: r["kinetic_share"], ".4f"), ("steps", lambda r: r["steps"], ",d"),
               ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    low, high = DEGREE
    for size in sorted({result["size"] for result in results}):
        slowest = max((r for r in results if r["size"] == size), key=lambda r: r["loading_time"])
        off = slowest["onset_t"] - _sphere.THEORY_ONSET_T
        if abs(off) > MOST_OFF:
            yield f"{size} particles: onset is {off:+.4f} off theory, expected at most {MOST_OFF}"
        degree = slowest["folds"]["dominant_degree"]
        if not low <= degree <= high:
            yield f"{size} particles: the folds are of degree {degree}, expected {low} to {high}"


def main():
    arguments = _runs.parse_arguments(__doc__, sorted(LOADING_TIMES))
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/sphere_onset")
    results = list(results_of(arguments, base))
    if not results:
        sys.exit("no complete run")
    _runs.write_results(HERE, "Onset of folding as loading gets slower", results, [("Onset", table(results))])
    _runs.finish(differences(results))


main()
