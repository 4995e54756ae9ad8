#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps handed over: commands printed, an array job by a stand-in for Slurm, runs gathered."""

import json
import os
import re
import shlex
import subprocess
import sys

import _command

BASE = """[geometry]
particles = 600
[tissue]
thickness_mm = 3.0
[time]
end = 0.01
[output]
count = 1
pictures = "off"
report = "off"
"""
SWEEP = """base = "base.toml"
pictures = false
[[axis]]
key = "solver.cfl"
values = [0.3, 0.4, 0.6]
"""
ENGINE = """[engine]
partition = "main"
time = "00:10:00"
cpus = 1
memory = "2G"
lines = ["export CORTICLE_TEST=1", "#SBATCH --nice=10"]
"""
SWEEP_OF = ("sweep", "sweep.toml", "--out", "S")

# Notes what it was given and hands out numbers.
SBATCH = """#!/bin/bash
cd "$(dirname "$0")"
echo "$*" >>submitted
echo "$((100 + $(wc -l <submitted)));cluster"
"""
SQUEUE = """#!/bin/bash
cat "$(dirname "$0")/queue" 2>/dev/null
"""


def write(bench, engine=""):
    bench.write("base.toml", BASE)
    bench.write("sweep.toml", SWEEP + engine)


def stand_in(bench):
    """sbatch, squeue, and for the scripts srun and scontrol that note and obey; returns where they note."""
    programs = {"sbatch": SBATCH, "squeue": SQUEUE, "srun": '#!/bin/bash\nshift\nexec "$@"\n',
                "scontrol": '#!/bin/bash\necho "$*" >>"$(dirname "$0")/requeued"\n'}
    for name, text in programs.items():
        (bench.folder / bench.write(f"bin/{name}", text)).chmod(0o755)
    os.environ["PATH"] = f"{bench.folder / 'bin'}:{os.environ['PATH']}"
    return bench.folder / "bin"


def perform(bench, script, task):
    """A task of an array script, as Slurm would start it."""
    environment = dict(os.environ, SLURM_ARRAY_TASK_ID=str(task), SLURM_CPUS_PER_TASK="1", SLURM_JOB_ID="7")
    return subprocess.run(["bash", script], env=environment, cwd=bench.folder, capture_output=True, text=True, timeout=120, check=False)


def states(bench):
    return [run["status"] for run in json.loads((bench.folder / "S/sweep.json").read_text(encoding="utf-8"))["runs"]]


def commands(bench):
    """One command a run on standard output and nothing else; they make the runs, which are then gathered."""
    write(bench)
    lines = bench.accepted(*SWEEP_OF, "--engine", "commands", "--threads-per-run", "1").splitlines()
    bench.check(len(lines) == 3 and all(" --threads 1" in line for line in lines), f"commands {lines}")
    for line in lines[:2]:
        words = shlex.split(line)
        bench.check(words[0].startswith("/") and "proc" not in words[0], f"the program is {words[0]}")
        subprocess.run(words, cwd="/", check=True, timeout=120)
    bench.check(len(bench.accepted(*SWEEP_OF, "--engine", "commands").splitlines()) == 1, "finished runs are printed again")
    output = bench.accepted(*SWEEP_OF, "--gather")
    bench.check("2 completed, 0 failed, 1 not made" in output, f"gathered: {output!r}")
    bench.check(states(bench) == ["completed", "completed", "pending"], f"states {states(bench)}")
    subprocess.run(shlex.split(lines[2]), check=True, timeout=120)
    bench.check(bench.accepted(*SWEEP_OF, "--engine", "commands") == "", "a finished sweep prints commands")
    bench.check(states(bench) == 3 * ["completed"], f"states {states(bench)}")


