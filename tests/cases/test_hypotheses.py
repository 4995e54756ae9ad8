#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each of cases/hypotheses and cases/disorders, at 4,000 particles and to its end, against its own [expect]; disorders also beside their control."""

import json
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import _command  # noqa: E402
import _run_folders  # noqa: E402

PARTICLES = 4000

# Measures of a disorder over those of the control, at the same t. Fewer and shallower folds where the cortex grows less (30,000
# particles: hull index 1.32, 1.30 and 1.73 where the control has 1.94), more where it grows more (2.39).
BESIDE_CONTROL = {"lissencephaly": {"gi_hull": (0.0, 0.9), "sulcal_depth_mean_mm": (0.0, 0.8), "area_ratio": (0.0, 0.7)},
                  "microcephaly": {"gi_hull": (0.0, 0.9), "volume_mm3": (0.0, 0.8)},
                  "pachygyria_half": {"gi_hull": (0.0, 0.97), "area_ratio": (0.0, 0.9)},
                  "polymicrogyria": {"gi_hull": (1.05, 2.0), "area_ratio": (1.1, 2.0)}}
summaries = {}


def settings_of(bench, case):
    settings = [f"geometry.particles={PARTICLES}", "output.pictures=off", "output.report=off"]
    if case["geometry"]["shape"] == "file":
        bench.accepted("new", "brain")
        settings.append(f"geometry.file={bench.folder / 'brain.nii.gz'}")
    if case.get("map", {}).get("region_table"):
        settings.append(f"map.region_file={bench.folder / 'brain_lobes.nii.gz'}")
    return [word for setting in settings for word in ("--set", setting)]


def case_test(file):
    def test(bench):
        case = tomllib.loads(file.read_text(encoding="utf-8"))
        bench.accepted("run", file, "--out", "run", "--quiet", *settings_of(bench, case), timeout=900)
        summary = json.loads((bench.folder / "run" / "summary.json").read_text(encoding="utf-8"))
        bench.check(summary["status"] == "completed", f"{file.name}: {summary['status']}")
        for key, (low, high) in case["expect"].items():
            bench.check(low <= summary[key] <= high, f"{file.name}: {key} is {summary[key]}, expected {low} to {high}")
        rows = _run_folders.measure_rows(bench.folder / "run")
        bench.check(min(row["J_min"] for row in rows) > 0, f"{file.name}: a particle is inverted")
        bench.check(rows[-1]["intersecting_triangles"] == 0, f"{file.name}: surfaces cross")
        summaries[file.stem] = summary
    return test


def disorders_beside_their_control(bench):
    control = summaries["control"]
    for name, ratios in BESIDE_CONTROL.items():
        for key, (low, high) in ratios.items():
            ratio = summaries[name][key] / control[key]
            bench.check(low <= ratio <= high, f"{name}: {key} is {ratio:.3f} of the control's, expected {low} to {high}")


if __name__ == "__main__":
    here = Path(__file__).resolve().parents[2]
    source = Path(sys.argv[sys.argv.index("--source") + 1]).resolve() if "--source" in sys.argv[:-1] else here
    files = [*sorted((source / "cases" / "hypotheses").glob("*.toml")), *sorted((source / "cases" / "disorders").glob("*.toml"))]
    _command.main(__doc__, *map(case_test, files), disorders_beside_their_control)
