#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each sweep of cases/thesis, small: two places on each axis, few particles, a short time."""

import csv
import json
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import _command  # noqa: E402

PLACES = 2
# Particles and end of the corrected runs, and of the printed ones: these take a fixed step, and their kernels of 3 mm find
# too few neighbours among 600.
SMALL = ((600, 900), 0.02)
SMALL_PRINTED = ((1500, 2000), 0.004)


def is_printed(sweep):
    return "printed" in sweep["base"]


def toml(value):
    """A value as TOML; tables inline."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def places(axis):
    """First and last value of an axis."""
    if "values" in axis:
        values = axis["values"]
        return [values[0], values[-1]] if len(values) > PLACES else values
    return [axis["start"], axis["stop"]]


def small_axis(axis, particles):
    kept = {key: axis[key] for key in ("key", "zip") if key in axis}
    kept["values"] = list(particles) if axis["key"] == "geometry.particles" else places(axis)
    if "names" in axis:
        kept["names"] = places({"values": axis["names"]})
    return kept


def small(sweep, directory):
    """The sweep with its base, measures and plots, but few values."""
    particles, _ = SMALL_PRINTED if is_printed(sweep) else SMALL
    axes = [small_axis(axis, particles) for axis in sweep["axis"]]
    lines = {key: sweep[key] for key in ("title", "measures", "plots", "line") if key in sweep}
    lines["base"] = str((directory / sweep["base"]).resolve())
    lines["reference"] = "none" if sweep.get("reference") == "none" else 1
    lines["axis"] = axes
    return "".join(f"{key} = {toml(value)}\n" for key, value in lines.items())


def settings(sweep):
    chosen = {f"{section}.{key}": value for section, keys in sweep.get("set", {}).items() for key, value in keys.items()}
    chosen.pop("output.times", None)
    particles, end = SMALL_PRINTED if is_printed(sweep) else SMALL
    chosen |= {"time.end": end, "output.count": 2, "output.pictures": "off"}
    if all(axis["key"] != "geometry.particles" for axis in sweep["axis"]):
        chosen["geometry.particles"] = particles[0]
    return [word for key, value in chosen.items() for word in ("--set", f"{key}={toml(value)}")]


def sweep_test(file):
    def test(bench):
        sweep = tomllib.loads(file.read_text(encoding="utf-8"))
        bench.accepted("sweep", file, "--list", "--out", "none")
        bench.write("small.toml", small(sweep, file.parent))
        bench.accepted("sweep", "small.toml", "--out", "small", *settings(sweep))
        with open(bench.folder / "small/sweep.csv", encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(stream))
        expected = PLACES ** len({axis.get("zip", axis["key"]) for axis in sweep["axis"]})
        bench.check(len(rows) == expected, f"{file.stem}: {len(rows)} runs, expected {expected}")
        _, end = SMALL_PRINTED if is_printed(sweep) else SMALL
        for row in rows:
            if is_printed(sweep) and "inverted" in row["reason"]:  # as its equations let them
                bench.check(0 < float(row["t"]) < end and int(row["steps"]) > 0, f"{file.stem}: {row}")
            elif not bench.check(row["status"] == "completed" and float(row["t"]) == end, f"{file.stem}: {row}"):
                continue
            for measure in sweep["measures"]:
                late = "@" in measure or measure == "onset_t"  # not in so short a run
                bench.check(late or row[measure] != "", f"{file.stem}: no {measure} in {row['name']}")
        text = (bench.folder / "small/sweep.md").read_text(encoding="utf-8")
        bench.check(sweep["title"] in text.replace("\\", ""), f"{file.stem}: sweep.md has no title")

    return test


def sweep_files(source):
    files = sorted((source / "cases/thesis").glob("*.toml"))
    return [file for file in files if "base" in tomllib.loads(file.read_text(encoding="utf-8"))]


if __name__ == "__main__":
    here = Path(__file__).resolve().parents[2]
    chosen = Path(sys.argv[sys.argv.index("--source") + 1]).resolve() if "--source" in sys.argv[:-1] else here
    _command.main(__doc__, *map(sweep_test, sweep_files(chosen)))
