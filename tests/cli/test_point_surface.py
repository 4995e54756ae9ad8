#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface made from the particles of a run alone, beside the one the run carries along; and from a table of points."""

import json
import math

import _command

CASE = ('[geometry]\nradius_mm = 10\nparticles = 800\n[tissue]\nthickness_mm = 3\n'
        '[time]\nend = 0.02\n[output]\ncount = 1\npictures = "off"\n')
DELAUNAY = ("--surface", "delaunay")


def measured(bench, *arguments):
    return json.loads(bench.accepted("measure", *arguments, "--json") or "{}")


def of_a_run(bench):
    bench.write("case.toml", CASE)
    bench.accepted("run", "case.toml", "--out", "run", "--quiet")
    found = measured(bench, "run/particles_0001.vtu", *DELAUNAY, "--out", "found.vtp")
    bench.check(found.get("points_left_out") == 0, f"points left out: {found}")
    # A sphere is convex: nothing can be bridged, and the surface is the triangulation of its particles.
    bench.check(abs(found.get("area_error", 9)) < 0.1 and abs(found.get("volume_error", 9)) < 0.1, f"sphere: {found}")
    bench.check(found.get("distance_hausdorff_mm", 9) < 0.1, f"sphere: distances {found}")
    bench.check(found.get("carried_area_mm2", 0) > 0.9 * 4 * math.pi * 100, f"carried surface: {found}")
    again = measured(bench, "found.vtp")
    bench.check(math.isclose(again.get("area_mm2", 0), found["area_mm2"], rel_tol=1e-9), "--out holds another surface")
    tight = measured(bench, "run/particles_0001.vtu", *DELAUNAY, "--length-limit", "1.6")
    bench.check(tight.get("area_mm2", 0) > 1.2 * found["area_mm2"], f"a limit near the distance of points leaves hollows: {tight}")
    bench.refused(("measure", "run/particles_0001.vtu", *DELAUNAY, "--length-limit", "0.01"), ("no tet",))


def of_a_table(bench):
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    bench.write("cube.csv", "x [mm],y [mm],z [mm]\n" + "".join(f"{x},{y},{z}\n" for x, y, z in (*corners, (0.5, 0.4, 0.6))))
    cube = measured(bench, "cube.csv", *DELAUNAY, "--length-limit", "10")
    bench.check(math.isclose(cube.get("volume_mm3", 0), 1, rel_tol=1e-9) and "carried_area_mm2" not in cube, f"cube: {cube}")
    bench.write("flat.csv", "x,y,z\n0,0,0\n1,0,0\n0,1,0\n1,1,0\n")
    bench.refused(("measure", "flat.csv", *DELAUNAY), ("flat.csv", "plane"))
    bench.write("few.csv", "x,y,z\n0,0,0\n")
    bench.refused(("measure", "few.csv", *DELAUNAY), ("few.csv", "at least four"))
    bench.write("lacks.csv", "x,y\n0,0\n")
    bench.refused(("measure", "lacks.csv", *DELAUNAY), ("lacks.csv", "column z"))
    bench.refused(("measure", "none.vtu", *DELAUNAY), ("none.vtu",))
    bench.refused(("measure", "cube.csv", "--length-limit", "1"), ("--surface delaunay",))


if __name__ == "__main__":
    _command.main(__doc__, of_a_run, of_a_table)
