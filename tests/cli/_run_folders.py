# SPDX-License-Identifier: GPL-3.0-or-later
"""Run folders read and compared file by file, and ways to stop a run."""

import csv
import json
import time

# Figures of the machine, not of the body.
VOLATILE = {"wall_s", "us_per_particle_step", "ns_per_element_step", "peak_memory_mb", "internal_forces_s", "contact_s", "measures_s", "output_s"}


def temporaries(folder):
    """Files written aside and not yet renamed."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob(".*.tmp"))


def measure_rows(folder):
    """Rows of measures.csv, numbers by key; the units of the header are left out."""
    with open(folder / "measures.csv", encoding="utf-8", newline="") as stream:
        return [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]


def contents(folder, volatile):
    """name -> what has to agree: the bytes, and of summary.json all keys but the volatile."""
    left_out = {"run.log", "report.html", *temporaries(folder)}  # both tell of wall times
    found = {}
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = str(path.relative_to(folder))
        if name == "summary.json":
            found[name] = {k: v for k, v in json.loads(path.read_text(encoding="utf-8")).items() if k not in volatile}
        elif name not in left_out:
            found[name] = path.read_bytes()
    return found


def check_same(bench, expected, got, how, also_volatile=()):
    """Both run folders hold the same files with the same content."""
    volatile = VOLATILE | set(also_volatile)
    a, b = (contents(bench.folder / folder, volatile) for folder in (expected, got))
    bench.check(a, f"{how}: nothing to compare in {expected}")
    bench.check(a.keys() == b.keys(), f"{how}: files differ: {sorted(a.keys() ^ b.keys())}")
    for name in sorted(a.keys() & b.keys()):
        bench.check(a[name] == b[name], f"{how}: {name} differs")


def wait_for(process, condition, seconds):
    """True once the condition holds; False when the process ended first or the time ran out."""
    deadline = time.monotonic() + seconds
    while process.poll() is None and time.monotonic() < deadline:
        if condition():
            return True
        time.sleep(0.001)
    return False


def stop(process, number, seconds=120):
    """Sends the signal; (exit status, stderr)."""
    if process.poll() is None:
        process.send_signal(number)
    try:
        _, errors = process.communicate(timeout=seconds)
    except Exception:
        process.kill()
        process.communicate()
        raise
    return process.returncode, errors
