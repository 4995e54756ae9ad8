# SPDX-License-Identifier: GPL-3.0-or-later
"""Every signal that asks a run to end leaves a checkpoint and a summary, however often and soon it comes again."""

import fcntl
import json
import os
import pty
import resource
import signal
import subprocess
import termios
import time
from pathlib import Path

import _command
from _run_folders import stop, wait_for

CASE = ('[geometry]\nparticles = 1500\n[tissue]\nthickness_mm = 4\n[solver]\nloading_time = 5000\n'
        '[output]\ncount = 1\npictures = "off"\n')
SIGNALS = (signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU, signal.SIGTERM, signal.SIGINT)
RUN = ("run", "case.toml", "--out", "r", "--overwrite", "--quiet", "--threads", "1")


def summary(bench, folder="r"):
    path = bench.folder / folder / "summary.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}


def begin(bench, preexec=None):
    """A run past its first output time."""
    log = bench.folder / "r" / "run.log"
    log.unlink(missing_ok=True)
    process = subprocess.Popen([bench.command, *RUN], cwd=bench.folder, stdin=subprocess.DEVNULL, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=preexec)
    begun = wait_for(process, lambda: log.is_file() and "t = 0.0000" in log.read_text(), 120)
    bench.check(begun, "the run did not begin")
    return process


def check_interrupted(bench, how, status, errors):
    bench.check(status == 130, f"{how}: exit status {status}, expected 130; stderr {errors[-300:]!r}")
    bench.check(summary(bench).get("status") == "interrupted", f"{how}: summary {summary(bench).get('status')}")
    bench.check((bench.folder / "r/checkpoint.h5").is_file(), f"{how}: no checkpoint")


def each_signal(bench):
    bench.write("case.toml", CASE)
    for number in SIGNALS:
        process = begin(bench)
        check_interrupted(bench, number.name, *stop(process, number))


def twice(bench):
    """The same request milliseconds later, from a wrapper that signals process and group; even Ctrl-C twice."""
    bench.write("case.toml", CASE)
    for first, second, gap in ((signal.SIGTERM, signal.SIGTERM, 0.002), (signal.SIGTERM, signal.SIGTERM, 0.005),
                               (signal.SIGHUP, signal.SIGTERM, 0.001), (signal.SIGINT, signal.SIGINT, 0.05)):
        process = begin(bench)
        process.send_signal(first)
        time.sleep(gap)
        check_interrupted(bench, f"{first.name} and {second.name} after {gap} s", *stop(process, second))


def nohup(bench):
    """A hangup that nohup has set to be ignored ends nothing."""
    bench.write("case.toml", CASE)
    process = begin(bench, lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    process.send_signal(signal.SIGHUP)
    time.sleep(0.3)
    bench.check(process.poll() is None, "the hangup ended a run under nohup")
    check_interrupted(bench, "nohup", *stop(process, signal.SIGTERM))


def closed_terminal(bench):
    """The terminal goes away: a hangup, and nothing can be written to it any more."""
    bench.write("case.toml", CASE)
    bench.write("sweep.toml", 'base = "case.toml"\npictures = false\n[[axis]]\nkey = "geometry.seed"\nvalues = [1, 2]\n')
    for arguments, folder in ((("run", "case.toml", "--out", "t"), "t"),
                              (("sweep", "sweep.toml", "--out", "T", "--jobs", "1"), "T/runs/seed-1")):
        master, slave = pty.openpty()
        process = subprocess.Popen([bench.command, *arguments], cwd=bench.folder, stdin=slave, stdout=slave, stderr=slave,
                                   start_new_session=True, preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        os.close(slave)
        begun = wait_for(process, (bench.folder / folder / "checkpoint.h5").is_file, 120)
        time.sleep(1.0)  # the line of progress is drawn
        os.close(master)
        status = process.wait(60)
        bench.check(begun and status == 130, f"{arguments[0]} in a closed terminal: exit status {status}, expected 130")
        got = summary(bench, folder).get("status")
        bench.check(got == "interrupted", f"{arguments[0]} in a closed terminal: the run is {got}")


def sweeps(bench):
    """Also two signals at once end the runs of a sweep with their checkpoints; SIGCHLD may be ignored."""
    bench.write("case.toml", CASE)
    bench.write("sweep.toml", 'base = "case.toml"\npictures = false\n[[axis]]\nkey = "geometry.seed"\nvalues = [1, 2]\n')
    for number in (signal.SIGHUP, signal.SIGTERM):
        process = subprocess.Popen([bench.command, "sweep", "sweep.toml", "--out", "S", "--jobs", "1"], cwd=bench.folder,
                                   stdin=subprocess.DEVNULL, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
        log = bench.folder / "S/runs/seed-1/run.log"
        before = log.read_text().count("corticle") if log.is_file() else 0
        begun = wait_for(process, lambda: log.is_file() and log.read_text().count("corticle") > before
                         and (bench.folder / "S/runs/seed-1/checkpoint.h5").is_file(), 120)
        bench.check(begun, "no run was begun")
        process.send_signal(number)
        time.sleep(0.003)
        status, errors = stop(process, number)
        bench.check(status == 130, f"sweep, {number.name} twice: exit status {status}; stderr {errors[-300:]!r}")
        got = summary(bench, "S/runs/seed-1").get("status")
        bench.check(got == "interrupted", f"sweep, {number.name} twice: its run is {got}")


def address_space(bench, *arguments):
    """The largest address space of a command [bytes]."""
    process = bench.start(*arguments)
    largest = 0
    while process.poll() is None:
        status = Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        largest = max([largest, *(int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmPeak"))])
        time.sleep(0.005)
    process.communicate()
    return largest


def memory(bench):
    """A body that does not fit beside what a small one takes: one line and exit status 3."""
    bench.write("case.toml", CASE)
    small = ("--set", "geometry.particles=600", "--set", "time.end=0.001", "--threads", "1", "--quiet")
    for verb in ("run", "prepare"):
        limit = address_space(bench, verb, "case.toml", "--out", f"small_{verb}", *small) + (4 << 20)
        with subprocess.Popen([bench.command, verb, "case.toml", "--out", verb, "--threads", "1", "--set",
                               "geometry.particles=250000"], cwd=bench.folder, stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))) as process:
            _, errors = process.communicate(timeout=300)
        bench.check(process.returncode == 3 and errors == "corticle: error: out of memory\n",
                    f"{verb} without memory: exit status {process.returncode}, stderr {errors[-500:]!r}")
        bench.check(summary(bench, verb).get("status", "failed") == "failed", f"{verb}: summary {summary(bench, verb)}")


if __name__ == "__main__":
    _command.main(__doc__, each_signal, twice, nohup, closed_terminal, sweeps, memory)
