#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From labels, dirty surfaces and tet meshes to a prepared body and a run of it; maps; what is wrong is said in one line."""

import gzip
import json
import math
import random
import struct

import _command
import _surfaces
from _run_folders import check_same
from _volumes import nifti

SHORT = ("--set", "geometry.particles=3000", "--set", "time.end=0.04", "--set", "output.count=2")
FILE_CASE = '[geometry]\nshape = "file"\nfile = "{}"\nparticles = 2000\n[output]\npictures = "off"\n{}\n'
FREUDENTHAL = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)) # of a cube, right-handed


def report(bench, folder):
    path = bench.folder / folder / "preparation.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}


def close(bench, got, expected, tolerance, what):
    bench.check(got is not None and abs(got - expected) <= tolerance, f"{what}: got {got}, expected {expected} +- {tolerance}")


def phantom(bench):
    """The built-in brain: from labels to a run; prepared and run gives what running alone gives."""
    bench.accepted("new", "brain")
    bench.refused(["new", "brain"], ["exists"])
    size = json.loads(bench.accepted("measure", "brain.nii.gz", "--labels", "2,3,5,7", "--json") or "{}")
    close(bench, size.get("volume_mm3"), 64460, 1000, "volume of the phantom's labels")
    close(bench, size.get("length_mm"), 64.4, 0.8, "length of the phantom's labels")
    bench.check(1.05 < size.get("gi_hull", 0) < 1.15, f"hull index of the phantom's labels: {size.get('gi_hull')}")
    bench.refused(["measure", "brain.nii.gz", "--labels", "99"], ["99"])
    bench.refused(["measure", "brain.nii.gz", "--labels", "2,x"], ["labels"])
    bench.refused(["measure", "brain.nii.gz", "--closing-mm", "-1"], ["closing_mm"])
    bench.accepted("prepare", "brain.toml", "--out", "body", *SHORT)
    got = report(bench, "body")
    bench.check(got.get("genus") == 0, f"the phantom has genus {got.get('genus')}")
    bench.check(got.get("closest_pair_spacings", 0) > 0.5, f"closest pair: {got.get('closest_pair_spacings')} spacings")
    close(bench, got.get("particle_volume_sum_mm3", 0) / got.get("volume_mm3", 1), 1.0, 1e-12, "volumes of the particles")
    for name in ("body.h5", "case.toml", "particles.vtu", "surface.vtp"):
        bench.check((bench.folder / "body" / name).is_file(), f"prepare wrote no {name}")
    bench.refused(["prepare", "brain.toml", "--out", "body", *SHORT], ["--overwrite"])
    bench.accepted("prepare", "brain.toml", "--out", "body", "--overwrite", "--quiet", *SHORT)
    bench.accepted("run", "brain.toml", "--out", "direct", "--quiet", *SHORT)
    weeks = [word for setting in ("time.clock=wang", "time.start_week=23", "time.end_week=23.5", "size.law=quadratic")
             for word in ("--set", setting)]
    bench.accepted("run", "brain.toml", "--out", "weeks", "--quiet", *SHORT[:2], *weeks, "--set", "output.pictures=off")
    got = bench.accepted("compare", "weeks", "brain.nii.gz@23", "--labels", "2,3,5,7", "--json")
    real = json.loads(got or "{}").get("reals", [{}])[0]
    length = real.get("measures", {}).get("length_mm", {})
    close(bench, length.get("run", 0) / length.get("real", 1), 1.0, 0.03, "length of the run over that of its labels")
    bench.accepted("run", "brain.toml", "--out", "prepared", "--body", "body", "--quiet", *SHORT)
    check_same(bench, "direct", "prepared", "from a prepared body")
    bench.refused(["run", "brain.toml", "--out", "other", "--body", "body", *SHORT, "--set", "geometry.seed=9"], ["geometry.seed"])
    bench.refused(["run", "brain.toml", "--out", "other", "--body", "none.h5", *SHORT], ["none.h5"])
    bench.refused(["prepare", "brain.toml", "--out", "direct"], ["direct", "run"])
    bench.accepted("run", "brain.toml", "--out", "left", "--quiet", *SHORT, "--set", "geometry.hemisphere=left",
                   "--set", "geometry.particles=1500")


def ball_labels(size, radius, label=2):
    middle = (size - 1) / 2
    return [label if math.dist((x, y, z), (middle,) * 3) <= radius else 0 for z in range(size) for y in range(size)
            for x in range(size)]


