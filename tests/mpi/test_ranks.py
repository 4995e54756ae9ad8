#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mpirun: any number of ranks and threads gives the files of one process; goes on with another number; ends when one rank does."""

import contextlib
import os
import random
import shutil
import signal
import sys
import time

import _ranks

import _command
from _run_folders import check_same, wait_for

CASE = """[geometry]
particles = {particles}
[solver]
method = "{method}"
[contact]
distance = {distance}
[time]
end = {end}
[output]
count = 2
pictures = "off"
report = "off"
checkpoint_minutes = 0.01
"""
QUIET = ("run", "case.toml", "--quiet")
SESSION = {"threads", "session_wall_s", "session_steps"}


def write_case(bench, particles=5000, method="tlsph", distance=0.6, end=0.02):
    bench.write("case.toml", CASE.format(particles=particles, method=method, distance=distance, end=end))


def run(bench, ranks, *arguments, expected=0):
    status, _, errors = _ranks.call(bench, ranks, *QUIET, *arguments)
    return bench.check(status == expected, f"{ranks} ranks, {arguments}: exit status {status}; stderr {errors[-800:]!r}")


def test_same_files(bench):
    write_case(bench)
    bench.accepted(*QUIET, "--out", "one", "--threads", "2")
    for ranks, threads in ((2, 1), (3, 2), (8, 1)):
        run(bench, ranks, "--out", f"r{ranks}", "--threads", threads)
        check_same(bench, "one", f"r{ranks}", f"{ranks} ranks of {threads} threads", SESSION)


def test_every_method_gives_the_same_files(bench):
    write_case(bench, particles=1500, method="fem", distance=0.25)
    bench.accepted(*QUIET, "--out", "one")
    run(bench, 2, "--out", "two", "--threads", 1)
    check_same(bench, "one", "two", "finite elements", SESSION)
    log = (bench.folder / "two" / "run.log").read_text(encoding="utf-8")
    bench.check("does not share its work" in log, f"finite elements by 2 ranks: no warning in {log!r}")


def stopped(bench, ranks, number, *arguments):
    """Starts the run, sends the signal to mpirun after its first checkpoint; exit status."""
    file = bench.folder / "B" / "checkpoint.h5"
    before = file.stat().st_mtime_ns if file.exists() else 0
    process = _ranks.start(bench, ranks, *QUIET, "--out", "B", "--threads", 1, *arguments)
    wait_for(process, lambda: file.exists() and file.stat().st_mtime_ns != before, 120)
    process.send_signal(number)
    _, errors = process.communicate(timeout=120)
    return process.returncode, errors


def test_goes_on_with_another_number_of_ranks(bench):
    write_case(bench, particles=4000, end=0.4)
    bench.accepted(*QUIET, "--out", "A")
    for ranks, number in ((3, signal.SIGTERM), (2, signal.SIGUSR1)):
        status, errors = stopped(bench, ranks, number, "--resume")
        bench.check(status not in (0, None), f"{ranks} ranks stopped by {number}: exit status {status}; stderr {errors[-500:]!r}")
        log = (bench.folder / "B" / "run.log").read_text(encoding="utf-8")
        bench.check("interrupted at" in log, f"{ranks} ranks stopped by {number}: no end in the log {log[-500:]!r}")
    bench.accepted(*QUIET, "--out", "B", "--resume")
    check_same(bench, "A", "B", "resumed by 3, 2 and 1 ranks", SESSION)


def test_a_killed_rank_ends_the_run(bench):
    """Ten times one of three ranks is killed at a moment of chance: in setting up, in a step, while a file is written."""
    write_case(bench, particles=4000, end=0.4)
    bench.accepted(*QUIET, "--out", "A")
    chance = random.Random(7)
    killed = 0
    for _ in range(10):
        victim, moment = chance.randrange(3), chance.uniform(0.2, 2.5)
        process = _ranks.start(bench, 3, *QUIET, "--out", "B", "--threads", 1, "--resume")
        time.sleep(moment)
        ranks = sorted(_ranks.rank_ids(process))
        start = time.monotonic()
        if victim < len(ranks):
            with contextlib.suppress(ProcessLookupError):   # it had just ended
                os.kill(ranks[victim], signal.SIGKILL)
            killed += 1
        process.communicate(timeout=120)
        lived = time.monotonic() - start
        bench.check(lived < 30, f"rank {victim} killed after {moment:.2f} s: the others lived {lived:.0f} s")
        bench.check(process.returncode != 0 or victim >= len(ranks), f"rank {victim} killed after {moment:.2f} s: exit status 0")
    bench.check(killed >= 5, f"only {killed} of 10 runs had their ranks when they were to be killed")
    run(bench, 2, "--out", "B", "--threads", 1, "--resume")
    check_same(bench, "A", "B", "resumed after killed ranks", SESSION)


def test_one_message(bench):
    write_case(bench)
    bench.write("held/run.log", "of somebody else\n")
    for arguments, status, part in (
        (("--out", "held"), 2, "run.log"),
        (("--set", "time.end=-1", "--out", "bad"), 2, "time.end"),
        (("--out", "crushed", "--set", "solver.time_step=0.1", "--set", "solver.max_halvings=0",
          "--set", "time.end=0.4"), 3, "inverted"),
    ):
        got, _, errors = _ranks.call(bench, 3, *QUIET, *arguments, timeout=100)
        lines = [line for line in errors.splitlines() if line.startswith(_command.PREFIX)]
        bench.check(got == status, f"{arguments}: exit status {got}, expected {status}; stderr {errors[-800:]!r}")
        bench.check(len(lines) == 1 and part in lines[0], f"{arguments}: expected one message with {part!r}, got {lines}")


def test_one_rank_that_fails_ends_all(bench):
    write_case(bench, particles=4000, end=1.0)
    process = _ranks.start(bench, 3, *QUIET, "--out", "gone", "--threads", 1)
    wait_for(process, (bench.folder / "gone" / "checkpoint.h5").exists, 120)
    shutil.rmtree(bench.folder / "gone")
    start = time.monotonic()
    _, errors = process.communicate(timeout=120)
    lines = [line for line in errors.splitlines() if line.startswith(_command.PREFIX)]
    bench.check(process.returncode == 3, f"no run folder: exit status {process.returncode}; stderr {errors[-800:]!r}")
    bench.check(len(lines) == 1 and "rank 0" in lines[0], f"no run folder: expected one message of rank 0, got {lines}")
    bench.check(time.monotonic() - start < 30, f"no run folder: the ranks lived {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    if _ranks.mpirun() is None:
        print("skipped: no mpirun of Open MPI here")
        sys.exit(_command.SKIPPED)
    sys.exit(_command.main(__doc__, test_same_files, test_every_method_gives_the_same_files,
                           test_goes_on_with_another_number_of_ranks, test_a_killed_rank_ends_the_run, test_one_message,
                           test_one_rank_that_fails_ends_all))
