#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit of the growth keys on real labels of two weeks, and what it predicts of later ones.

Labels of 23 and 28 weeks are given by --labels-file (or $CORTICLE_BRAIN_LABELS) and --fit-file. The fit and the runs are made with
$CORTICLE into $CORTICLE_OUT; made again, they go on.
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
from _atlas import TARGETS  # noqa: E402

LABELS = "[2, 3, 5, 7, 9]"
WEEKS = (28, 33, 36, 38)
# Of an atlas, in the units of measures.csv.
REAL = {key: {week: factor * TARGETS[name][week] for week in WEEKS}
        for key, name, factor in (("length_mm", "length_mm", 1), ("volume_mm3", "volume_cm3", 1000), ("area_mm2", "area_cm2", 100),
                                  ("gi_hull", "gi_hull", 1), ("sulcal_depth_mean_mm", "sulcal_depth_mean_mm", 1),
                                  ("cortex_volume_mm3", "cortex_cm3", 1000))}
POWERS = {"length_mm": 1, "volume_mm3": 3, "area_mm2": 2, "gi_hull": 0, "sulcal_depth_mean_mm": 1, "cortex_volume_mm3": 3}
BOUNDS = {"tissue.alpha_t": (2.0, 5.0, ""), "tissue.alpha_r": (0.2, 1.2, ""), "tissue.alpha_white": (0.7, 1.8, ""),
          "tissue.mu_cortex": (0.5, 2.0, 'scale = "log"\n')}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", _runs.ROOT / "build/release/bin/corticle"))
    parser.add_argument("--out", type=Path, default=os.environ.get("CORTICLE_OUT", _runs.ROOT / "runs/validation/fit_atlas"))
    parser.add_argument("--labels-file", type=Path, default=os.environ.get("CORTICLE_BRAIN_LABELS"))
    parser.add_argument("--fit-file", type=Path, default=os.environ.get("CORTICLE_BRAIN_LABELS_28"))
    parser.add_argument("--particles", type=int, default=15000)
    parser.add_argument("--points", type=int, default=28, help="runs of the design")
    parser.add_argument("--refinements", type=int, default=4, help="most rounds of four runs")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--results", type=Path, default=HERE, help="where results.md is written")
    return parser.parse_args()


def base_text(arguments):
    return f"""[geometry]
shape = "file"
file = "{Path(arguments.labels_file).resolve()}"
labels = {LABELS}
particles = {arguments.particles}

[tissue]
bulk_modulus = 10.0
labels.cortex = [2]
labels.white = [3]
labels.deep = [7, 9]
labels.ventricle = [5]

[time]
clock = "wang"
start_week = 23.0
end_week = 33.0

[output]
weeks = [25, 27, 28, 29, 31]
pictures = "off"
report = "off"
"""


def fit_text(arguments):
    lines = ['base = "base.toml"', 'title = "Fitted to 28 weeks"']
    for key, (low, high, scale) in BOUNDS.items():
        lines += ["[[parameter]]", f'key = "{key}"', f"low = {low}", f"high = {high}", scale]
    lines += ["[[target]]", f'file = "{Path(arguments.fit_file).resolve()}"', "week = 28", f"labels = {LABELS}",
              'measures = ["length_mm", "volume_mm3", "area_mm2", "gi_hull", "sulcal_depth_mean_mm"]', "relative_sd = 0.03",
              "[[target]]", 'measure = "cortex_volume_mm3"', "week = 28", f"value = {REAL['cortex_volume_mm3'][28]}", "relative_sd = 0.03"]
    for key in REAL:
        lines += ["[[predict]]", f'measure = "{key}"', "week = 33"]
    lines += ["[surrogate]", f"points = {arguments.points}", f"refinements = {arguments.refinements}", "runs_a_round = 4"]
    return "\n".join(lines) + "\n"


def make_all(arguments):
    """Folders of the fit and of the runs to 38 weeks, by name."""
    out = Path(arguments.out)
    out.mkdir(parents=True, exist_ok=True)
    for name, text in (("base.toml", base_text(arguments)), ("fit.toml", fit_text(arguments))):
        (out / name).write_text(text, encoding="utf-8")
    subprocess.run([str(Path(arguments.command).resolve()), "fit", str(out / "fit.toml"), "--out", str(out / "fit"), "--jobs",
                    str(arguments.jobs)], check=True)
    further = ["time.end_week=38.0", f"output.weeks=[{', '.join(map(str, WEEKS[:-1]))}]"]
    runs = {"fitted": ("fit/best.toml", []), "defaults": ("base.toml", []), "fetal law": ("base.toml", ['growth.law="fetal"'])}
    for name, (case, settings) in runs.items():
        _runs.make_run(arguments, out / case, out / name.replace(" ", "_"), [*further, *settings])
    return out / "fit", {name: out / name.replace(" ", "_") for name in runs}


def off(value, key, week):
    return f"{100 * (value / REAL[key][week] - 1):+.0f} %"


def trivial(key, week, known):
    """The brain of 28 weeks, scaled: by its own growth from 23 weeks on, or to the real length of that week."""
    rate = (REAL["length_mm"][28] / TARGETS["length_mm"][23]) ** (1 / 5)
    scale = REAL["length_mm"][week] / REAL["length_mm"][28] if known else rate ** (week - 28)
    return REAL[key][28] * scale ** POWERS[key]


def table(rows_of):
    lines = ["| week | prediction | " + " | ".join(f"`{key}`" for key in REAL) + " |", "|---|---|" + "---|" * len(REAL)]
    for week in WEEKS:
        for name, rows in rows_of.items():
            row = min(rows, key=lambda one: abs(one["week"] - week))
            lines.append(f"| {week} | {name} | " + " | ".join(off(row[key], key, week) for key in REAL) + " |")
        for name, known in (("28 weeks, scaled as 23 to 28 grew", False), ("28 weeks, scaled to the real length", True)):
            if week > 28:
                lines.append(f"| {week} | {name} | " + " | ".join(off(trivial(key, week, known), key, week) for key in REAL) + " |")
    return "\n".join(lines) + "\n"


def main():
    arguments = parse_arguments()
    files = (arguments.labels_file, arguments.fit_file)
    if not Path(arguments.command).is_file() or not all(file and Path(file).is_file() for file in files):
        print("no command, or no labels of 23 and 28 weeks")
        sys.exit(_runs.SKIPPED)
    fit, runs = make_all(arguments)
    text = "# Fitted on 23 and 28 weeks, beside real brains\n\nDifference from the labels of the atlas, in per cent of them.\n\n"
    text += table({name: _runs.read_measures(folder) for name, folder in runs.items()})
    answer = (fit / "fit.md").read_text(encoding="utf-8")
    text += "\n## The fit\n\n" + "\n".join(line for line in answer.splitlines() if line.startswith("| `tissue") or "| parameter |" in line
                                          or line.startswith("|---|---|---|---|---|---|---|")) + "\n"
    Path(arguments.results / "results.md").write_text(text, encoding="utf-8")
    print(text)


main()
