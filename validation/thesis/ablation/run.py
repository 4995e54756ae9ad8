#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the thesis's equations as printed to ours, one correction at a time, and ours with each alone left out.

Runs are made with $CORTICLE into $CORTICLE_OUT, one folder each, and go on where they were interrupted; with --runs they are
only read. A run that fails is a result.
"""

import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))

import _runs  # noqa: E402

PARTICLES = 8000
OUTPUTS = 20
FIXED_STEP = 1e-4
BEFORE = 0.99               # share of the time of failure at which a failed run is looked at

# What the thesis does, and what we do instead. The order is that of the first table.
CORRECTIONS = {
    "dynamics": {"solver.integrator": ("rk4", "symplectic_euler"), "solver.damping": (0.0, 50.0),
                 "thesis.viscosity_alpha": (0.04, 0.0), "thesis.viscosity_beta": (0.08, 0.0)},
    "growth": {"thesis.growth": ("multiplied", "divided")},
    "force": {"thesis.force": ("difference", "conservative")},
    "gradient": {"thesis.gradient": ("plain", "corrected")},
    "volumes": {"geometry.volumes": ("neighbour_count", "cells"), "geometry.normals": ("divisions", "surface")},
    "control": {"solver.zeta": (0.0, 0.1)},
    "contact": {"contact.enabled": ("false", "true")},
    "kernel": {"solver.kernel_mm": (3.5, 0.0)},
    "barrier": {"tissue.barrier_J": (0.0, 0.3)}}

TITLES = {
    "dynamics": "our time step, damping for viscosity", "growth": "growth taken out, stress pulled back",
    "force": "conservative force", "gradient": "gradient correction", "volumes": "exact volumes and normals",
    "control": "zero-energy control", "contact": "self-contact", "kernel": "kernel of 2.3 spacings", "barrier": "barrier"}

DISPLACEMENT = "thesis.gradient=displacement"
PICTURES = ("printed", "displacement", "with_barrier", "without_growth", "without_force")
LEAST_T = 1.0               # ours gets there
MOST_PRINTED_T = 0.1        # the thesis's largest time; as printed none gets there


def settings_of(corrected, extra=()):
    """--set words of a run with these corrections."""
    chosen = [f"{key}={values[name in corrected]}" for name, keys in CORRECTIONS.items() for key, values in keys.items()]
    # Without a conservative force the body is crushed, and a step that follows the state shrinks for ever.
    follows = {"dynamics", "force"} <= set(corrected)
    steps = ["solver.time_step=0", "solver.max_halvings=8"] if follows else \
        [f"solver.time_step={FIXED_STEP}", "solver.max_halvings=0"]
    # Contact needs the steps of symplectic Euler.
    integrator = ["solver.integrator=symplectic_euler"] if "contact" in corrected else []
    return [*steps, *chosen, *integrator, *extra]


def variants():
    """(folder, title, part of the page, settings) of every run."""
    done = []
    yield "printed", "as printed", "steps", settings_of(done)
    for name in CORRECTIONS:
        done.append(name)
        yield f"with_{name}", f"+ {TITLES[name]}", "steps", settings_of(done)
    ours = ["solver.formulation=corrected", "solver.integrator=symplectic_euler",
            "solver.kernel_mm=0", "solver.time_step=0", "tissue.layer=binary", "tissue.lambda=0.75"]
    yield "ours", "the main solver", "steps", ours
    for name in CORRECTIONS:
        yield f"without_{name}", f"- {TITLES[name]}", "left out", settings_of([other for other in done if other != name])
    yield "without_gradient_displacement", "- gradient correction, F of displacements", "left out", \
        settings_of([name for name in done if name != "gradient"], [DISPLACEMENT])
    yield "displacement", "as printed, F of displacements", "readings", settings_of([], [DISPLACEMENT])
    yield "displacement_fine", "the same, step 2e-5", "readings", settings_of([], [DISPLACEMENT, "solver.time_step=2e-5"])
    yield "displacement_loading_25", "the same, twice as fast", "readings", \
        settings_of([], [DISPLACEMENT, "solver.loading_time=25"])
    yield "displacement_loading_100", "the same, half as fast", "readings", \
        settings_of([], [DISPLACEMENT, "solver.loading_time=100"])
    yield "displacement_no_growth", "the same, hardly any growth", "readings", \
        settings_of([], [DISPLACEMENT, "tissue.alpha_t=0.001"])
    for name in ("growth", "force", "volumes"):
        yield f"displacement_{name}", f"the same + {TITLES[name]}", "readings", settings_of([name], [DISPLACEMENT])


def is_over(folder):
    return _runs.read_summary(folder).get("status") in ("completed", "failed")


def make(arguments, folder, settings):
    if not is_over(folder):
        _runs.make_run(arguments, _runs.ROOT / "cases" / "thesis" / "printed.toml", folder, settings)


def describe(arguments, base, folder, settings):
    """What became of a run; a failed one is made once more up to just before it fails, to be looked at."""
    run = base / folder
    settings = [f"geometry.particles={arguments.sizes[0]}", *settings]
    if not arguments.runs:
        make(arguments, run, [*settings, "time.end=1", f"output.count={OUTPUTS}", "output.picture_times=[1.0]"])
    if not is_over(run):
        print(f"{run}: not run to its end, left out")
        return None
    summary, seen = _runs.read_summary(run), run
    if summary["status"] == "failed" and summary["t"] > 0:
        seen = base / f"{folder}_before"
        end = BEFORE * summary["t"]
        if not arguments.runs:
            make(arguments, seen, [*settings, f"time.end={end}", "output.count=4", f"output.picture_times=[{end}]"])
    rows = _runs.read_measures(seen)
    last = rows[-1]
    copy_picture(folder, seen)
    return {"status": summary["status"], "reason": summary.get("reason", "")[:120], "t": summary["t"],
            "steps": summary["steps"], "wall_s": summary["wall_s"], "seen_at_t": last["t"],
            "neighbours": summary["neighbours_mean"]} | \
        {key: last[key] for key in ("area_ratio", "volume_ratio", "gi_sphere", "gi_hull", "overlap_area_share")} | \
        {"J_min": min(row["J_min"] for row in rows), "J_max": max(row["J_max"] for row in rows)}


def copy_picture(name, run):
    pictures = sorted((run / "pictures").glob("surface_J_*.png"))
    if name in PICTURES and pictures:
        (HERE / "pictures").mkdir(exist_ok=True)
        shutil.copyfile(pictures[-1], HERE / "pictures" / f"{name}.png")


def table(results):
    columns = [("run", lambda r: r["title"], ""), ("ends", lambda r: r["status"], ""), ("at t", lambda r: r["t"], ".4f"),
               ("area ratio", lambda r: r["area_ratio"], ".3f"), ("volume ratio", lambda r: r["volume_ratio"], ".3f"),
               ("sphere index", lambda r: r["gi_sphere"], ".3f"), ("hull index", lambda r: r["gi_hull"], ".3f"),
               ("least J", lambda r: r["J_min"], ".3f"), ("largest J", lambda r: r["J_max"], ".2f"),
               ("overlap", lambda r: r["overlap_area_share"], ".4f"), ("steps", lambda r: r["steps"], ",d"),
               ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    by_name = {result["run"]: result for result in results}
    for name in ("printed", "displacement"):
        result = by_name.get(name)
        if result and (result["status"] != "failed" or result["t"] > MOST_PRINTED_T):
            yield f"{name}: {result['status']} at t = {result['t']}, expected to fail before {MOST_PRINTED_T}"
    for name in ("with_barrier", "ours"):
        result = by_name.get(name)
        if result and result["t"] < LEAST_T:
            yield f"{name}: ends at t = {result['t']}, expected {LEAST_T}"


def main():
    arguments = _runs.parse_arguments(__doc__, [PARTICLES])
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/thesis_ablation")
    results = []
    for folder, title, part, settings in variants():
        result = describe(arguments, base, folder, settings)
        if result:
            results.append({"run": folder, "title": title, "part": part} | result)
    if not results:
        sys.exit("no run")
    headings = {"steps": "One correction after another", "left out": "Each alone left out",
                "readings": "What the thesis may have run"}
    sections = [(heading, table([r for r in results if r["part"] == part])) for part, heading in headings.items()]
    _runs.write_results(HERE, "Which correction cures what", results, sections)
    _runs.finish(differences(results))


main()
