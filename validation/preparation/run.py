#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's pre-processing on the standard sphere and on a brain: how far from the exact answer, beside ours.

The brain's surface is given by --surface or $CORTICLE_BRAIN_SURFACE. Bodies are prepared with $CORTICLE into $CORTICLE_OUT
(sphere, brain), or read with --runs. The figures are those that `corticle prepare --compare-thesis` finds; nothing is
computed here.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402

# Name, case, number of particles, and what is compared there.
BODIES = [("sphere", "sphere.toml", 45000), ("brain", "brain.toml", 60000)]
PICTURES = ("normals", "volumes", "layer")

MOST_SUM_ERROR = 1e-9      # of volumes: both ways sum to the enclosed volume
MOST_RMS_ERROR = 0.03      # of our volumes: the lattice of lines is finite
MOST_NORMAL_DEG = 0.2      # of our normals in the cortex of the sphere, mean
MOST_LAYER_ERROR = 0.001   # of our cortex's share of the volume
MOST_DEPTH_SPACINGS = 0.02 # of our distances: triangles stand off the sphere
LEAST_FACTOR = 2.0         # by which the thesis's errors exceed ours

HEADINGS = {
    "normals": ("Angle between the normals and the exact ones",
                [("mean deg", "mean_deg", ".2f"), ("95 % deg", "percentile_95_deg", ".2f"),
                 ("largest deg", "largest_deg", ".1f"), ("mean in cortex deg", "mean_in_cortex_deg", ".2f")]),
    "volumes": ("Volumes of the particles over the exact ones",
                [("sum, error", "sum_error", ".0e"), ("rms error", "rms_error", ".3f"),
                 ("largest error", "largest_error", ".2f"), ("on the surface", "surface_ratio", ".3f"),
                 ("below it", "below_ratio", ".3f"), ("deep", "deep_ratio", ".3f")]),
    "depths": ("Distance to the surface", [("mean error mm", "mean_mm", ".4f"), ("largest error mm", "largest_mm", ".4f")]),
    "layers": ("The cortex", [("share of the volume", "cortex_share", ".4f"), ("misassigned share", "misassigned_share", ".4f")]),
    "clouds": ("Regularity of the cloud, distances in spacings",
               [("closest pair", "closest_pair", ".3f"), ("nearest, mean", "nearest_mean", ".3f"),
                ("nearest, variation", "nearest_variation", ".3f"), ("density, variation", "neighbors_variation", ".3f"),
                ("fewest neighbours", "fewest_neighbors", ".0f"), ("worst condition", "worst_condition", ".1f")])}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", _runs.ROOT / "build/release/bin/corticle"))
    parser.add_argument("--out", type=Path, default=os.environ.get("CORTICLE_OUT", _runs.ROOT / "runs/validation/preparation"))
    parser.add_argument("--runs", type=Path, help="folder of bodies prepared before: only read")
    parser.add_argument("--surface", type=Path, default=os.environ.get("CORTICLE_BRAIN_SURFACE"))
    return parser.parse_args()


def prepare(arguments, case, folder, settings):
    words = [str(Path(arguments.command).resolve()), "prepare", str(_runs.ROOT / "cases" / case), "--out", str(folder),
             "--compare-thesis"]
    words += [word for setting in settings for word in ("--set", setting)]
    print(" ".join(words), flush=True)
    subprocess.run(words, check=False)


def compared(arguments):
    """(name, comparison, folder) of every body that could be prepared."""
    base = arguments.runs or Path(arguments.out)
    for name, case, particles in BODIES:
        folder = base / name
        if not arguments.runs:
            settings = [f"geometry.particles={particles}"]
            if name == "brain":
                if not arguments.surface:
                    print("no brain: give a closed surface by --surface or CORTICLE_BRAIN_SURFACE")
                    continue
                settings.append(f"geometry.file={Path(arguments.surface).resolve()}")
            shutil.rmtree(folder, ignore_errors=True)
            prepare(arguments, case, folder, settings)
        report = folder / "preparation.json"
        if not report.is_file():
            print(f"{folder}: no prepared body, left out")
            continue
        yield name, json.loads(report.read_text(encoding="utf-8"))["thesis_comparison"], folder


def section(name, comparison, key):
    """(heading, table) of one kind of error on one body."""
    heading, columns = HEADINGS[key]

    def of(field):
        return lambda row: row[field]

    table = _runs.table([("choice", of("choice"), "s"), *((title, of(field), form) for title, field, form in columns)],
                        comparison[key])
    table = table.replace("| ---: |", "| --- |", 1) # the first column holds words
    return f"{name.capitalize()}: {heading[0].lower()}{heading[1:]}", table


def differences(name, comparison):
    """What is not as it should be."""
    def bounded(what, value, most):
        if not value <= most:
            yield f"{name}: {what} is {value}, expected at most {most}"

    ours = {key: comparison[key][1 if key == "layers" else 0] for key in HEADINGS}
    thesis = {key: comparison[key][2 if key in ("normals", "layers") else 1] for key in HEADINGS}
    for row in comparison["volumes"]:
        yield from bounded(f"sum of volumes, {row['choice']}", abs(row["sum_error"]), MOST_SUM_ERROR)
    yield from bounded("error of our volumes", ours["volumes"]["rms_error"], MOST_RMS_ERROR)
    exact_share = comparison["layers"][0]["cortex_share"]
    yield from bounded("error of our cortex's volume", abs(ours["layers"]["cortex_share"] - exact_share), MOST_LAYER_ERROR)
    yield from bounded("error of our distances in spacings", ours["depths"]["largest_mm"] / comparison["spacing_mm"],
                       MOST_DEPTH_SPACINGS)
    if comparison["reference"] == "sphere":
        yield from bounded("error of our normals in the cortex", ours["normals"]["mean_in_cortex_deg"], MOST_NORMAL_DEG)
    for key, field in (("normals", "mean_deg"), ("volumes", "rms_error"), ("depths", "largest_mm"),
                       ("clouds", "neighbors_variation")):
        yield from bounded(f"{LEAST_FACTOR} times our {field} of the {key}", LEAST_FACTOR * ours[key][field],
                           thesis[key][field])


def copy_pictures(name, folder):
    target = HERE / "pictures"
    target.mkdir(exist_ok=True)
    for picture in PICTURES:
        source = folder / "pictures" / f"thesis_{picture}.png"
        if source.is_file():
            shutil.copyfile(source, target / f"{name}_{picture}.png")


def main():
    arguments = parse_arguments()
    found = list(compared(arguments))
    if not found:
        sys.exit("nothing could be prepared")
    sections = [section(name, comparison, key) for name, comparison, _ in found for key in HEADINGS]
    if len(found) == len(BODIES):
        _runs.write_results(HERE, "The thesis's pre-processing, the exact answer, and ours",
                            {name: comparison for name, comparison, _ in found}, sections)
        for name, _, folder in found:
            copy_pictures(name, folder)
    else: # results of one body alone do not replace those of both
        print("\n".join(f"## {heading}\n\n{table}" for heading, table in sections))
    problems = [problem for name, comparison, _ in found for problem in differences(name, comparison)]
    expected = len(BODIES) - (0 if arguments.surface or arguments.runs else 1)
    _runs.finish([*problems, *([f"{expected - len(found)} bodies could not be prepared"] if len(found) < expected else [])])


main()
