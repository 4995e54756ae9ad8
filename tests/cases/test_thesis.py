#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's equations fail as they are known to: as printed at once, with F of displacements after bulging at t of about 0.04."""

import json
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import _command  # noqa: E402
import _run_folders  # noqa: E402

SHORTER = ("geometry.particles=4000", "solver.time_step=1e-4", "output.pictures=off")
CASE = Path(__file__).resolve().parents[2] / "cases" / "thesis" / "printed.toml"
# The thesis's run of this case ended at 0.0429; 4,000 and 8,000 particles end at 0.049 and 0.044.
DISPLACEMENT_T = (0.035, 0.06)
BULGING = 1.02              # sphere index


def failed_run(bench, *settings):
    """Summary and rows of measures.csv of a run that must fail with a diagnosis."""
    sets = [word for setting in (*SHORTER, *settings) for word in ("--set", setting)]
    status, _, errors = bench.call("run", CASE, "--out", "run", "--quiet", *sets, timeout=900)
    bench.check(status == 3, f"exit status {status}, expected 3; stderr {errors[-300:]!r}")
    for part in ("inverted at step", "J = ", "F = [[", "neighbours"):
        bench.check(part in errors, f"stderr {errors[-500:]!r} does not say {part!r}")
    summary = json.loads((bench.folder / "run" / "summary.json").read_text(encoding="utf-8"))
    bench.check(summary["status"] == "failed" and summary["formulation"] == "thesis", f"summary says {summary}")
    return summary, _run_folders.measure_rows(bench.folder / "run")


def as_printed(bench):
    summary, rows = failed_run(bench)
    for key, (low, high) in tomllib.loads(CASE.read_text(encoding="utf-8"))["expect"].items():
        bench.check(low <= summary[key] <= high, f"{key} is {summary[key]}, expected {low} to {high}")
    bench.check(rows[0]["J_max"] < 0.9, f"at rest J is up to {rows[0]['J_max']}, expected below 1 everywhere")


def with_displacements(bench):
    summary, rows = failed_run(bench, "thesis.gradient=displacement")
    low, high = DISPLACEMENT_T
    bench.check(low <= summary["t"] <= high, f"ends at t = {summary['t']}, expected {low} to {high}")
    bench.check(abs(rows[0]["J_min"] - 1) < 1e-9, f"at rest J is {rows[0]['J_min']}")
    bench.check(rows[-1]["gi_sphere"] > BULGING, f"sphere index {rows[-1]['gi_sphere']}, expected bulges")


if __name__ == "__main__":
    _command.main(__doc__, as_printed, with_displacements)
