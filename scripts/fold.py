#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a case and says where its results are; a run that is complete and current is not repeated."""

import argparse
import hashlib
import json
import re
import signal
import subprocess
import sys
import tomllib
from pathlib import Path

# key of summary.json, how to print it
MEASURES = (
    ("method", "{}"),
    ("particles", "{}"),
    ("elements", "{}"),
    ("t", "{:.3g}"),
    ("steps", "{}"),
    ("wall_s", "{:.1f} s"),
    ("area_ratio", "{:.4f}"),
    ("volume_ratio", "{:.4f}"),
    ("gi_hull", "{:.4f}"),
    ("gi_sphere", "{:.4f}"),
    ("onset_t", "{:.3f}"),
    ("J_min", "{:.4f}"),
    ("J_max", "{:.4f}"),
    ("overlap_area_share", "{:.2e}"),
    ("peak_memory_mb", "{:.0f} MB"),
)


def files_of(case):
    """Every file that the case names, with the key that does: surface, image and maps."""
    for section, keys in tomllib.loads(case.read_text(encoding="utf-8")).items():
        for key, value in keys.items() if isinstance(keys, dict) else ():
            if isinstance(value, str) and value and (path := case.parent / value).is_file():
                yield f"{section}.{key}", path


def fingerprint(command, case):
    """What the results depend on, by content: the command, the case and the files it names."""
    digest = hashlib.sha256()
    mesher = command.parent / "corticle-tetrahedralize"
    programs = [("command", command), *([("mesher", mesher)] if mesher.is_file() else [])]
    for key, path in (*programs, ("case", case), *files_of(case)):
        digest.update(f"{key} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return digest.hexdigest()


def status_of(out):
    try:
        return json.loads((out / "summary.json").read_text(encoding="utf-8")).get("status")
    except (OSError, ValueError, AttributeError):
        return None


class Stamp:
    """What `make fold` knows of a run that it began: the fingerprint of its inputs and, once the run has ended, that of
    the case in its folder, which tells it from a run that somebody else put there."""

    def __init__(self, out):
        self.out = out
        self.file = out.parent / f".{out.name}.fold"
        lines = self.file.read_text(encoding="utf-8", errors="replace").splitlines() if self.file.is_file() else []
        if self.file.exists() and not (1 <= len(lines) <= 2 and all(re.fullmatch("[0-9a-f]{64}", line) for line in lines)):
            print(f"fold: {self.file} is not of make fold; move it elsewhere", file=sys.stderr)
            sys.exit(2)
        self.inputs, self.case = (lines + [None, None])[:2]

    def case_there(self):
        case = self.out / "case.toml"
        return hashlib.sha256(case.read_bytes()).hexdigest() if case.is_file() else None

    def is_of_folder(self):
        """Whether the run in the folder is the one that was begun."""
        return self.inputs is not None and self.case == self.case_there()

    def begin(self, inputs):
        self.file.write_text(f"{inputs}\n", encoding="utf-8")

    def end(self, inputs):
        case = self.case_there()
        self.file.write_text(f"{inputs}\n" + (f"{case}\n" if case else ""), encoding="utf-8")


def arguments_for(stamp, now, out):
    """How the run is to be made; None where it is there. What `make fold` did not begin is never overwritten."""
    if stamp.is_of_folder() and stamp.inputs == now and status_of(out) == "completed":
        return None
    began = stamp.inputs == now and stamp.case in (None, stamp.case_there())
    if began and (out / "checkpoint.h5").is_file():
        return ["--resume"]
    return ["--overwrite"] if began or stamp.is_of_folder() else []


def wait_for(run):
    """Passes on what asks the run to end; the run writes its checkpoint before it does."""
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU):
        signal.signal(number, lambda caught, _frame: run.send_signal(caught))
    while True:
        try:
            return run.wait()
        except KeyboardInterrupt:  # has reached the run too
            continue


def fold(command, case, out):
    """Runs the command unless the run folder holds this very run; returns the exit status, and whether it did."""
    stamp = Stamp(out)
    now = fingerprint(command, case)
    how = arguments_for(stamp, now, out)
    if how is None:
        print(f"{out} is complete and current (remove it to fold again)")
        return 0, True
    arguments = [str(command), "run", str(case), "--out", str(out), *how]
    out.parent.mkdir(parents=True, exist_ok=True)
    is_there = (out / "case.toml").exists()
    if how or not is_there:
        stamp.begin(now)
    print(" ".join(arguments), flush=True)
    with subprocess.Popen(arguments) as run:
        status = wait_for(run)
    if how or not is_there:
        stamp.end(now)
    elif status == 2:
        print(f"fold: what {out} holds is not of make fold; choose another folder (make fold OUT=...)", file=sys.stderr)
    return status, False


def report(out, is_old):
    """Prints where to look, and of a run that was there already the measures, with which the command ends itself."""
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    if is_old:
        print(f"\n{out}: {summary.get('status', 'status unknown')}")
    for key, form in MEASURES if is_old else ():
        value = summary.get(key)
        if value is not None:
            print(f"  {key:<20}{form.format(value)}")
    print("look at")
    for pattern in ("report.html", "pictures/*.png", "surface.pvd", "particles.pvd", "measures.csv", "summary.json", "run.log"):
        found = sorted(out.glob(pattern))
        if len(found) > 3:
            print(f"  {found[0]} … {found[-1].name} ({len(found)} files)")
        else:
            for path in found:
                print(f"  {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", type=Path, required=True)
    parser.add_argument("--case", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    for path in (arguments.command, arguments.case):
        if not path.is_file():
            sys.exit(f"fold: there is no file {path}")
    try:
        status, is_old = fold(arguments.command, arguments.case, arguments.out)
    except KeyboardInterrupt:
        sys.exit(130)
    if (arguments.out / "summary.json").is_file():
        report(arguments.out, is_old)
    sys.exit(status)


main()
