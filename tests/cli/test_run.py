# SPDX-License-Identifier: GPL-3.0-or-later
"""A small run from end to end: files of the run folder, refusals, threads, interruption and resumption."""

import json
import signal
import subprocess
import time

import _command

CASE = ('[geometry]\nparticles = 800\n[tissue]\nlayer = "binary"\nlambda = 0.75\n'
        '[time]\nend = 0.1\n[output]\ncount = 2\npictures = "off"\n')
# Figures of the machine, not of the body.
VOLATILE = {"wall_s", "us_per_particle_step", "peak_memory_mb", "internal_forces_s", "contact_s", "measures_s", "output_s", "threads"}


def summary(bench, folder):
    path = bench.folder / folder / "summary.json"
    return json.loads(path.read_text()) if path.is_file() else {}


def physics(values):
    return {key: value for key, value in values.items() if key not in VOLATILE}


def folder_and_refusals(bench):
    bench.write("case.toml", CASE)
    output = bench.accepted("run", "case.toml", "--quiet")
    bench.check(output == "", f"--quiet printed {output[:200]!r}")
    run = bench.folder / "runs" / "case"
    for name in ("case.toml", "summary.json", "measures.csv", "surface.pvd", "particles.pvd", "checkpoint.h5", "run.log"):
        bench.check((run / name).is_file(), f"the run folder lacks {name}")
    got = summary(bench, "runs/case")
    bench.check(got.get("status") == "completed" and abs(got.get("t", 0) - 0.1) < 1e-12, f"summary: {got}")
    for key in ("area_ratio", "curved_area_ratio", "curved_volume_ratio", "curved_gi_hull", "gi_hull", "gi_sphere", "J_min", "overlap_area_share", "onset_t", "energy_elastic"):
        bench.check(key in got, f"summary.json lacks {key}")
    rows = (run / "measures.csv").read_text().strip().splitlines() if (run / "measures.csv").is_file() else []
    bench.check(len(rows) == 4, f"measures.csv has {len(rows)} lines, expected a header and 3 times")
    bench.refused(["run", "case.toml"], ["runs/case"])
    bench.check(physics(summary(bench, "runs/case")) == physics(got), "a refused run changed the summary")
    bench.refused(["run", "case.toml", "--resume", "--set", "tissue.mu_white=2"], ["tissue.mu_white"])
    bench.accepted("run", "runs/case/case.toml", "--out", "again", "--quiet", "--threads", "2")
    bench.check(physics(summary(bench, "again")) == physics(got),
                "the resolved case with 2 threads gives another summary")
    bench.accepted("run", "case.toml", "--out", "again", "--overwrite", "--quiet", "--set", "time.end=0.02")
    bench.check(abs(summary(bench, "again").get("t", 0) - 0.02) < 1e-12, "--overwrite left the earlier run")


def interruption(bench):
    """SIGINT ends a run with 130 and a checkpoint; resumed, it ends as if nothing had happened."""
    bench.write("case.toml", CASE.replace("800", "4000"))
    bench.accepted("run", "case.toml", "--out", "whole", "--quiet")
    process = bench.start("run", "case.toml", "--out", "parts", "--quiet")
    deadline = time.monotonic() + 120
    while process.poll() is None and time.monotonic() < deadline:
        if list((bench.folder / "parts").glob("surface_*.vtp")):
            break # preparation is over
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    try:
        _, errors = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        bench.check(False, "a run does not end on SIGINT")
        return
    if process.returncode == 0:
        print("the run was over before the signal came: interruption not checked")
        return
    bench.check(process.returncode == 130, f"interrupted: exit status {process.returncode}; stderr {errors[-500:]!r}")
    bench.check(summary(bench, "parts").get("status") == "interrupted", "summary.json does not say interrupted")
    bench.accepted("run", "case.toml", "--out", "parts", "--resume", "--quiet")
    bench.check(physics(summary(bench, "parts")) == physics(summary(bench, "whole")),
                "a run interrupted and resumed ends elsewhere")


if __name__ == "__main__":
    _command.main(__doc__, folder_and_refusals, interruption)
