#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tissues by label and growth by week, on a small ball with a cortical plate; what does not go together is refused."""

import json
import math

import _command
from _run_folders import check_same, measure_rows
from _volumes import nifti

SIZE, VOXEL = 32, 0.8
CASE = """[geometry]
shape = "file"
file = "ball.nii"
particles = 3000
[tissue]
bulk_modulus = 10.0
[tissue.labels]
cortex = [2]
white = [3]
ventricle = [5]
[growth]
law = "fetal"
[time]
clock = "wang"
start_week = 25.0
end_week = 25.4
[output]
count = 1
pictures = "off"
"""


def ball():
    """Radius 11 mm; a plate of 2.4 mm (2) but at the base (z < -5 mm), white matter (3), a ventricle of 3 mm (5)."""
    labels = []
    for z in range(SIZE):
        for y in range(SIZE):
            for x in range(SIZE):
                place = [VOXEL * (k - 0.5 * (SIZE - 1)) for k in (x, y, z)]
                r = math.hypot(*place)
                labels.append(0 if r > 11 else 2 if r > 8.6 and place[2] > -5 else 5 if r < 3 else 3)
    return nifti(labels, (SIZE,) * 3, VOXEL)


def bodies(bench):
    bench.write("ball.nii", ball())
    bench.write("ball.toml", CASE)
    text = bench.accepted("check", "ball.toml")
    bench.check("tissues: cortex" in text and "% of the outer surface" in text, f"check says nothing of tissues: {text!r}")
    bench.check("labels.cortex = [2" in text, "the resolved case names no labels")
    bench.accepted("prepare", "ball.toml", "--out", "body", "--quiet")
    got = json.loads((bench.folder / "body/preparation.json").read_text(encoding="utf-8"))["tissues"]
    def near(value, expected, tolerance, what):
        bench.check(abs(value - expected) <= tolerance, f"{what}: got {value}, expected {expected} +- {tolerance}")
    cap = lambda r: math.pi * (r - 5) ** 2 * (2 * r + 5) / 3 # below z = -5
    plate = 4 / 3 * math.pi * (11**3 - 8.6**3) - (cap(11) - cap(8.6))
    near(got["volume_mm3"]["cortex"], plate, 0.06 * plate, "volume of the cortex")
    near(got["volume_mm3"]["ventricle"], 113, 25, "volume of the ventricle")
    near(got["cortex_area_share"], 0.5 * (1 + 5 / 11), 0.04, "cortex below the outer surface")
    near(got["cortex_thickness_mm"], 2.4, 0.25, "thickness of the cortex")
    bench.accepted("run", "ball.toml", "--out", "start", "--body", "body", "--quiet")
    # below z = -5 the surface of the body without cortex is that of the body
    inside = math.pi * (2 * 8.6 * 13.6 + 11**2 - 8.6**2 + 2 * 11 * 6)
    near(measure_rows(bench.folder / "start")[0]["inner_area_mm2"], inside, 0.1 * inside, "area of the inner surface") # its rim is rounded


def graded(bench):
    """The spacing grows below the labelled plate: from 2.4 mm (less what 95 % do not exceed) and some spacings on."""
    bench.write("ball.nii", ball())
    bench.write("ball.toml", CASE.replace("particles = 3000", "spacing_mm = 0.75"))
    numbers = {}
    for name, grading in (("uniform", "1"), ("graded", "2")):
        bench.accepted("prepare", "ball.toml", "--out", name, "--quiet", "--set", f"geometry.grading={grading}")
        numbers[name] = json.loads((bench.folder / name / "preparation.json").read_text(encoding="utf-8"))
    ratio = numbers["graded"]["particles"] / numbers["uniform"]["particles"]
    bench.check(0.5 < ratio < 0.92, f"graded body has {ratio:.3f} of the particles")
    cortex = [numbers[name]["tissues"]["volume_mm3"]["cortex"] for name in ("uniform", "graded")]
    bench.check(abs(cortex[1] / cortex[0] - 1) < 0.01, f"graded: volume of the cortex {cortex[1]}, uniform {cortex[0]}")
    bench.accepted("run", "ball.toml", "--out", "direct", "--quiet", "--set", "geometry.grading=2")
    bench.accepted("run", "ball.toml", "--out", "prepared", "--body", "graded", "--quiet", "--set", "geometry.grading=2")
    check_same(bench, "direct", "prepared", "graded by labels, from its prepared body")


