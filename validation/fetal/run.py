#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A real fetal brain grown from 23 to 38 weeks with three sets of parameters, beside the length law of real brains.

Tissue labels of 23 weeks are given by --labels-file or $CORTICLE_BRAIN_LABELS. Runs are made with $CORTICLE into
$CORTICLE_OUT (uniform, thinning, regional), or read with --runs.
"""

import argparse
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402

START, END = 23, 38
MOST_OVERLAP = 0.001
LEAST_RISE = 1.05 # of the hull index: sulci have formed

# Of the brain of 23 weeks, measured on a marching-cubes surface of its labels: cm³, mm, cm², area over that of the hull.
REAL_AT_START = {"volume_cm3": 63.0, "length_mm": 64.3, "area_cm2": 113.0, "gi_hull": 1.18}
LENGTH_TOLERANCE_MM = 3.0 # how well real brains from 23 to 38 weeks follow eq. 16

# Published growth of the volume: supratentorial, 48 scans of weeks 20.6 to 31.1, 15.22 % a week (Scott et al. 2011, Int. J.
# Dev. Neurosci. 29); whole brain, third trimester, 2.3 ml a day (Gong et al. 1998, Magn. Reson. Imaging 16).
RATES = {"real": (15.22, 2.3)}
EARLY, LATE = (23, 31), (28, 38)

SETS = {
    "uniform": ("cortex of 2.5 mm, as in the image, everywhere", []),
    "thinning": ("2.5 mm + 0.3 t, kept in mm while the brain lengthens",
                 ["tissue.thickness_rate_mm=0.3", "size.thin_cortex=true"]),
    "regional": ("2.5 mm; ventricles, deep grey matter and hippocampi do not grow", []),
}


def law_length(week):
    """Thesis eq. 16, Wang et al. 2019 [mm]."""
    return -0.067 * week**2 + 7.16 * week - 66.05


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", _runs.ROOT / "build/release/bin/corticle"))
    parser.add_argument("--out", type=Path, default=os.environ.get("CORTICLE_OUT", _runs.ROOT / "runs/validation/fetal"),
                        help="where runs are written")
    parser.add_argument("--runs", type=Path, help="folder of existing runs: only read, nothing is run")
    parser.add_argument("--results", type=Path, default=HERE, help="where results.md and results.json are written")
    parser.add_argument("--particles", type=int, default=60000)
    parser.add_argument("--labels-file", type=Path, default=os.environ.get("CORTICLE_BRAIN_LABELS"))
    parser.add_argument("--labels", type=int, nargs="+", default=[2, 3, 5, 7, 9], help="labels that are the body")
    parser.add_argument("--still", type=int, nargs="+", default=[5, 7, 9], help="labels that do not grow in the regional run")
    return parser.parse_args()


def region_table(arguments, folder):
    """Growth of every label: 0 of what is still, else 1."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "regions.csv"
    lines = [f"{label},{0 if label in arguments.still else 1}" for label in range(256)]
    file.write_text("\n".join(["label,growth", *lines]) + "\n", encoding="utf-8")
    return file


def make_runs(arguments):
    """The three runs; they are gone on with where they stopped."""
    file, out = Path(arguments.labels_file).resolve(), Path(arguments.out).resolve()
    labels = ",".join(map(str, arguments.labels))
    common = [f"geometry.file={file}", f"geometry.labels=[{labels}]", f"geometry.particles={arguments.particles}",
              'size.applies_to="reference"']
    for name, (_, settings) in SETS.items():
        maps = [f"map.region_file={file}", f"map.region_table={region_table(arguments, out)}"] if name == "regional" else []
        _runs.make_run(arguments, _runs.ROOT / "cases/fetal.toml", out / name, [*common, *settings, *maps])