def labels(bench):
    size, radius = 40, 14
    image = nifti(ball_labels(size, radius), (size,) * 3)
    bench.write("ball.nii.gz", gzip.compress(image))
    bench.write("ball.nii", image)
    bench.write("case.toml", FILE_CASE.format("ball.nii.gz", ""))
    bench.accepted("prepare", "case.toml", "--out", "ball", "--set", "geometry.labels=[2]")
    close(bench, report(bench, "ball").get("volume_mm3"), 4 / 3 * math.pi * radius**3, 150.0, "volume of the ball")
    bench.check(report(bench, "ball").get("source") == "labels", "the report does not say that the body is from labels")
    mask = report(bench, "ball").get("mask", {})
    bench.check(mask.get("genus") == 0 and any(step["added_voxels"] > 10000 for step in mask.get("steps", [])),
                f"the report of the mask: {mask}")

    def refused(name, content, parts, *more):
        bench.write(name, content)
        bench.refused(["run", "case.toml", "--out", "out", "--set", f"geometry.file={name}", *more], parts)

    refused("cut.nii.gz", gzip.compress(image)[:-200], ["cut.nii.gz"])
    refused("magic.nii", image[:344] + b"abcd" + image[348:], ["magic.nii"])
    refused("short.nii", image[:-1000], ["short.nii"])
    refused("series.nii", nifti(ball_labels(20, 8) * 3, (20,) * 3, dims=(4, 20, 20, 20, 3, 1, 1, 1)), ["series.nii", "3"])
    refused("ball.nii", image, ["ball.nii", "7", "2"], "--set", "geometry.labels=[7]")
    refused("empty.nii", nifti([0] * 8000, (20,) * 3), ["empty.nii"])
    refused("absurd.nii", nifti(ball_labels(20, 8), (20,) * 3, voxel=1000.0), ["absurd.nii"])


def without(surface, share):
    """A share of the triangles deleted."""
    chance = random.Random(3)
    return surface[0], [t for t in surface[1] if chance.random() > share]


def dirty_surfaces(bench):
    ball = _surfaces.icosphere(10.0, 4)
    pierced = _surfaces.moved(ball, 0, tuple(-1.05 * x for x in ball[0][0]))
    small = _surfaces.icosphere(2.0, 2, (0.0, 0.0, 30.0))
    dirty = {"holes": without(ball, 0.01), "inside_out": _surfaces.flipped(ball), "crossing": pierced,
             "shells": _surfaces.joined(ball, small)}
    for name, surface in dirty.items():
        bench.write(f"{name}.off", _surfaces.off(surface))
        bench.write("case.toml", FILE_CASE.format(f"{name}.off", ""))
        bench.refused(["prepare", "case.toml", "--out", f"{name}_none"], [f"{name}.off"])
        for repair in ("auto", "wrap"):
            folder = f"{name}_{repair}"
            bench.accepted("prepare", "case.toml", "--out", folder, "--quiet", "--set", f"geometry.repair={repair}")
            got = report(bench, folder)
            bench.check(got.get("notes"), f"{folder}: the report says nothing")
            wrapped = got.get("repair", {}).get("wrapped")
            bench.check(wrapped if repair == "wrap" else wrapped is not None, f"{folder}: wrapped is {wrapped}")
            if (name, repair) != ("shells", "wrap"):
                close(bench, got.get("volume_mm3", 0) / _surfaces.volume(ball), 1.0, 0.01, f"{folder}: volume")


def rounded(point):
    """From the cube of half edge 1 to the ball of radius 1: cubes become spheres."""
    length = math.hypot(*point)
    scale = max(map(abs, point)) / length if length > 0 else 1.0
    return tuple(scale * x for x in point)


def tet_ball(cells, radius):
    """A cube of cells³ cubes, each cut into six tets, drawn in to a ball."""
    n = cells + 1
    at = [2 * k / cells - 1 for k in range(n)]
    points = [tuple(radius * x for x in rounded((x, y, z))) for z in at for y in at for x in at]
    tets = []
    for z in range(cells):
        for y in range(cells):
            for x in range(cells):
                corner = [(z + (k >> 2)) * n * n + (y + (k >> 1 & 1)) * n + x + (k & 1) for k in range(8)]
                tets += [tuple(corner[k] for k in tet) for tet in FREUDENTHAL]
    return points, tets


def netgen(mesh):
    points, tets = mesh
    lines = [str(len(points)), *("{} {} {}".format(*p) for p in points), str(len(tets))]
    lines += ["1 {} {} {} {}".format(*(k + 1 for k in tet)) for tet in tets]
    return "\n".join([*lines, "0"]) + "\n"


