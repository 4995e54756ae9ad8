#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Killed, interrupted, on one thread or two: every file of the run comes out the same. A bad checkpoint or a full disk is said so."""

import random
import resource
import shutil
import signal
import subprocess
import time

import _command
from _run_folders import check_same, stop, temporaries, wait_for

CASE = """[geometry]
particles = 3000
[tissue]
layer = "binary"
lambda = 0.75
[time]
end = 0.5
[output]
count = 5
pictures = "{pictures}"
picture_times = [0.3, 0.5]
checkpoint_minutes = 0.002
"""
KILLS = 3
SEED = 20240607
QUIET = ("run", "case.toml", "--quiet")


def whole_run(bench, *more, pictures="on"):
    """The uninterrupted run, into A; its wall time [s]."""
    bench.write("case.toml", CASE.format(pictures=pictures))
    start = time.monotonic()
    bench.accepted(*QUIET, "--out", "A", *more)
    if pictures == "on" and not list((bench.folder / "A").glob("pictures/*.png")):
        print("pictures cannot be made here: the run is compared without them")
    return time.monotonic() - start


def kill(bench, condition):
    """SIGKILL once the condition holds of a session of B; whether the run was still going."""
    process = bench.start(*QUIET, "--out", "B", "--resume")
    wait_for(process, condition, 120)
    status, errors = stop(process, signal.SIGKILL)
    bench.check(status in (0, -signal.SIGKILL), f"resumed after a kill: exit status {status}; stderr {errors[-500:]!r}")
    return status == -signal.SIGKILL


def after_its_checkpoint(bench, seconds):
    """A condition: that long after the session's first checkpoint, which shows that it goes on from the one before."""
    file = bench.folder / "B" / "checkpoint.h5"
    before = file.stat().st_mtime_ns if file.exists() else 0
    due = []

    def condition():
        if not due and file.exists() and file.stat().st_mtime_ns != before:
            due.append(time.monotonic() + seconds)
        return due and time.monotonic() >= due[0]

    return condition


def in_writing(bench, skipped):
    """A condition: a file is being written aside, and so many were before it."""
    seen = set(temporaries(bench.folder))
    goal = len(seen) + skipped

    def condition():
        now = set(temporaries(bench.folder)) - seen
        seen.update(now)
        return now and len(seen) > goal

    return condition


def kills(bench):
    """B: killed at random moments, and in the midst of a file."""
    moments = random.Random(SEED)
    seconds = whole_run(bench)
    hits = sum(kill(bench, after_its_checkpoint(bench, seconds * moments.uniform(0.0, 0.2))) for _ in range(KILLS))
    hits += kill(bench, in_writing(bench, moments.randrange(5)))
    print(f"{hits} of {KILLS + 1} kills hit the run")
    bench.check(hits > 1, "the kills missed the run")
    bench.accepted(*QUIET, "--out", "B", "--resume")
    check_same(bench, "A", "B", "killed and resumed")
    left = temporaries(bench.folder / "B")
    bench.check(not left, f"killed and resumed: files written aside were left behind: {left}")


def interruption(bench):
    """C: SIGTERM, then resumed. D: one thread against two."""
    whole_run(bench, "--threads", "2")
    process = bench.start(*QUIET, "--out", "C", "--threads", "2")
    seen = wait_for(process, (bench.folder / "C" / "surface_0002.vtp").exists, 200)
    status, errors = stop(process, signal.SIGTERM)
    bench.check(seen and status == 130, f"SIGTERM: exit status {status}, expected 130; stderr {errors[-500:]!r}")
    bench.check(temporaries(bench.folder / "C") == [], "SIGTERM: files written aside were left behind")
    bench.accepted(*QUIET, "--out", "C", "--resume", "--threads", "2")
    check_same(bench, "A", "C", "interrupted and resumed")
    bench.accepted(*QUIET, "--out", "D", "--threads", "1")
    check_same(bench, "A", "D", "1 thread against 2", also_volatile=["threads"])


def two_in_one_folder(bench):
    """A folder that a run is writing to is not given to another."""
    bench.write("case.toml", CASE.format(pictures="off"))
    process = bench.start(*QUIET, "--out", "A")
    seen = wait_for(process, (bench.folder / "A" / "surface_0000.vtp").exists, 120)
    process.send_signal(signal.SIGSTOP)
    try:
        bench.check(seen, "the first run wrote nothing")
        for how in ("--overwrite", "--resume"):
            bench.refused([*QUIET, "--out", "A", how], ["--out A", "another process"])
    finally:
        process.send_signal(signal.SIGCONT)
    status, errors = stop(process, signal.SIGTERM)
    bench.check(status == 130, f"the first run: exit status {status}, expected 130; stderr {errors[-500:]!r}")
    bench.accepted(*QUIET, "--out", "A", "--resume")


