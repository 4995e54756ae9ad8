#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that nibabel writes are read as nibabel reads them: MGH, NIfTI pairs, annotations, labels, text surfaces, packed files."""

import gzip
import json
import math
import sys

import _command
import _surfaces

try:
    import nibabel
    import numpy
except ImportError as error:
    print(f"skipped: {error} (python3-nibabel brings it)")
    sys.exit(_command.SKIPPED)

SIZE, RADIUS = 40, 14.0
CASE = '[geometry]\nshape = "file"\nfile = "{}"\nparticles = 2000\n[output]\npictures = "off"\nreport = "off"\n{}\n'


def ball(affine):
    """A ball of label 3 about the middle of the image, and where its centre lies."""
    index = numpy.indices((SIZE,) * 3).reshape(3, -1).T
    middle = numpy.full(3, (SIZE - 1) / 2)
    inside = numpy.linalg.norm((index - middle) * numpy.linalg.norm(affine[:3, :3], axis=0), axis=1) <= RADIUS
    return (3 * inside).astype(numpy.int16).reshape((SIZE,) * 3), affine[:3, :3] @ middle + affine[:3, 3]


def oblique():
    c, s = math.cos(0.3), math.sin(0.3)
    affine = numpy.eye(4)
    affine[:3, :3] = numpy.array([[-c, 0, s], [s, 0, c], [0, -1, 0]]) @ numpy.diag([1.0, 0.9, 1.1])
    affine[:3, 3] = 31, -12, 7
    return affine


def bounds(bench, *arguments):
    """x, y and z bounds of a body, from the line that measure prints."""
    status, output, errors = bench.call("measure", *arguments, "--json")
    bench.check(status == 0, f"measure {arguments}: {errors}")
    place = [line for line in errors.splitlines() if "the body lies at" in line]
    if not bench.check(place, f"measure {arguments} does not say where the body lies: {errors!r}"):
        return None, {}
    words = place[0].replace(",", "").split()
    low_high = [[float(words[words.index(axis) + k]) for k in (1, 3)] for axis in "xyz"]
    return numpy.array(low_high), json.loads(output or "{}")


def volumes(bench):
    affine = oblique()
    labels, centre = ball(affine)
    images = {"a.mgz": nibabel.MGHImage(labels, affine), "a.mgh": nibabel.MGHImage(labels.astype("f4"), affine),
              "a.hdr": nibabel.Nifti1Pair(labels, affine), "b.nii.gz": nibabel.Nifti1Image(labels, affine)}
    for name, image in images.items():
        image.to_filename(bench.folder / name)
    bench.write("C.NII.GZ", (bench.folder / "b.nii.gz").read_bytes())
    for name in (*images, "a.img", "C.NII.GZ"):
        place, measured = bounds(bench, name)
        if place is not None:
            off = abs(place.mean(axis=1) - centre).max()
            bench.check(off < 0.3, f"{name}: the ball lies {off:.2f} mm from where nibabel has it")
        wanted = 4 / 3 * math.pi * RADIUS**3
        bench.check(abs(measured.get("volume_mm3", 0) / wanted - 1) < 0.02, f"{name}: volume {measured.get('volume_mm3')}")
    _, _, errors = bench.call("measure", "a.mgz")
    orientation = "".join(nibabel.aff2axcodes(affine))
    bench.check(f"orientation {orientation}" in errors, f"a.mgz: {errors!r} does not say {orientation}")
    nibabel.AnalyzeImage(labels, numpy.diag([1, 1, 1, 1.0])).to_filename(bench.folder / "old.hdr")
    bench.refused(["measure", "old.hdr"], ["old.hdr", "ANALYZE 7.5"])