def tets(bench):
    ball, radius = tet_ball(20, 8.0), 8.0
    bench.write("ball.mesh", netgen(ball))
    bench.write("case.toml", FILE_CASE.format("ball.mesh", '[tissue]\nthickness_mm = 2.5\n'))
    for arrangement in ("tet_nodes", "thinned", "thinned_at_random", "body_fitted"):
        particles = () if arrangement == "tet_nodes" else ("--set", "geometry.particles=2500")
        bench.accepted("prepare", "case.toml", "--out", arrangement, "--quiet", "--set", f"geometry.arrangement={arrangement}",
                       *particles)
        got = report(bench, arrangement)
        close(bench, got.get("particle_volume_sum_mm3"), 4 / 3 * math.pi * radius**3, 25.0, f"{arrangement}: volume")
        if arrangement == "tet_nodes":
            bench.check(got.get("particles") == len(ball[0]), f"{got.get('particles')} particles, expected {len(ball[0])}")
    bench.accepted("run", "case.toml", "--out", "run", "--quiet", "--set", "geometry.arrangement=tet_nodes",
                   "--set", "time.end=0.02")
    bench.write("twisted.mesh", netgen((ball[0], [(a, b, d, c) for a, b, c, d in ball[1]])))
    bench.accepted("prepare", "case.toml", "--out", "twisted", "--set", "geometry.file=twisted.mesh")
    bench.write("apart.mesh", netgen((ball[0], [ball[1][0], ball[1][-1]])))
    bench.refused(["prepare", "case.toml", "--out", "apart", "--set", "geometry.file=apart.mesh"], ["apart.mesh"])
    bench.write("ball.off", _surfaces.off(_surfaces.icosphere(10.0, 3)))
    bench.refused(["prepare", "case.toml", "--out", "b", "--set", "geometry.file=ball.off", "--set",
                   "geometry.arrangement=tet_nodes"], ["geometry.arrangement", "tet mesh"])


def maps(bench):
    ball = _surfaces.icosphere(10.0, 3)
    bench.write("ball.off", _surfaces.off(ball))
    bench.write("growth.csv", "".join(f"{1 + 0.05 * x!r}\n" for x, _, _ in ball[0]))
    bench.write("thickness.csv", "".join(f"{3.0 + 0.1 * x!r}\n" for x, _, _ in ball[0]))
    bench.write("case.toml", FILE_CASE.format("ball.off", '[map]\ngrowth_file = "growth.csv"\nthickness_file = "thickness.csv"'))
    bench.accepted("run", "case.toml", "--out", "run", "--quiet", "--set", "time.end=0.02")
    bench.check("growth_file" in (bench.folder / "run/case.toml").read_text(), "the resolved case lacks the map")
    bench.write("short.csv", "1\n2\n")
    bench.write("nan.csv", "nan\n" * len(ball[0]))
    for name, parts in (("short.csv", [str(len(ball[0]))]), ("nan.csv", ["nan.csv"]), ("none.csv", ["none.csv"])):
        bench.refused(["run", "case.toml", "--out", "out", "--set", f"map.growth_file={name}"], parts)
    bench.write("sphere.toml", '[geometry]\nparticles = 1000\n[map]\ngrowth_file = "growth.csv"\n')
    bench.refused(["run", "sphere.toml", "--out", "out"], ["map.growth_file", "surface file"])


def moved_surfaces(bench):
    """What moves the points of a file is said, and can be turned off."""
    ball = _surfaces.icosphere(10.0, 3)
    data = b"\xff\xff\xfecreated by a test\n\n" + struct.pack(">2i", len(ball[0]), len(ball[1]))
    data += b"".join(struct.pack(">3f", *vertex) for vertex in ball[0]) + b"".join(struct.pack(">3i", *t) for t in ball[1])
    data += struct.pack(">i", 20) + (b"valid = 1\nfilename = none\nvolume = 256 256 256\nvoxelsize = 1 1 1\n"
                                     b"xras = -1 0 0\nyras = 0 0 -1\nzras = 0 1 0\ncras = 5 -18 20\n")
    bench.write("lh.pial", data)
    bench.write("case.toml", FILE_CASE.format("lh.pial", ""))
    moved = "points were moved by (5, -18, 20) mm by the volume geometry"
    bench.check(moved in bench.accepted("prepare", "case.toml", "--out", "moved"), "prepare does not say what moved the points")
    bench.accepted("run", "case.toml", "--out", "run", "--quiet", "--set", "time.end=0.02", "--set", "output.count=1")
    bench.check(moved in (bench.folder / "run/run.log").read_text(), "run.log does not say what moved the points")
    said = bench.accepted("prepare", "case.toml", "--out", "kept", "--set", "geometry.coordinates=file")
    bench.check("taken as they are" in said, f"prepare does not say that the points were left alone: {said}")
    for options, words in (((), moved), (("--coordinates", "file"), "taken as they are")):
        status, _, errors = bench.call("measure", "lh.pial", *options)
        bench.check(status == 0 and words in errors, f"measure {options}: {errors!r}")


if __name__ == "__main__":
    _command.main(__doc__, phantom, labels, dirty_surfaces, tets, maps, moved_surfaces)
