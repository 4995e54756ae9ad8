#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which features of the folds does each hypothesis change? One fetal brain, each hypothesis alone, without and with the others.

Tissue labels of 23 weeks (CHN atlas: 2 cortex, 3 white matter, 5 ventricles, 7 and 9 deep) are given by --labels-file or
$CORTICLE_BRAIN_LABELS; without them there is nothing to do. Runs are made with $CORTICLE into $CORTICLE_OUT, or read with
--runs. Writes features.md and features.json beside itself, or others by --results-name.
"""

import json
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

import _atlas  # noqa: E402
import _pattern  # noqa: E402
import _runs  # noqa: E402

CASE = _runs.ROOT / "cases" / "fetal.toml"
PARTICLES = 8000
FIRST_WEEK, EARLY_WEEK, LAST_WEEK = 23, 28, 36
LABELS = {"geometry.labels": "[2,3,5,7,9]", "tissue.labels.cortex": "[2]", "tissue.labels.white": "[3]",
          "tissue.labels.deep": "[7,9]", "tissue.labels.ventricle": "[5]"}
MOST_ERROR = 0.01  # of the energy balance

SKULL = {"boundary.shape": "offset", "boundary.offset_mm": 1.5, "boundary.weeks": [23.0, 36.0], "boundary.scales": [1.0, 1.5]}
FIBRES = {"fibres.direction": "depth", "fibres.stiffness": 0.5, "fibres.active_stress": 0.2, "fibres.ramp": 1.0,
          "fibres.growth_rate": 0.2}
PROTOMAP = {"map.protomap_amplitude": 0.3, "map.protomap_wavelength_mm": 18.0}
FOLLOWS = {"stress_growth.rate": 0.3}
RELAXES = {"relaxation.share": 0.5, "relaxation.time": 1.0}
EVEN = {"growth.law": "table"}  # the table that write_even_growth makes

VARIANTS = {  # name: (what it is, settings)
    "control": ("differential growth alone", {}),
    "seed2": ("the same, another seed", {"imperfection.seed": 2}),
    "seed3": ("the same, a third", {"imperfection.seed": 3}),
    "skull": ("with a skull", SKULL),
    "fibres": ("with axonal tension", FIBRES),
    "protomap": ("with a protomap", PROTOMAP),
    "follows": ("with white matter that grows by stress", FOLLOWS),
    "relaxes": ("with tissue that relaxes", RELAXES),
    "all": ("with all five", SKULL | FIBRES | PROTOMAP | FOLLOWS | RELAXES),
    "even": ("all tissues grow alike", EVEN),
    "even_skull": ("all alike, skull", EVEN | SKULL),
    "even_fibres": ("all alike, axonal tension", EVEN | FIBRES),
    "even_protomap": ("all alike, protomap", EVEN | PROTOMAP),
    "even_all": ("all alike, all five", EVEN | SKULL | FIBRES | PROTOMAP | FOLLOWS | RELAXES),
}
SEEDS = ("control", "seed2", "seed3")
MEASURES = ("gi_hull", "fold_wavelength_mm", "sulcal_depth_mean_mm", "asymmetry_area", "cortex_thickness_mm", "length_mm",
            "volume_mm3", "area_mm2", "skull_pressure", "energy_balance_error")
FEATURES = (("hull index", "gi_hull", ".3f"), ("area mm²", "area_mm2", ".0f"), ("mean depth mm", "sulcal_depth_mean_mm", ".2f"),
            ("wavelength mm", "fold_wavelength_mm", ".1f"), ("cortex mm", "cortex_thickness_mm", ".2f"),
            ("asymmetry", "asymmetry_area", ".4f"), ("folds across length", "across_length", ".3f"),
            ("folds across width", "across_width", ".3f"), ("place, week 36", "place", ".2f"),
            ("first sulci, week 28", "early_place", ".2f"), ("sulcal area, Dice", "dice", ".3f"))


def write_even_growth(path):
    """Every tissue grows as the whole cerebrum does, in all directions: lengths by (volume of labels)^(1/3)."""
    volumes = {week: _atlas.TARGETS["volume_cm3"][week] for week in (23, 25, 27, 29, 31, 34, 36, 38)}
    lines = ["week,tissue,tangential,radial"]
    for week, volume in volumes.items():
        length = (volume / volumes[23]) ** (1 / 3)
        lines += [f"{week},{tissue},{length:.6f},{length:.6f}" for tissue in ("cortex", "white", "deep", "ventricle")]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def make_runs(arguments, base):
    base.mkdir(parents=True, exist_ok=True)
    table = base / "even_growth.csv"
    write_even_growth(table)
    shared = LABELS | {"geometry.file": Path(arguments.labels_file).resolve(), "geometry.particles": arguments.particles,
                       "time.end_week": float(LAST_WEEK), "imperfection.amplitude": 0.05, "output.pictures": "off",
                       "output.report": "off", "output.weeks": [float(week) for week in range(FIRST_WEEK + 1, LAST_WEEK)]}
    for name in arguments.variants:
        settings = shared | VARIANTS[name][1]
        if settings.get("growth.law") == "table":
            settings["growth.table"] = table.resolve()
        _runs.make_run(arguments, CASE, base / name, [f"{key}={value}" for key, value in settings.items()])


def describe(name, folder):
    rows = _runs.read_measures(folder)
    early, early_row = min(enumerate(rows), key=lambda entry: abs(entry[1]["week"] - EARLY_WEEK))
    surfaces = [_pattern.read(folder / f"surface_{number:04d}.vtp") for number in (0, early, len(rows) - 1)]
    result = {key: rows[-1][key] for key in MEASURES}
    result |= {"name": name, "week": rows[-1]["week"], "early_week": early_row["week"],
               "wall_s": _runs.read_summary(folder)["wall_s"],
               "most_intersecting": max(row["intersecting_triangles"] for row in rows)}
    across = _pattern.directions(surfaces[-1])
    result |= {"across_width": across[0], "across_length": across[1], "across_height": across[2]}
    return result, surfaces


def compare(described):
    """Adds the agreement of the folds with those of the control."""
    if "control" not in described:
        return
    _, control = described["control"]
    for name, (result, surfaces) in described.items():
        if name != "control":
            result["place"] = _pattern.agreement(control[0], control[2], surfaces[2])
            result["early_place"] = _pattern.agreement(control[0], control[1], surfaces[1])
            result["dice"] = _pattern.dice(control[2], surfaces[2])


def spread(results, key):
    values = [results[name][key] for name in SEEDS if name in results and key in results[name]]
    return (min(values), max(values)) if len(values) > 1 else None


def shown(results, name, key, form):
    """A number, bold where it lies further from the range of the seeds than this is wide, if there is a range."""
    value = results[name].get(key)
    if value is None:
        return "-"
    seeds = spread(results, key)
    far = seeds and not 2 * seeds[0] - seeds[1] <= value <= 2 * seeds[1] - seeds[0]
    text = format(value, form)
    return f"**{text}**" if far and name not in SEEDS else text


def table(results):
    columns = [("what", lambda name: VARIANTS[name][0], "")]
    columns += [(heading, lambda name, k=key, f=form: shown(results, name, k, f), "") for heading, key, form in FEATURES]
    return _runs.table(columns, list(results))


def control_table(results):
    columns = [("what", lambda r: VARIANTS[r["name"]][0], ""), ("length mm", lambda r: r["length_mm"], ".1f"),
               ("volume ml", lambda r: r["volume_mm3"] / 1000, ".1f"), ("skull pressure", lambda r: r["skull_pressure"], ".3f"),
               ("energy balance error", lambda r: r["energy_balance_error"], ".1e"),
               ("most intersecting triangles", lambda r: r["most_intersecting"], ".0f"), ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, list(results.values()))


def problems(results):
    for name, result in results.items():
        if result["energy_balance_error"] > MOST_ERROR:
            yield f"{name}: energy balance off by {result['energy_balance_error']:.4f}"
        if result["most_intersecting"]:
            yield f"{name}: {result['most_intersecting']:.0f} intersecting triangles"


def main():
    def add(parser):
        parser.add_argument("--labels-file", type=Path, default=os.environ.get("CORTICLE_BRAIN_LABELS"))
        parser.add_argument("--particles", type=int, default=PARTICLES)
        parser.add_argument("--results-name", default="features", help="of the files that are written")
        parser.add_argument("--variants", nargs="+", choices=VARIANTS, default=list(VARIANTS), help="runs to make")

    arguments = _runs.parse_arguments(__doc__, [], add)
    if not arguments.labels_file and not arguments.runs:
        print("no labels: give --labels-file or CORTICLE_BRAIN_LABELS")
        sys.exit(_runs.SKIPPED)
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/hypotheses_features")
    if not arguments.runs:
        make_runs(arguments, base)
    described = {name: describe(name, base / name) for name in VARIANTS if _runs.is_complete(base / name)}
    if not described:
        sys.exit("no complete run")
    compare(described)
    results = {name: result for name, (result, _) in described.items()}
    found = list(problems(results))
    text = ["# Features of the folds by hypothesis\n\nWritten by `features.py`; see [README.md](README.md).\n",
            f"At week {LAST_WEEK}, {arguments.particles:,} particles. Bold: further from the range of the three seeds than this "
            "is wide.\n", table(results), "## Control\n", control_table(results), "## What differs\n",
            "".join(f"- DIFFERS: {problem}\n" for problem in found) or "Nothing.\n"]
    (HERE / f"{arguments.results_name}.md").write_text("\n".join(text), encoding="utf-8")
    (HERE / f"{arguments.results_name}.json").write_text(json.dumps(results, indent=2) + "\n", encoding="utf-8")
    print("\n".join(text))
    _runs.finish(found)


main()