def surface_files(bench):
    points, triangles = _surfaces.icosphere(15.0, 3)
    points, triangles = numpy.array(points), numpy.array(triangles)
    text = f"#!ascii version of ball\n{len(points)} {len(triangles)}\n"
    text += "".join("{:.6f}  {:.6f}  {:.6f}  0\n".format(*p) for p in points)
    bench.write("ball.asc", text + "".join("{} {} {} 0\n".format(*t) for t in triangles))
    image = nibabel.gifti.GiftiImage(darrays=[
        nibabel.gifti.GiftiDataArray(points.astype("f4"), intent="NIFTI_INTENT_POINTSET"),
        nibabel.gifti.GiftiDataArray(triangles.astype("i4"), intent="NIFTI_INTENT_TRIANGLE")])
    bench.write("ball.surf.gii.gz", gzip.compress(image.to_bytes()))
    bench.write("BALL.STL.GZ", gzip.compress(stl(points, triangles)))
    for name in ("ball.asc", "ball.surf.gii.gz", "BALL.STL.GZ"):
        place, _ = bounds(bench, name)
        bench.check(place is not None and abs(abs(place) - 15.0).max() < 0.1, f"{name}: bounds {place}")
    return points, triangles


def stl(points, triangles):
    record = numpy.zeros(len(triangles), dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("end", "<u2")])
    record["corners"] = points[triangles].reshape(-1, 9)
    return bytes(80) + len(triangles).to_bytes(4, "little") + record.tobytes()


def regions(bench):
    """Annotations, labels and maps of FreeSurfer's on the vertices of a surface."""
    points, _ = surface_files(bench)
    colours = numpy.array([[25, 5, 25, 0, 0], [100, 250, 0, 0, 0]])
    which = (points[:, 2] > 0).astype(int)
    nibabel.freesurfer.write_annot(bench.folder / "lh.two.annot", which, colours, ["lower", "upper"], fill_ctab=True)
    upper = numpy.flatnonzero(which)
    bench.write("upper.label", f"#!ascii label\n{len(upper)}\n" + "".join(f"{k} 0 0 0 0\n" for k in upper))
    nibabel.MGHImage(numpy.full((len(points), 1, 1), 2.5, dtype="f4"), numpy.eye(4)).to_filename(bench.folder / "lh.thick.mgz")
    bench.write("two.csv", "label,growth\n0,0.5\n1,1.5\n")
    maps = {"annot": 'region_file = "lh.two.annot"\nregion_table = "two.csv"', "label": 'still_file = "upper.label"',
            "mgz": 'thickness_file = "lh.thick.mgz"'}
    for name, lines in maps.items():
        bench.write(f"{name}.toml", CASE.format("ball.asc", f"[map]\n{lines}"))
        bench.accepted("prepare", f"{name}.toml", "--out", f"body_{name}", "--quiet")
    report = json.loads((bench.folder / "body_mgz" / "preparation.json").read_text() or "{}")
    bench.check(any("2.5 to 2.5" in note for note in report["notes"]), f"the map of the .mgz: {report['notes']}")
    bench.check(any("largest depth" in note for note in report["notes"]), f"no largest depth: {report['notes']}")
    bench.write("one.csv", "label,growth\n1,1.5\n")
    bench.refused(["prepare", "annot.toml", "--out", "refused", "--set", "map.region_table=one.csv"], ["label 0", "lh.two.annot"])


def standard_input(bench):
    import subprocess
    case = "[geometry]\nparticles = 1500\n[time]\nend = 0.01\n[output]\npictures = \"off\"\nreport = \"off\"\ncount = 1\n"

    def call(*arguments, text=case):
        return subprocess.run([bench.command, *arguments], input=text, capture_output=True, text=True, cwd=bench.folder,
                              timeout=300, check=False)
    got = call("check", "-")
    bench.check(got.returncode == 0 and "particles = 1500" in got.stdout, f"check -: {got.stderr!r}")
    got = call("run", "-", "--out", "piped", "--quiet")
    bench.check(got.returncode == 0 and (bench.folder / "piped" / "summary.json").is_file(), f"run -: {got.stderr!r}")
    for arguments, text, part in ((("run", "-"), case, "--out is missing"), (("prepare", "-"), case, "--out is missing"),
                                  (("check", "-"), "", "got nothing"), (("check", "-"), "x = 1\n", "standard input:1")):
        got = call(*arguments, text=text)
        one_line = got.stderr.count("\n") == 1 and got.stderr.startswith(_command.PREFIX)
        bench.check(got.returncode == 2 and one_line and part in got.stderr, f"{arguments}: {got.returncode} {got.stderr!r}")


_command.main(__doc__, volumes, regions, standard_input)
