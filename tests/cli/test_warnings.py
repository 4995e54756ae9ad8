#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What must be said of a run: too slow or too fast for equilibrium, broken states, outputs that it does not reach."""

import json

import _command
import _surfaces

SPHERE = """[geometry]
particles = 2000
[tissue]
thickness_mm = 2.5
[time]
end = 0.3
[output]
count = 3
pictures = "off"
"""


def run(bench, *more):
    """(warnings on the terminal, summary.json) of a run that completes."""
    status, _, errors = bench.call("run", "case.toml", "--out", "run", "--overwrite", *more)
    bench.check(status == 0, f"{more}: exit status {status}; stderr {errors[-500:]!r}")
    return errors, json.loads((bench.folder / "run" / "summary.json").read_text(encoding="utf-8"))


def equilibrium(bench):
    """A run that lags behind its growth, or is rushed, says so once; one at the defaults does not."""
    bench.write("case.toml", SPHERE)
    keys = ("residual_force", "dissipated_share", "energy_balance_error", "kinetic_share", "zero_mode_share")
    errors, summary = run(bench)
    print({key: summary.get(key) for key in keys})
    bench.check(all(key in summary for key in keys), "summary.json lacks measures of equilibrium")
    bench.check("equilibrium" not in errors and "quasi-static" not in errors and "balance" not in errors,
                f"warnings at the defaults: {errors!r}")
    bench.check("t = 0.000" not in errors, f"warnings of a body at rest: {errors!r}")
    for change in ("solver.damping=5000", "solver.damping=100000", "solver.loading_time=5"):
        errors, summary = run(bench, "--set", change)
        print(change, {key: summary.get(key) for key in keys})
        bench.check(errors.count("not in equilibrium") == 1, f"{change}: expected one warning, got {errors!r}")
    for method in ("solver.loading_time=5", "solver.damping=5000"):
        errors, summary = run(bench, "--set", "solver.method=fem", "--set", method)
        print("fem", method, {key: summary.get(key) for key in keys})
        bench.check(errors.count("not in equilibrium") == 1, f"tets, {method}: expected a warning, got {errors!r}")


def outputs(bench):
    """Output times and weeks that the run does not reach are named."""
    bench.write("case.toml", SPHERE)
    fast = ("--set", "time.end=0.02")
    errors, _ = run(bench, *fast, "--set", "output.times=[0.01, 0.5]")
    bench.check("output.times: 0.5 outside the run" in errors, f"output.times: {errors!r}")
    status, _, errors = bench.call("run", "case.toml", "--out", "run", "--resume", "--set", "time.end=0.03", "--set",
                                   "output.times=[0.005, 0.01, 0.025]")
    bench.check(status == 0 and "output.times: 0.005 passed before" in errors, f"resumed: {status}, {errors!r}")
    rows = (bench.folder / "run" / "measures.csv").read_text(encoding="utf-8").splitlines()[1:]
    times = [float(row.split(",")[0]) for row in rows]
    bench.check(times == [0.0, 0.01, 0.02, 0.025, 0.03], f"output times {times}")
    weeks = ("--set", "time.clock=cubic", "--set", "time.start_week=23", "--set", "time.end_week=24")
    errors, _ = run(bench, *weeks, "--set", "output.weeks=[22, 23.5, 30]")
    bench.check("output.weeks: 22, 30 outside the run, weeks 23 to 24" in errors, f"output.weeks: {errors!r}")


def wrong_unit(bench):
    """A surface in metres taken for one in millimetres."""
    bench.write("metres.off", _surfaces.off(_surfaces.icosphere(0.04)))
    bench.write("case.toml", '[geometry]\nshape = "file"\nfile = "metres.off"\nparticles = 800\n[tissue]\n'
                'thickness_mm = 8\n[output]\npictures = "off"\n')
    parts = ["cortex of 8 mm", "thicker than the body", "geometry.unit"]
    bench.refused(["check", "case.toml"], parts)
    bench.refused(["prepare", "case.toml", "--out", "body"], parts)
    bench.refused(["run", "case.toml", "--out", "run"], parts)
    output = bench.accepted("check", "case.toml", "--set", "geometry.unit=m")
    bench.check("brain" not in output, f"a brain of 80 mm: {output!r}")
    output = bench.accepted("check", "case.toml", "--set", "tissue.thickness_mm=0.01")
    bench.check("far smaller than any brain" in output, f"a brain of 0.08 mm: {output!r}")


def thickness_comes_to_nothing(bench):
    surface = _surfaces.icosphere(20.0)
    bench.write("body.off", _surfaces.off(surface))
    bench.write("thickness.txt", "".join(f"{4.0 if z < 0 else 0.5}\n" for _, _, z in surface[0]))
    bench.write("case.toml", '[geometry]\nshape = "file"\nfile = "body.off"\nparticles = 800\n[map]\n'
                'thickness_file = "thickness.txt"\n[tissue]\nthickness_rate_mm = -0.6\n')
    bench.refused(["run", "case.toml", "--out", "run"], ["thickness_rate_mm = -0.6", "0.5 mm thick", "-0.1 mm at t = 1"])


if __name__ == "__main__":
    _command.main(__doc__, equilibrium, outputs, wrong_unit, thickness_comes_to_nothing)
