#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A real fetal brain grown to 38 weeks by the fetal growth law, beside real brains week by week.

Tissue labels of a start week are given by --labels-file (or $CORTICLE_BRAIN_LABELS) and --week; later brains, for where the
folds are, by --later FILE@WEEK. The run is made with $CORTICLE into $CORTICLE_OUT, or read with --runs.
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402
from _atlas import TARGETS  # noqa: E402

MOST_OVERLAP = 0.001

WEEKS = (25, 27, 28, 29, 31, 33, 34, 36, 38)
# How near a grown brain is to come: (heading, key, tolerance, whether in per cent).
WANTED = (("length mm", "length_mm", 4, True), ("volume cm³", "volume_cm3", 7, True), ("area cm²", "area_cm2", 8, True),
          ("hull index", "gi_hull", 0.06, False), ("cortex cm³", "cortex_cm3", 10, True),
          ("thickness mm", "cortex_thickness_mm", 0.3, False), ("mean depth mm", "sulcal_depth_mean_mm", None, True))
# Of individuals (normative curves of King's College, SVRTK), w in weeks: mean and standard deviation.
NORMS = {"cortex_cm3": (lambda w: 0.3052 * w**2 - 11.828 * w + 123, lambda w: 0.01647 * w**2 - 0.477 * w + 3.769),
         "length_mm": (lambda w: -0.0781 * w**2 + 7.7234 * w - 75.3, lambda w: 0.1277 * w - 0.93)}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", _runs.ROOT / "build/release/bin/corticle"))
    parser.add_argument("--out", type=Path, default=os.environ.get("CORTICLE_OUT", _runs.ROOT / "runs/validation/fetal"),
                        help="where the run is written")
    parser.add_argument("--runs", type=Path, help="folder of an existing run: only read, nothing is run")
    parser.add_argument("--results", type=Path, default=HERE, help="where results.md and results.json are written")
    parser.add_argument("--particles", type=int, default=120000)
    parser.add_argument("--labels-file", type=Path, default=os.environ.get("CORTICLE_BRAIN_LABELS"))
    parser.add_argument("--week", type=float, default=23, help="of the labels")
    parser.add_argument("--labels", default="2,3,5,7,9", help="labels that are the body")
    for tissue, default in (("cortex", "2"), ("white", "3"), ("deep", "7,9"), ("ventricle", "5")):
        parser.add_argument(f"--{tissue}", default=default, help="labels of that tissue")
    parser.add_argument("--later", nargs="*", default=[], help="labels of later brains, FILE@WEEK")
    return parser.parse_args()


def make_run(arguments):
    settings = [f"geometry.file={Path(arguments.labels_file).resolve()}", f"geometry.labels=[{arguments.labels}]",
                f"geometry.particles={arguments.particles}", f"time.start_week={float(arguments.week)}"]
    settings += [f"tissue.labels.{tissue}=[{getattr(arguments, tissue)}]" for tissue in ("cortex", "white", "deep", "ventricle")]
    weeks = [float(week) for week in range(20, 38) if week > arguments.week]
    _runs.make_run(arguments, _runs.ROOT / "cases/fetal.toml", Path(arguments.out), [*settings, f"output.weeks={weeks}"])


def real(key, week):
    """Of real brains at a week, linear between those measured."""
    known = sorted(TARGETS[key].items())
    for (a, low), (b, high) in zip(known, known[1:]):
        if a <= week <= b:
            return low + (high - low) * (week - a) / (b - a)
    return None


def describe(folder):
    summary, rows = _runs.read_summary(folder), _runs.read_measures(folder)
    result = {key: summary[key] for key in ("version", "particles", "spacing_mm", "threads", "steps", "rejected_steps",
                                            "zero_mode_share", "onset_t", "wall_s")}
    result |= {"most_overlap": max(row["overlap_area_share"] for row in rows), "least_J": min(row["J_min"] for row in rows),
               "most_intersecting": max(row["intersecting_triangles"] for row in rows),
               "most_penetration_in_spacings": max(row["max_penetration_mm"] for row in rows) / summary["spacing_mm"]}
    result["weeks"] = [{"week": row["week"], "volume_cm3": row["volume_mm3"] / 1000, "area_cm2": row["area_mm2"] / 100,
                        "cortex_cm3": row["cortex_volume_mm3"] / 1000,
                        **{key: row[key] for key in ("length_mm", "gi_hull", "sulcal_depth_mean_mm", "cortex_thickness_mm")}}
                       for row in rows]
    return result


