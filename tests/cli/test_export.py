# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a small run, exported and read back by nibabel: coordinates, triangles and arrays agree."""

import json
import struct
import sys
from xml.etree import ElementTree

import _command

try:
    import nibabel
    import numpy
except ImportError as error:
    print(f"skipped: {error} (python3-nibabel brings it)")
    sys.exit(_command.SKIPPED)

CASE = ('[geometry]\nradius_mm = 10\nparticles = 800\n[tissue]\nthickness_mm = 3\n'
        '[time]\nend = 0.02\n[output]\ncount = 2\npictures = "off"\n')
SCALARS = ("J", "growth", "theta")
PLY_TYPES = {"double": "<f8", "float": "<f4", "int": "<i4", "uchar": "u1"}


def read_ply(path):
    """(vertex properties by name, triangles) of a binary PLY."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts, properties = {}, []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        elif words[0] == "property" and words[1] != "list":
            properties.append((words[2], PLY_TYPES[words[1]]))
    record = numpy.dtype(properties)
    vertices = numpy.frombuffer(data, record, counts["vertex"], end)
    faces = numpy.frombuffer(data, numpy.dtype([("n", "u1"), ("v", "<i4", 3)]), counts["face"],
                             end + record.itemsize * counts["vertex"])
    return {name: vertices[name] for name, _ in properties}, faces["v"]


def read_stl(path):
    """Corners of the triangles of a binary STL, three rows each."""
    data = path.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    facets = numpy.frombuffer(data, numpy.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]), count, 84)
    return facets["v"].reshape(-1, 3)


def made_run(bench):
    """Folder of a small run and, from its PLY, the surface at the end as doubles."""
    bench.write("case.toml", CASE)
    bench.accepted("run", "case.toml", "--out", "run", "--quiet", "--threads", "2")
    output = bench.accepted("export", "run", "--format", "ply")
    bench.check("t = 0.02" in output and "surface_t0.020.ply" in output, f"export says {output!r}")
    return read_ply(bench.folder / "run" / "export" / "surface_t0.020.ply")


def formats(bench):
    properties, triangles = made_run(bench)
    points = numpy.stack([properties[axis] for axis in "xyz"], axis=1)
    summary = json.loads((bench.folder / "run" / "summary.json").read_text())
    a, b, c = (points[triangles[:, k]] for k in range(3))
    volume = float(numpy.einsum("ij,ij->", a, numpy.cross(b, c))) / 6
    bench.check(abs(volume - summary["volume_mm3"]) < 1e-9 * volume, f"PLY: volume {volume}, run says {summary}")
    for name in SCALARS:
        bench.check(name in properties, f"PLY: no property {name} among {sorted(properties)}")
    single = points.astype(numpy.float32)

    bench.accepted("export", "run", "--format", "gifti", "--out", "gifti", "--structure", "CortexRight")
    surface = nibabel.load(bench.folder / "gifti" / "surface_t0.020.surf.gii")
    got_points, got_triangles = surface.agg_data(("pointset", "triangle"))
    bench.check(numpy.array_equal(got_points, single), "GIFTI: coordinates differ")
    bench.check(numpy.array_equal(got_triangles, triangles), "GIFTI: triangles differ")
    bench.check(surface.meta["AnatomicalStructurePrimary"] == "CortexRight", f"GIFTI: metadata {surface.meta}")
    bench.check(surface.darrays[1].meta["TopologicalType"] == "Closed", f"GIFTI: {surface.darrays[1].meta}")
    space = surface.darrays[0].coordsys
    bench.check(space.dataspace == 1 and numpy.array_equal(space.xform, numpy.eye(4)), "GIFTI: not in scanner space")
    scalars = [name for name in properties if name not in "xyz"]
    for name in scalars:
        shape = nibabel.load(bench.folder / "gifti" / f"surface_t0.020.{name}.shape.gii")
        bench.check(numpy.array_equal(shape.agg_data(), properties[name].astype(numpy.float32)), f"GIFTI: {name}")
        bench.check(shape.darrays[0].meta["Name"] == name, f"GIFTI: name of {name}")
        bench.check(shape.darrays[0].intent == nibabel.nifti1.intent_codes["NIFTI_INTENT_SHAPE"], f"GIFTI: {name}")

    hemispheres(bench, single, triangles, {name: properties[name].astype(numpy.float32) for name in scalars})

    bench.accepted("export", "run", "--format", "freesurfer", "--out", "freesurfer")
    stem = bench.folder / "freesurfer" / "surface_t0.020"
    got_points, got_triangles, geometry = nibabel.freesurfer.read_geometry(f"{stem}.surf", read_metadata=True)
    bench.check(numpy.array_equal(got_points.astype(numpy.float32), single), "FreeSurfer: coordinates differ")
    bench.check(numpy.array_equal(got_triangles, triangles), "FreeSurfer: triangles differ")
    bench.check(not numpy.any(geometry["cras"]) and geometry["valid"].startswith("1"), f"FreeSurfer: {geometry}")
    for name in scalars:
        values = nibabel.freesurfer.read_morph_data(f"{stem}.{name}.curv")
        bench.check(numpy.array_equal(values, properties[name].astype(numpy.float32)), f"FreeSurfer: {name}")

    bench.accepted("export", "run", "--format", "stl", "--out", "stl")
    corners = read_stl(bench.folder / "stl" / "surface_t0.020.stl")
    bench.check(numpy.array_equal(corners, single[triangles.reshape(-1)]), "STL: corners differ")

    # The command reads all it wrote, and measures the same.
    for name in ("run/export/surface_t0.020.ply", "gifti/surface_t0.020.surf.gii", "freesurfer/surface_t0.020.surf",
                 "stl/surface_t0.020.stl"):
        area = json.loads(bench.accepted("measure", name, "--json"))["area_mm2"]
        bench.check(abs(area / summary["area_mm2"] - 1) < 1e-5, f"{name}: area {area}, run says {summary['area_mm2']}")


def hemispheres(bench, points, triangles, arrays):
    """--split: the triangles of both files are those of the whole; the specification names every file."""
    bench.accepted("export", "run", "--format", "gifti", "--out", "halves", "--split")
    folder = bench.folder / "halves"
    corners, middle = [], 0.5 * (points[:, 0].min() + points[:, 0].max())
    for letter, structure in (("L", "CortexLeft"), ("R", "CortexRight")):
        surface = nibabel.load(folder / f"surface_t0.020.{letter}.surf.gii")
        half, faces = surface.agg_data(("pointset", "triangle"))
        bench.check(half.dtype == numpy.float32 and faces.dtype == numpy.int32, f"{letter}: {half.dtype}, {faces.dtype}")
        bench.check(surface.meta["AnatomicalStructurePrimary"] == structure, f"{letter}: metadata {surface.meta}")
        bench.check(surface.darrays[1].meta["TopologicalType"] == "Open", f"{letter}: {surface.darrays[1].meta}")
        centers = half[faces].mean(axis=1)[:, 0]
        bench.check(numpy.all((centers < middle) == (letter == "L")), f"{letter}: a triangle lies on the other side")
        corners.append(half[faces])
        for name, values in arrays.items():
            got = nibabel.load(folder / f"surface_t0.020.{letter}.{name}.shape.gii").agg_data()
            known = dict(zip(map(tuple, points), values))
            bench.check(all(known[tuple(point)] == value for point, value in zip(half, got)), f"{letter}: {name}")
    ordered = lambda all_corners: sorted(map(tuple, all_corners.reshape(-1, 9)))
    bench.check(ordered(numpy.concatenate(corners)) == ordered(points[triangles]), "halves: not the triangles of the whole")
    entries = [(entry.get("Structure"), entry.get("DataFileType"), entry.text.strip())
               for entry in ElementTree.parse(folder / "surface_t0.020.spec").getroot().iter("DataFile")]
    files = sorted(path.name for path in folder.glob("*.gii"))
    bench.check(sorted(name for _, _, name in entries) == files, f"spec: {entries}")
    for structure, kind, name in entries:
        bench.check(structure == ("CortexLeft" if ".L." in name else "CortexRight"), f"spec: {name} is {structure}")
        bench.check(kind == ("SURFACE" if name.endswith(".surf.gii") else "METRIC"), f"spec: {name} is {kind}")


def times_and_refusals(bench):
    made_run(bench)
    output = bench.accepted("export", "run", "--format", "stl", "--out", "s", "--time", "0.009", "--time", "0",
                            "--time", "0.011")
    names = sorted(path.name for path in (bench.folder / "s").iterdir())
    bench.check(names == ["corticle-files.txt", "surface_t0.000.stl", "surface_t0.010.stl"], f"--time wrote {names}")
    bench.check("t = 0.01 (nearest to 0.009, 0.011)" in output, f"export says {output!r}")
    bench.refused(["export", "run", "--format", "stl", "--time", "nan"], ["--time", "nan"])
    bench.refused(["export", "run", "--format", "stl", "--time", "soon"], ["--time", "soon"])
    bench.refused(["export", "run", "--format", "stl", "--out", "case.toml"], ["--out", "case.toml"])
    (bench.folder / "empty").mkdir()
    bench.refused(["export", "empty", "--format", "stl"], ["empty", "surface.pvd"])
    (bench.folder / "run" / "surface_0002.vtp").write_bytes(b"<VTKFile")
    bench.refused(["export", "run", "--format", "stl", "--out", "t"], ["surface_0002.vtp"])


_command.main(__doc__, formats, times_and_refusals)