def submitted(bench):
    """The script says what [engine] says; nothing is submitted twice; requeue, failure, gathering."""
    write(bench, ENGINE)
    noted = stand_in(bench)
    output = bench.accepted(*SWEEP_OF, "--engine", "slurm", "--jobs", "2", "--set", "time.end=0.02")
    bench.check("submitted 3 runs as array job 101" in output and "job 102" in output, f"it says {output!r}")
    script = bench.folder / "S/slurm/1.sh"
    text = script.read_text(encoding="utf-8")
    for line in ("--array=0-2%2", "--partition=main", "--time=00:10:00", "--mem=2G", "--cpus-per-task=1", "--requeue",
                 "--open-mode=append", "--signal=TERM@120", "--nice=10"):
        bench.check(f"#SBATCH {line}\n" in text, f"the script lacks {line}: {text}")
    bench.check(text.index("export CORTICLE_TEST=1") > text.rindex("#SBATCH"), "a command comes before options")
    calls = (noted / "submitted").read_text(encoding="utf-8").splitlines()
    bench.check("--dependency=afterany:101" in calls[1] and "1_gather.sh" in calls[1], f"gathered after {calls}")
    (noted / "queue").write_text("0\n2\n", encoding="utf-8")
    output = bench.accepted(*SWEEP_OF, "--engine", "slurm", "--set", "time.end=0.02")
    bench.check("2 runs are in the queue" in output and "submitted 1 runs" in output, f"beside a queue: {output!r}")
    (noted / "queue").unlink()
    for task in range(3):
        ended = perform(bench, script, task)
        bench.check(ended.returncode == 0, f"task {task}: {ended}")
    gathered = subprocess.run(["bash", bench.folder / "S/slurm/1_gather.sh"], capture_output=True, text=True, timeout=120, check=False)
    bench.check("3 completed" in gathered.stdout, f"gathering: {gathered}")
    bench.check("3 completed" in bench.accepted(*SWEEP_OF, "--engine", "slurm", "--set", "time.end=0.02"), "it submits finished runs")


def unfinished(bench):
    """A run that cannot be made is a row with its reason; one that is interrupted is requeued."""
    bench.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    write(bench)
    bench.write("base.toml", BASE.replace("[geometry]", '[geometry]\nshape = "file"\nfile = "open.off"'))
    noted = stand_in(bench)
    bench.accepted(*SWEEP_OF, "--engine", "slurm")
    script = bench.folder / "S/slurm/1.sh"
    ended = perform(bench, script, 0)
    bench.check(ended.returncode in (2, 3) and "open.off" in ended.stderr, f"the task: {ended}")
    output = bench.accepted(*SWEEP_OF, "--engine", "slurm")
    bench.check("submitted 2 runs" in output and sorted(states(bench)) == ["failed", "pending", "pending"], f"{output!r} {states(bench)}")
    bench.check("open.off" in (bench.folder / "S/sweep.md").read_text(encoding="utf-8"), "the reason is not in sweep.md")
    bench.check("submitted 3 runs" in bench.accepted(*SWEEP_OF, "--engine", "slurm", "--retry"), "--retry leaves it out")
    text = re.sub(r"srun .*\\\n.*\\\n.*\n", "(exit 130)\n", script.read_text(encoding="utf-8"))
    script.write_text(text, encoding="utf-8")
    bench.check(perform(bench, script, 1).returncode == 130, "an interrupted task ends with another status")
    bench.check("requeue 7" in (noted / "requeued").read_text(encoding="utf-8"), "it is not requeued")


def refusals(bench):
    write(bench)
    bench.refused([*SWEEP_OF, "--engine", "pbs"], ["--engine", "slurm"])
    for pair in (("--engine", "slurm", "--cases-only"), ("--cases-only", "--gather"), ("--gather", "--list")):
        bench.refused([*SWEEP_OF, *pair], [pair[0], pair[-1], "one of them"])
    bench.refused([*SWEEP_OF, "--engine", "commands", "--jobs", "2"], ["--jobs"])
    for line, *parts in (('queue = "a"', "queue", "partition"), ('time = "1 h"', "time", "sweep.toml:"), ("cpus = 0", "cpus"),
                         ("cpus = 1.5", "cpus"), ('lines = "a"', "lines"), ('partition = "a b"', "partition")):
        write(bench, f"[engine]\n{line}\n")
        bench.refused(SWEEP_OF, parts)
    bench.write("sweep.toml", "engine = 3\n" + SWEEP)
    bench.refused(SWEEP_OF, ["engine", "[engine]"])
    write(bench)
    os.environ["PATH"] = str(bench.folder)
    status, _, errors = bench.call(*SWEEP_OF, "--engine", "slurm")
    bench.check(status == 3 and "sbatch" in errors, f"without sbatch: {status} {errors!r}")


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)
    _command.main(__doc__, commands, submitted, unfinished, refusals)