def difference(line, key, is_percent):
    wanted = real(key, line["week"])
    if wanted is None:
        return None
    return 100 * (line[key] / wanted - 1) if is_percent else line[key] - wanted


def shown(line, key, tolerance, is_percent):
    got = difference(line, key, is_percent)
    if got is None:
        return f"{line[key]:.3g}"
    text = f"{line[key]:.4g} ({got:+.1f} %)" if is_percent else f"{line[key]:.3f} ({got:+.3f})"
    return f"**{text}**" if tolerance is not None and abs(got) > tolerance else text


def week_table(result):
    lines = [line for line in result["weeks"] if round(line["week"]) in WEEKS or line is result["weeks"][0]]
    columns = [("week", lambda line: f"{line['week']:.0f}", "s")]
    columns += [(heading, lambda line, k=key, t=tolerance, p=percent: shown(line, k, t, p), "s")
                for heading, key, tolerance, percent in WANTED]
    limits = ", ".join(f"{heading.split(' ')[0]} {tolerance:g}{' %' if percent else ''}" for heading, _, tolerance, percent in WANTED
                       if tolerance is not None)
    return f"Run (run less real). Bold: outside the tolerance ({limits}).\n\n" + _runs.table(columns, lines)


def norm_table(result):
    """How many standard deviations of individuals the run is from their mean."""
    columns = [("week", lambda line: f"{line['week']:.0f}", "s")]
    columns += [(key, lambda line, m=mean, s=deviation, k=key: (line[k] - m(line["week"])) / s(line["week"]), "+.1f")
                for key, (mean, deviation) in NORMS.items()]
    return _runs.table(columns, [line for line in result["weeks"] if round(line["week"]) in WEEKS])


def patterns(arguments, folder):
    """Scores of where the folds are, by real brain; [] without later brains."""
    if not arguments.later:
        return []
    words = [str(arguments.command), "compare", str(folder), *arguments.later, "--labels", arguments.labels, "--json",
             "--out", f"{Path(arguments.out)}_and_real", "--overwrite"]
    done = subprocess.run(words, check=True, capture_output=True, text=True)
    return [{"name": f"week {entry['week']:g}", **entry["pattern"]} for entry in json.loads(done.stdout)["reals"] if "pattern" in entry]


def pattern_table(found):
    lines = [{"brain": entry["name"], "pattern": name, **scores} for entry in found for name, scores in entry["scores"].items()]
    keys = ("depth_partial", "curvature_partial", "sulcal_dice", "pits_within_5mm", "pits_within_10mm")
    columns = [("real brain", lambda line: line["brain"], "s"), ("pattern", lambda line: line["pattern"], "s")]
    return _runs.table(columns + [(key, lambda line, k=key: line[k], ".3f") for key in keys], lines)


def problems(result):
    yield from _runs.faults(result, MOST_OVERLAP)
    if result["most_intersecting"] > 0:
        yield f"{result['most_intersecting']:.0f} intersecting triangles"
    for line in result["weeks"]:
        for heading, key, tolerance, is_percent in WANTED:
            got = difference(line, key, is_percent)
            if tolerance is not None and got is not None and round(line["week"]) in WEEKS and abs(got) > tolerance:
                yield f"week {line['week']:.0f}: {heading} differs by {got:+.3g}{' %' if is_percent else ''}"


def main():
    arguments = parse_arguments()
    if not arguments.labels_file and not arguments.runs:
        print("skipped: no labels; give those of a fetal brain by --labels-file or CORTICLE_BRAIN_LABELS")
        sys.exit(_runs.SKIPPED)
    if not arguments.runs:
        make_run(arguments)
    folder = Path(arguments.runs or arguments.out)
    if not _runs.is_complete(folder):
        sys.exit("no complete run")
    result = describe(folder)
    sections = [("Week by week", week_table(result)), ("Standard deviations of individuals", norm_table(result))]
    found = patterns(arguments, folder)
    if found:
        result["patterns"] = found
        sections.append(("Where the folds are", pattern_table(found)))
    sections.append(("Controls", _runs.control_table([result])))
    _runs.write_results(arguments.results, f"A fetal brain from {result['weeks'][0]['week']:.0f} to 38 weeks", [result], sections)
    _runs.finish([*problems(result)])


if __name__ == "__main__":
    main()