def describe(name, folder):
    summary, rows = _runs.read_summary(folder), _runs.read_measures(folder)
    result = {key: summary[key] for key in ("version", "particles", "spacing_mm", "threads", "steps", "rejected_steps",
                                            "zero_mode_share", "onset_t", "wall_s")}
    result |= {"name": name, "what": SETS[name][0]}
    result["most_overlap"] = max(row["overlap_area_share"] for row in rows)
    result["most_penetration_in_spacings"] = max(row["max_penetration_mm"] / row["length_scale"] for row in rows) / summary["spacing_mm"]
    result["least_J"] = min(row["J_min"] for row in rows)
    result["weeks"] = [week_of(row, rows[0]) for row in rows]
    return result


def week_of(row, first):
    """One line of the tables. `law_mm` is the length of eq. 16 with this brain's length at the start."""
    similar = law_length(row["week"]) / law_length(START)
    law_mm = first["length_mm"] * similar
    to_law = law_mm / row["length_mm"]
    return {
        "week": row["week"], "length_mm": row["length_mm"], "law_mm": law_mm, "eq16_mm": law_length(row["week"]),
        "volume_cm3": row["volume_mm3"] / 1000, "area_cm2": row["area_mm2"] / 100,
        "law_volume_cm3": row["volume_mm3"] / 1000 * to_law**3, "law_area_cm2": row["area_mm2"] / 100 * to_law**2,
        "similar_volume_cm3": first["volume_mm3"] / 1000 * similar**3, "similar_area_cm2": first["area_mm2"] / 100 * similar**2,
        "gi_hull": row["gi_hull"], "gi_zilles": row["gi_zilles"], "gi_sphere": row["gi_sphere"],
        "sulcal_depth_mean_mm": row["sulcal_depth_mean_mm"], "thickness_mean_mm": row["thickness_mean_mm"],
    }


def week_table(result):
    forms = [("week", "week", ".0f"), ("length mm", "length_mm", ".1f"), ("by eq. 16", "law_mm", ".1f"),
             ("volume cm³", "volume_cm3", ".0f"), ("at that length", "law_volume_cm3", ".0f"), ("similar", "similar_volume_cm3", ".0f"),
             ("area cm²", "area_cm2", ".0f"), ("at that length", "law_area_cm2", ".0f"), ("similar", "similar_area_cm2", ".0f"),
             ("hull index", "gi_hull", ".3f"), ("Zilles", "gi_zilles", ".3f"), ("mean depth mm", "sulcal_depth_mean_mm", ".2f"),
             ("cortex mm", "thickness_mean_mm", ".2f")]
    columns = [(heading, lambda line, key=key: line[key], form) for heading, key, form in forms]
    return f"{result['what']}.\n\n" + _runs.table(columns, result["weeks"])


def start_table(results):
    """The first surface beside the real brain it was made from."""
    lines = [{"key": "real, marching cubes"} | REAL_AT_START, {"key": "body of the run"} | results[0]["weeks"][0]]
    return _runs.table([("", lambda line: line["key"], "s")] +
                       [(heading, lambda line, key=key: line[key], form) for heading, key, form in (
                           ("volume cm³", "volume_cm3", ".1f"), ("length mm", "length_mm", ".1f"), ("area cm²", "area_cm2", ".1f"),
                           ("hull index", "gi_hull", ".3f"))], lines)


def rates(result, key):
    """(% a week in the early span, ml a day in the late one) of a volume."""
    volumes = {round(line["week"]): line[key] for line in result["weeks"]}
    if not {*EARLY, *LATE} <= set(volumes):
        return None
    weekly = (volumes[EARLY[1]] / volumes[EARLY[0]]) ** (1 / (EARLY[1] - EARLY[0])) - 1
    return 100 * weekly, (volumes[LATE[1]] - volumes[LATE[0]]) / (7 * (LATE[1] - LATE[0]))