def runs(bench):
    bench.write("ball.nii", ball())
    bench.write("ball.toml", CASE)
    bench.accepted("prepare", "ball.toml", "--out", "body", "--quiet")
    bench.accepted("run", "ball.toml", "--out", "direct", "--quiet")
    bench.accepted("run", "ball.toml", "--out", "prepared", "--body", "body", "--quiet")
    check_same(bench, "direct", "prepared", "from a prepared body")
    for folder, method in (("direct", ()), ("fem", ("--set", "solver.method=fem"))):
        if method:
            bench.accepted("run", "ball.toml", "--out", folder, "--quiet", *method)
        first, *_, last = measure_rows(bench.folder / folder)
        grown = last["volume_mm3"] / first["volume_mm3"]
        # 0.4 weeks at 13 and 16 % a week: the body starts at the speed of its growth and does not lag
        bench.check(1.05 < grown < 1.075, f"{folder}: volume grows by {grown}")
        bench.check(last["kinetic_share"] < 0.1, f"{folder}: kinetic energy {last['kinetic_share']} of the elastic one")
        bench.check(last["energy_balance_error"] < 0.01, f"{folder}: energy balance {last['energy_balance_error']}")
        bench.check(last["cortex_volume_mm3"] > first["cortex_volume_mm3"], f"{folder}: the cortex does not grow")
    bench.refused(["run", "ball.toml", "--out", "other", "--body", "body", "--set", "tissue.labels.white=[3,5]", "--set",
                   "tissue.labels.ventricle=[]"], ["tissue.labels"])


def tables(bench):
    bench.write("ball.nii", ball())
    bench.write("ball.toml", CASE.replace('law = "fetal"', 'law = "table"\ntable = "growth.csv"'))
    header = "week,tissue,tangential,radial\n"
    bench.write("growth.csv", header + "".join(f"{w},{t},{g},{g}\n" for t in ("cortex", "white", "ventricle")
                                               for w, g in ((20, 1.0), (30, 1.5))))
    bench.accepted("run", "ball.toml", "--out", "out", "--quiet")
    bench.check("growth.table" in (bench.folder / "out/case.toml").read_text(encoding="utf-8"), "[inputs] lacks growth.table")
    for text, parts in (("week,tissue,tangential\n20,cortex,1\n", ["growth.csv", "radial"]),
                        (header + "20,grey,1,1\n", ["growth.csv:2", "grey", "cortex"]),
                        (header + "20,cortex,x,1\n", ["growth.csv:2", "x"]),
                        (header + "20,cortex,0,1\n", ["growth.csv:2", "0"]),
                        (header, ["growth.csv", "empty"]),
                        (header + "20,cortex,1,1\n25.1,cortex,1.2,1.2\n", ["cortex", "25.4"])):
        bench.write("growth.csv", text)
        bench.refused(["run", "ball.toml", "--out", "bad"], parts)


def refusals(bench):
    bench.write("ball.nii", ball())
    bench.write("ball.toml", CASE)
    for setting, parts in (("tissue.labels.white=[2]", ["label 2", "tissue.labels.cortex"]),
                           ("tissue.labels.cortex=[]", ["tissue.labels.white", "tissue.labels.cortex"]),
                           ("tissue.labels.cortex=[99]", ["99"]),
                           ("tissue.labels.cortx=[2]", ["tissue.labels.cortx", "tissue.labels.cortex"]),
                           ("geometry.labels=[3,5]", ["label 2", "geometry.labels"]),
                           ("tissue.lambda=0.5", ["lambda"]),
                           ("tissue.thickness_rate_mm=0.1", ["thickness_rate_mm", "tissue.labels.cortex"]),
                           ("tissue.alpha_t=1.0", ["tissue.alpha_t", "growth.law"]),
                           ("growth.law=table", ["growth.table"]),
                           ("growth.table=x.csv", ["growth.table", "growth.law"]),
                           ("growth.law=foetal", ["fetal"])):
        bench.refused(["run", "ball.toml", "--out", "bad", "--set", setting], parts)
    bench.write("sphere.toml", "[tissue.labels]\ncortex = [2]\n")
    bench.refused(["check", "sphere.toml"], ["tissue.labels.cortex", "label volume"])
    bench.write("clockless.toml", '[growth]\nlaw = "fetal"\n')
    bench.refused(["check", "clockless.toml"], ["growth.law", "time.clock"])


if __name__ == "__main__":
    _command.main(__doc__, bodies, graded, runs, tables, refusals)
