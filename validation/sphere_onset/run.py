#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""When the standard sphere folds, and into how many folds: at the default settings, and with each part of them changed.

Runs are made with $CORTICLE into $CORTICLE_OUT (s45, s20_seed2, f50, ...: thousands of particles or tets, what is
changed), or read with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
import _sphere  # noqa: E402

NAMES = {"s": "TL-SPH", "f": "FEM"}
SIZES = {"s": (20000, 45000, 120000, 250000), "f": (50000, 223000)}
SETTINGS = {"s": ["time.end=0.3", "output.count=6", "output.pictures=off"],
            "f": ["solver.method=fem", "time.end=0.36", "output.count=6", "output.pictures=off"]}
SIZE_KEYS = {"s": "geometry.particles", "f": "solver.elements"}
FOLDS_T = {"s": 0.3, "f": 0.36}  # folds are there, and not yet deep

PERFECT = "imperfection.amplitude=0"
STEADY = "solver.slowest_loading=1"
CHANGES = {
    "": ("defaults", []),
    "_seed2": ("another field", ["imperfection.seed=2"]),
    "_seed3": ("a third", ["imperfection.seed=3"]),
    "_L100": ("loading time 100", ["solver.loading_time=100"]),
    "_perfect": ("no imperfection", [PERFECT]),
    "_steady": ("loading not slowed", [STEADY]),
    "_neither": ("neither", [PERFECT, STEADY]),
}
CHANGED = {("s", 20000): ("_seed2", "_seed3", "_L100", "_perfect", "_steady", "_neither"),
           ("s", 250000): ("_neither",), ("f", 50000): ("_neither",)}

MOST_OFF = 0.012  # of the onset of particles at the defaults from theory
DEGREE = (8, 9)   # of most power then


def describe(folder, method, size, change):
    summary = _runs.read_summary(folder)
    return {"method": method, "size": size, "change": change, "particles": summary["particles"],
            "elements": summary.get("elements", 0), "steps": summary["steps"], "onset_t": summary["onset_t"],
            "kinetic_share": summary["kinetic_share"], "folds": _sphere.fold_width(folder, FOLDS_T[method]),
            "wall_s": summary["wall_s"]}


def results_of(arguments, base):
    for method, sizes in SIZES.items():
        for size in (size for size in sizes if size in arguments.sizes):
            for change in ("", *CHANGED.get((method, size), ())):
                folder = base / f"{method}{size // 1000}{change}"
                chosen = [f"{SIZE_KEYS[method]}={size}", *CHANGES[change][1], *SETTINGS[method]]
                if _runs.has_run(arguments, _runs.ROOT / "cases" / "sphere.toml", folder, chosen):
                    yield describe(folder, method, size, change)


def table(results):
    columns = [("method", lambda r: NAMES[r["method"]], ""), ("nodes", lambda r: r["particles"], ",d"),
               ("tets", lambda r: r["elements"] or None, ",d"), ("settings", lambda r: CHANGES[r["change"]][0], ""),
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
    for result in (r for r in results if r["method"] == "s" and not r["change"]):
        off = result["onset_t"] - _sphere.THEORY_ONSET_T
        name = f"{NAMES[result['method']]} {result['size']:,}"
        if abs(off) > MOST_OFF:
            yield f"{name}: onset is {off:+.4f} off theory, expected at most {MOST_OFF}"
        degree = result["folds"]["dominant_degree"]
        if not low <= degree <= high:
            yield f"{name}: the folds are of degree {degree}, expected {low} to {high}"


def main():
    arguments = _runs.parse_arguments(__doc__, sorted(size for sizes in SIZES.values() for size in sizes))
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/sphere_onset")
    results = list(results_of(arguments, base))
    if not results:
        sys.exit("no complete run")
    sections = [("At the default settings", table([r for r in results if not r["change"]])),
                ("With one thing changed", table([r for r in results if r["change"]]))]
    _runs.write_results(HERE, "Onset of folding", results, sections)
    _runs.finish(differences(results))


main()