def rate_table(results):
    """Growth of the volume beside what was measured on real brains."""
    lines = [("real brains (Scott et al. 2011; Gong et al. 1998)", RATES["real"])]
    for result in results:
        lines += [(f"{result['name']}", rates(result, "volume_cm3")),
                  (f"{result['name']}, at the length of eq. 16", rates(result, "law_volume_cm3"))]
    lines.append(("eq. 16 without a change of shape", rates(results[0], "similar_volume_cm3")))
    return _runs.table([("", lambda line: line[0], "s"), ("weeks 23 to 31, % a week", lambda line: line[1][0], ".1f"),
                        ("weeks 28 to 38, ml a day", lambda line: line[1][1], ".2f")], [line for line in lines if line[1]])


def end_table(results):
    def last(key):
        return lambda result: result["weeks"][-1][key]

    def rise(key):
        return lambda result: result["weeks"][-1][key] / result["weeks"][0][key]

    def most_off(result):
        return max((line["length_mm"] - line["law_mm"] for line in result["weeks"]), key=abs)

    return _runs.table([("set", lambda r: r["name"], "s"), ("longer than eq. 16 by, at most, mm", most_off, "+.1f"),
                        ("volume x", rise("volume_cm3"), ".2f"), ("area x", rise("area_cm2"), ".2f"),
                        ("area / volume^(2/3) x", rise("gi_sphere"), ".3f"), ("hull index x", rise("gi_hull"), ".3f"),
                        ("hull index", last("gi_hull"), ".3f"), ("Zilles", last("gi_zilles"), ".3f")], results)


def findings(results):
    """What agrees and what does not, in words that follow from the numbers."""
    lines = []
    for result in results:
        weeks = result["weeks"]
        off = [line["week"] for line in weeks if abs(line["length_mm"] - line["law_mm"]) > LENGTH_TOLERANCE_MM]
        lines.append(f"- {result['name']}: length within {LENGTH_TOLERANCE_MM:g} mm of eq. 16 " +
                     ("at all weeks." if not off else f"until week {min(off) - 1:.0f}, not after."))
        surplus = weeks[-1]["area_cm2"] / weeks[0]["area_cm2"] / (weeks[-1]["volume_cm3"] / weeks[0]["volume_cm3"])**(2 / 3)
        lines.append(f"- {result['name']}: area grows {surplus:.2f} times as much as without a change of shape; the hull index "
                     f"goes from {weeks[0]['gi_hull']:.2f} to {weeks[-1]['gi_hull']:.2f}.")
    return "\n".join(lines) + "\n"


def problems(results):
    for result in results:
        for fault in _runs.faults(result, MOST_OVERLAP):
            yield f"{result['name']}: {fault}"
        rise = result["weeks"][-1]["gi_hull"] / result["weeks"][0]["gi_hull"]
        if rise < LEAST_RISE:
            yield f"{result['name']}: the hull index rises by a factor of {rise:.3f}, expected {LEAST_RISE} at least"
    for name in SETS:
        if name not in [result["name"] for result in results]:
            yield f"{name}: no complete run"


def main():
    arguments = parse_arguments()
    if not arguments.labels_file and not arguments.runs:
        print("skipped: no labels; give those of a brain of 23 weeks by --labels-file or CORTICLE_BRAIN_LABELS")
        sys.exit(_runs.SKIPPED)
    if not arguments.runs:
        make_runs(arguments)
    base = Path(arguments.runs or arguments.out)
    results = [describe(name, base / name) for name in SETS if _runs.is_complete(base / name)]
    if not results:
        sys.exit("no complete run")
    _runs.write_results(arguments.results, "A fetal brain from 23 to 38 weeks", results,
                        [("Before growth", start_table(results)), ("From 23 to 38 weeks", end_table(results)),
                         ("How fast the volume grows", rate_table(results)),
                         ("Findings", findings(results)), *((result["name"], week_table(result)) for result in results),
                         ("Controls", _runs.control_table(results))])
    _runs.finish([*problems(results)])


if __name__ == "__main__":
    main()
