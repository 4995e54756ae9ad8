#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a case and says where its results are; a run that is complete and current is not repeated."""

import argparse
import hashlib
import json
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
    for key, path in (("command", command), ("case", case), *files_of(case)):
        digest.update(f"{key} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return digest.hexdigest()


def status_of(out):
    try:
        return json.loads((out / "summary.json").read_text(encoding="utf-8")).get("status")
    except (OSError, ValueError, AttributeError):
        return None


def fold(command, case, out):
    """Runs the command unless the run folder holds this very run; returns the exit status."""
    stamp = out.parent / f".{out.name}.sha256"
    now = fingerprint(command, case)
    same = stamp.is_file() and stamp.read_text(encoding="utf-8").strip() == now
    if same and status_of(out) == "completed":
        print(f"{out} is complete and current (remove it to fold again)")
        return 0
    arguments = [str(command), "run", str(case), "--out", str(out)]
    if same and (out / "checkpoint.h5").is_file():
        arguments.append("--resume")
    elif (out / "case.toml").is_file():
        arguments.append("--overwrite")
    out.parent.mkdir(parents=True, exist_ok=True)
    stamp.write_text(now + "\n", encoding="utf-8")
    print(" ".join(arguments), flush=True)
    with subprocess.Popen(arguments) as run:
        while True:  # an interrupt reaches the command too, which writes its checkpoint before it ends
            try:
                return run.wait()
            except KeyboardInterrupt:
                continue


def report(out):
    """Prints the headline measures and where to look."""
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    print(f"\n{out}: {summary.get('status', 'status unknown')}")
    for key, form in MEASURES:
        value = summary.get(key)
        if value is not None:
            print(f"  {key:<20}{form.format(value)}")
    print("look at")
    for pattern in ("pictures/*.png", "surface.pvd", "particles.pvd", "measures.csv", "summary.json", "run.log"):
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
        status = fold(arguments.command, arguments.case, arguments.out)
    except KeyboardInterrupt:
        sys.exit(130)
    if (arguments.out / "summary.json").is_file():
        report(arguments.out)
    sys.exit(status)


main()
