#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite elements by the command: a run, killed and resumed, on one thread and two; a prepared body; bad tet meshes."""

import json
import os
import signal

import _command
import _surfaces
import test_geometry
from _run_folders import check_same, stop, wait_for

CASE = """[geometry]
radius_mm = 12.496
[tissue]
layer = "binary"
lambda = 0.75
[solver]
method = "fem"
elements = 2500
[time]
end = 0.4
[output]
count = 4
pictures = "off"
checkpoint_minutes = 0.0005
"""
FILE_CASE = """[geometry]
shape = "file"
file = "ball.mesh"
arrangement = "{}"
[solver]
method = "fem"
[time]
end = 0.02
[output]
count = 1
pictures = "off"
"""


def run(bench):
    bench.write("case.toml", CASE)
    bench.accepted("run", "case.toml", "--quiet", "--out", "A", "--threads", "2")
    summary = json.loads((bench.folder / "A/summary.json").read_text())
    bench.check(summary["method"] == "fem", f"method {summary['method']}")
    bench.check(abs(summary["elements"] / 2500 - 1) < 0.15, f"{summary['elements']} elements, asked for 2500")
    bench.check(summary["inverted_elements"] == 0 and summary["ns_per_element_step"] > 0, f"summary: {summary}")
    bench.check(1.2 < summary["area_ratio"] < 2.0, f"area ratio {summary['area_ratio']}")
    curved = summary["curved_volume_ratio"] / summary["volume_ratio"]
    bench.check(0.99 < curved < 1.05, f"curved volume ratio over the flat one: {curved}")
    balance = (summary["energy_elastic"] + summary["energy_kinetic"] + summary["energy_dissipated"]) / summary["work_growth"]
    bench.check(abs(balance - 1) < 0.01, f"energies over the work of growth: {balance}")

    bench.accepted("run", "case.toml", "--quiet", "--out", "one", "--threads", "1")
    check_same(bench, "A", "one", "on one thread", {"threads"})
    process = bench.start("run", "case.toml", "--quiet", "--out", "B")
    wait_for(process, lambda: (bench.folder / "B/checkpoint.h5").exists(), 120)
    stop(process, signal.SIGKILL)
    bench.accepted("run", "case.toml", "--quiet", "--out", "B", "--resume")
    check_same(bench, "A", "B", "after a kill", {"threads"})
    bench.accepted("prepare", "case.toml", "--out", "body", "--quiet")
    bench.accepted("run", "case.toml", "--quiet", "--out", "C", "--body", "body/body.h5")
    check_same(bench, "A", "C", "from a body file", {"threads"})
    bench.check("elements" in bench.accepted("check", "case.toml"), "check says nothing of elements")
    output = bench.accepted("check", "case.toml", "--set", "solver.method=tlsph")
    bench.check("particles" in output, "elements do not set the number of particles")


def bad_keys(bench):
    bench.write("case.toml", CASE)

    def refused(parts, *settings):
        bench.refused(["run", "case.toml", "--out", "out", *[word for s in settings for word in ("--set", s)]], parts)

    refused(["solver.elements"], "solver.elements=10")
    refused(["geometry.arrangement", "thinned"], "geometry.shape=file", "geometry.file=x.mesh", "geometry.arrangement=thinned")
    refused(["geometry.volumes", "cells"], "geometry.volumes=neighbour_count")
    refused(["solver.elements", "geometry.particles"], "solver.elements=5000", "geometry.particles=5000")


def bad_tets(bench):
    """Repaired or refused with a line that says so."""
    points, tets = test_geometry.tet_ball(10, 8.0)
    sound = (points, tets)
    bench.write("ball.mesh", test_geometry.netgen(sound))
    for arrangement in ("tet_nodes", "body_fitted"):
        bench.write("case.toml", FILE_CASE.format(arrangement))
        settings = ["--set", "geometry.particles=1000"] if arrangement == "body_fitted" else []
        bench.accepted("run", "case.toml", "--quiet", "--out", arrangement, *settings)
    as_it_is = json.loads((bench.folder / "tet_nodes/summary.json").read_text())
    bench.write("case.toml", FILE_CASE.format("tet_nodes"))

    def repaired(name, mesh, word):
        bench.write(f"{name}.mesh", test_geometry.netgen(mesh))
        bench.accepted("run", "case.toml", "--quiet", "--out", name, "--set", f"geometry.file={name}.mesh")
        log = (bench.folder / name / "run.log").read_text()
        bench.check(word in log, f"{name}: the log does not say {word!r}")
        summary = json.loads((bench.folder / name / "summary.json").read_text())
        bench.check(summary["elements"] == as_it_is["elements"], f"{name}: {summary['elements']} elements")

    def refused(name, mesh, *parts):
        bench.write(f"{name}.mesh", test_geometry.netgen(mesh))
        bench.refused(["run", "case.toml", "--out", "out", "--set", f"geometry.file={name}.mesh"], [f"{name}.mesh", *parts])

    repaired("left_handed", (points, [(a, b, d, c) for a, b, c, d in tets]), "flipped")
    repaired("one_left_handed", (points, [(*tets[0][:2], tets[0][3], tets[0][2]), *tets[1:]]), "flipped")
    repaired("orphans", ([*points, (50.0, 0.0, 0.0)], tets), "dropped")
    repaired("twice", (points, [*tets, tets[7]]), "dropped")
    pushed = list(points)
    middle = min(range(len(points)), key=lambda i: sum(x * x for x in points[i]))
    pushed[middle] = (3.1, 0.2, 0.1)
    refused("inverted", (pushed, tets), "inverted")
    refused("slivers", ([(x, y, 1e-4 * z) for x, y, z in points], tets), "sliver")
    refused("crowded", ([*points, (0.3, 0.2, 9.9)], [*tets, (*tets[500][:3], len(points))]), "manifold")
    far = len(points)
    refused("apart", (points + [(x + 40.0, y, z) for x, y, z in points],
                      tets + [tuple(k + far for k in tet) for tet in tets]), "parts")
    bench.write("ball.off", _surfaces.off(_surfaces.icosphere(8.0, 3)))
    bench.refused(["run", "case.toml", "--out", "out", "--set", "geometry.file=ball.off"], ["tet mesh"])


def mesher(bench):
    """The program that meshes: missing, crashing, and interrupted."""
    bench.write("case.toml", CASE)
    try:
        for script, part in ((None, "cannot start"), ("kill -SEGV $$", "signal 11")):
            if script:
                (bench.folder / bench.write("mesher", f"#!/bin/sh\n{script}\n")).chmod(0o755)
            os.environ["CORTICLE_TETRAHEDRALIZE"] = str(bench.folder / "mesher")
            bench.refused(["run", "case.toml", "--out", "no"], [part, "mesher"], status=3)
        bench.write("mesher", "#!/bin/sh\necho $$ > pid\nexec sleep 60\n")
        process = bench.start("run", "case.toml", "--out", "no")
        began = wait_for(process, lambda: (bench.folder / "pid").is_file() and (bench.folder / "pid").read_text(), 60)
        status, _ = stop(process, signal.SIGINT)
        bench.check(began and status == 130, f"interrupted in meshing: exit status {status}")
        os.kill(int((bench.folder / "pid").read_text()), signal.SIGKILL)  # unlike this script, the program dies with it
    finally:
        del os.environ["CORTICLE_TETRAHEDRALIZE"]
    bench.check(not (bench.folder / "no").exists(), "a run without tets leaves a folder")


_command.main(__doc__, run, bad_keys, bad_tets, mesher)