def bad_checkpoints(bench):
    bench.write("case.toml", CASE.format(pictures="off").replace("0.5\n", "0.1\n"))
    bench.accepted(*QUIET, "--out", "A")
    resumed = (*QUIET, "--out", "A", "--resume")
    bench.refused([*resumed, "--set", "tissue.mu_cortex=0.9"], ["tissue.mu_cortex"])
    bench.refused([*resumed, "--set", "geometry.particles=3100"], ["geometry.particles"])
    good = (bench.folder / "A" / "checkpoint.h5").read_bytes()
    flipped = bytearray(good)
    flipped[len(good) // 2] ^= 1
    bad = {"truncated": good[:len(good) // 2], "short by a byte": good[:-1], "damaged": bytes(flipped), "empty": b"",
           "foreign": b"\x89PNG\r\n\x1a\n" + bytes(4000), "foreign HDF5": good[512:]}
    for what, content in bad.items():
        bench.write("A/checkpoint.h5", content)
        print(f"checkpoint: {what}", flush=True)
        bench.refused(resumed, ["checkpoint.h5"])
    bench.write("A/checkpoint.h5", good)
    bench.accepted(*resumed)


def check_failed_write(bench, how, out, status, errors, reason):
    """Status 3, one line that names a file and the reason, nothing half-written, a checkpoint."""
    bench.check(status == 3, f"{how}: exit status {status}, expected 3; stderr {errors[-500:]!r}")
    one_line = errors.startswith(_command.PREFIX) and errors.count("\n") == 1
    bench.check(one_line and reason in errors and out in errors, f"{how}: expected one line with {reason!r}, got {errors!r}")
    bench.check((bench.folder / out / "checkpoint.h5").is_file(), f"{how}: the checkpoint is gone")
    bench.check(temporaries(bench.folder / out) == [], f"{how}: files written aside were left behind")


def file_size_limit(bench):
    """Once the first output time is written, no file may be as large as those of its particles."""
    whole_run(bench, pictures="off")
    size = (bench.folder / "A" / "particles_0000.vtu").stat().st_size
    with subprocess.Popen([bench.command, *QUIET, "--out", "E"], cwd=bench.folder, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          preexec_fn=lambda: signal.signal(signal.SIGXFSZ, signal.SIG_IGN)) as process:
        bench.check(wait_for(process, (bench.folder / "E" / "checkpoint.h5").exists, 120), "the run wrote no checkpoint")
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (size - 1, size - 1))
        _, errors = process.communicate(timeout=300)
    check_failed_write(bench, "file size limit", "E", process.returncode, errors, "File too large")
    bench.accepted(*QUIET, "--out", "E", "--resume")
    check_same(bench, "A", "E", "after the file size limit")


def mount(folder, megabytes, *options):
    folder.mkdir(exist_ok=True)
    words = ["mount", "-t", "tmpfs", "-o", ",".join([f"size={megabytes}m", *options]), "tmpfs", str(folder)]
    return shutil.which("mount") and subprocess.run(words, check=False, capture_output=True).returncode == 0


def full_disk(bench):
    """On a disk that is full after about three output times."""
    whole_run(bench, pictures="off")
    disk = bench.folder / "disk"
    if not mount(disk, 2):
        print("no disk of 2 MB can be mounted here: only the file size limit was tried")
        return
    try:
        status, _, errors = bench.call(*QUIET, "--out", "disk/F")
        check_failed_write(bench, "full disk", "disk/F", status, errors, "No space left")
        status, _, errors = bench.call(*QUIET, "--out", "disk/G") # not even room for the folder's first files
        bench.check(status in (2, 3) and errors.startswith(_command.PREFIX) and errors.count("\n") == 1,
                    f"full disk from the start: exit status {status}, stderr {errors!r}")
        shutil.rmtree(disk / "G", ignore_errors=True)
        bench.check(mount(disk, 64, "remount"), "the disk cannot be enlarged")
        bench.accepted(*QUIET, "--out", "disk/F", "--resume")
        check_same(bench, "A", "disk/F", "after the full disk")
    finally:
        subprocess.run(["umount", str(disk)], check=False)


if __name__ == "__main__":
    _command.main(__doc__, kills, interruption, two_in_one_folder, bad_checkpoints, file_size_limit, full_disk)
