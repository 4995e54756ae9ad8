#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep over a real Slurm of one node: killed, failed, signalled and requeued runs, gathered. Skipped where there is none."""

import csv
import os
import signal
import sys

import _command
import _slurm
from _run_folders import check_same

BASE = """[geometry]
particles = 800
[tissue]
thickness_mm = 3.0
[time]
end = 0.3
[output]
count = 10
pictures = "off"
report = "off"
checkpoint_minutes = 0.001
"""
SWEEP = """base = "base.toml"
pictures = false
[[axis]]
key = "solver.cfl"
values = [0.3, 0.4, 0.5, 0.6]
[[axis]]
key = "geometry.particles"
values = [600, 800]
[engine]
partition = "main"
time = "00:20:00"
"""
SWEEP_OF = ("sweep", "sweep.toml", "--out", "S", "--engine", "slurm")
FAILING, KILLED, SIGNALLED = "cfl-0.5_particles-600", "cfl-0.3_particles-800", "cfl-0.3_particles-600"


def rows(bench):
    with open(bench.folder / "S/sweep.csv", encoding="utf-8", newline="") as stream:
        return {row["name"]: row for row in csv.DictReader(stream)}


def process_of(bench, name):
    """The process that makes a run; none where nobody does."""
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = open(f"/proc/{entry}/cmdline", "rb").read().split(b"\0")
        except OSError:
            continue
        if words[0] == os.fsencode(bench.command) and os.fsencode(f"{bench.folder}/S/runs/{name}") in words:
            return int(entry)
    return None


def is_begun(bench, name):
    return process_of(bench, name) and (bench.folder / "S/runs" / name / "surface_0002.vtp").exists()


def sweep_of_eight(bench):
    bench.write("base.toml", BASE)
    bench.write("sweep.toml", SWEEP)
    blocked = bench.folder / "S/runs" / FAILING / "surface.pvd"
    blocked.mkdir(parents=True)
    with _slurm.Slurm() as slurm:
        if not slurm.is_up():
            print("no node came up here: skipped")
            sys.exit(_command.SKIPPED)
        os.environ.update(slurm.environment)
        output = bench.accepted(*SWEEP_OF, "--jobs", "2")
        bench.check("submitted 8 runs" in output, f"it says {output!r}")
        if bench.check(slurm.wait_for(lambda: is_begun(bench, KILLED)), "the run to be killed was not begun"):
            os.kill(process_of(bench, KILLED), signal.SIGKILL)
        if bench.check(slurm.wait_for(lambda: is_begun(bench, SIGNALLED)), "the run to be signalled was not begun"):
            os.kill(process_of(bench, SIGNALLED), signal.SIGTERM) # what --signal=TERM@120 does before the time is over
        task = (bench.folder / "S/slurm/1.runs").read_text(encoding="utf-8").split().index(KILLED)
        slurm.wait_for(lambda: all(entry.split()[1] != str(task) for entry in slurm.queue()))
        output = bench.accepted(*SWEEP_OF)
        bench.check("in the queue" in output and "submitted 1 runs" in output, f"what is unfinished: {output!r}")
        bench.check(slurm.wait_for(lambda: not slurm.queue(), 240), f"the queue does not end: {slurm.queue()}")
        states = {name: row["status"] for name, row in rows(bench).items()}
        bench.check(states.pop(FAILING) == "failed" and set(states.values()) == {"completed"}, f"gathered: {states}")
        bench.check("surface.pvd" in rows(bench)[FAILING]["reason"], f"reason {rows(bench)[FAILING]['reason']!r}")
        for name in (KILLED, SIGNALLED):
            log = (bench.folder / "S/runs" / name / "run.log").read_text(encoding="utf-8")
            bench.check("resumed at t" in log, f"{name} did not go on from its checkpoint")
    for name in (KILLED, SIGNALLED):
        bench.accepted("run", f"S/cases/{name}.toml", "--out", name, "--quiet")
        check_same(bench, name, f"S/runs/{name}", "over Slurm and never stopped", also_volatile=["threads"])


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)
    reason = _slurm.lacking()
    if reason:
        print("no Slurm here:", reason)
        sys.exit(_command.SKIPPED)
    _command.main(__doc__, sweep_of_eight)
