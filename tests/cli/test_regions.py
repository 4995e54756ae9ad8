# SPDX-License-Identifier: GPL-3.0-or-later
"""`corticle regions`: growth of regions found again from the areas of a run; `corticle measure --regions`; what is refused."""

import csv
import json

import _command

GROWTH = {1: 1.4, 2: 0.7, 3: 1.0, 4: 1.2, 11: 0.8, 12: 1.1, 13: 1.3, 14: 0.9}
CHANGES = ('\n[map]\nregion_file = "brain_lobes.nii.gz"\nregion_table = "start.csv"\n[time]\nend = 0.15\n')


def table(column, values):
    return f"label,{column}\n" + "".join(f"{label},{value}\n" for label, value in values.items())


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return {int(row["label"]): row for row in csv.DictReader(stream)}


def prepared(bench):
    bench.accepted("new", "brain")
    case = (bench.folder / "brain.toml").read_text()
    for old, new in (("particles = 60000", "particles = 2500"), ("count = 10", 'count = 1\npictures = "off"\nreport = "off"')):
        bench.check(old in case, f"brain.toml lacks {old}")
        case = case.replace(old, new)
    bench.write("case.toml", case + CHANGES)
    bench.write("start.csv", table("growth", {0: 1.0, **dict.fromkeys(GROWTH, 1.0)}))
    bench.write("truth.csv", table("growth", {0: 1.0, **GROWTH}))


def twin(bench):
    """Areas of a run with known growth are reached, and with them that growth."""
    prepared(bench)
    # The areas that this growth makes are in the table of a search that stops at once.
    bench.write("any.csv", table("area_mm2", dict.fromkeys(GROWTH, 1000.0)))
    bench.accepted("regions", "case.toml", "--areas", "any.csv", "--set", 'map.region_table="truth.csv"', "--rounds", "1", "--out", "truth")
    areas = {label: float(row["area_mm2"]) for label, row in rows_of(bench.folder / "truth" / "regions.csv").items()}
    bench.write("areas.csv", table("area_mm2", areas))
    call = ("regions", "case.toml", "--areas", "areas.csv", "--out", "found", "--rounds", "6", "--tolerance", "0.03")
    said = bench.accepted(*call)
    found = rows_of(bench.folder / "found" / "growth.csv")
    for label, growth in GROWTH.items():
        got = float(found[label]["growth"])
        bench.check(abs(got / growth - 1.0) < 0.15, f"region {label}: growth {got}, truth {growth}")
    bench.check(float(found[0]["growth"]) == 1.0, "a region without an area changed")
    result = json.loads((bench.folder / "found" / "regions.json").read_text())
    last = result["rounds"][result["best_round"] - 1]
    bench.check(last["largest_error"] <= 0.03, f"areas off by {last}")
    bench.check(result["rounds"][0]["mean_error"] > 3 * last["mean_error"], f"rounds {result['rounds']}")
    text = (bench.folder / "found" / "regions.md").read_text()
    bench.check(said.count("round") == len(result["rounds"]), f"said {said!r}")
    bench.accepted("run", "found/best.toml", "--out", "later", "--set", "time.end=0.2", "--quiet")

    runs = sorted((bench.folder / "found" / "runs").iterdir())
    times = [path.stat().st_mtime_ns for run in runs for path in run.iterdir()]
    bench.accepted(*call)
    bench.check(times == [path.stat().st_mtime_ns for run in runs for path in run.iterdir()], "again: a finished run was made again")
    bench.check((bench.folder / "found" / "regions.md").read_text() == text, "again: another regions.md")
    areas[1] *= 1.1
    bench.write("areas.csv", table("area_mm2", areas))
    bench.accepted("regions", "case.toml", "--areas", "areas.csv", "--out", "found", "--rounds", "2", "--quiet")
    bench.check(sorted((bench.folder / "found" / "runs").iterdir()) != runs, "other areas: the runs of the earlier ones were taken")


def measured(bench):
    """Regions of a label volume make up its surface."""
    bench.accepted("new", "brain")
    rows = json.loads(bench.accepted("measure", "brain.nii.gz", "--labels", "2,3,5,7", "--regions", "brain_lobes.nii.gz", "--areas",
                                     "lobes.csv", "--json"))
    areas = {key: value for key, value in rows.items() if key.startswith("region_")}
    bench.check(abs(sum(areas.values()) / rows["area_mm2"] - 1.0) < 1e-9, f"areas {areas} of {rows['area_mm2']}")
    table_rows = rows_of(bench.folder / "lobes.csv")
    bench.check(set(table_rows) == set(GROWTH), f"labels {sorted(table_rows)}")
    for label, row in table_rows.items():
        bench.check(float(row["area_mm2"]) == areas[f"region_{label}_area_mm2"], f"region {label}: {row}")
    left, right = (sum(float(row["area_mm2"]) for label, row in table_rows.items() if (label > 10) == side) for side in (False, True))
    bench.check(abs(left / right - 1.0) < 0.05, f"left {left}, right {right}")


def refusals(bench):
    prepared(bench)
    bench.write("areas.csv", table("area_mm2", dict.fromkeys(GROWTH, 1000.0)))
    bench.write("lobes.csv", "mine")
    bench.write("later/run.log", "mine")
    bench.write("later/regions.md", "mine")
    bench.refused(["measure", "brain.nii.gz", "--labels", "2,3,5,7", "--areas", "other.csv"], ["--areas", "without --regions"])
    bench.refused(["measure", "brain.nii.gz", "--labels", "2,3,5,7", "--regions", "brain_lobes.nii.gz", "--areas", "lobes.csv"],
                  ["lobes.csv", "is there already"])
    call = ["regions", "case.toml", "--areas", "areas.csv", "--out", "none"]
    bench.refused(call + ["--set", 'map.region_table=""'], ["map.region_table", "expected both"])
    bench.refused(call + ["--set", 'map.region_file=""', "--set", 'map.region_table=""'], ["map.region_file", "not given"])
    for text, parts in (("label,area\n1,20\n", ["no column area_mm2"]), ("label,area_mm2\n1,0\n", ["label 1 has 0 mm2"]),
                        ("label,area_mm2\n99,5\n", ["label 99", "map.region_table"]), ("label,area_mm2\n1,x\n", ["bad.csv:2", "finite"])):
        bench.write("bad.csv", text)
        bench.refused(["regions", "case.toml", "--areas", "bad.csv", "--out", "none"], parts)
    bench.refused(["regions", "case.toml", "--areas", "no_such.csv", "--out", "none"], ["no_such.csv"])
    bench.refused(["regions", "case.toml", "--areas", "areas.csv", "--out", "later"], ["later", "regions.md"])
    bench.refused(call + ["--week", "28"], ["end_week"])


if __name__ == "__main__":
    _command.main(__doc__, twin, measured, refusals)
