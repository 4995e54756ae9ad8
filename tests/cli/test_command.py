# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage, bad input and the small verbs: what was wrong is said in one line, the exit status is 2, nothing is written."""

import json
import math

import _command
import _surfaces

FILE_CASE = '[geometry]\nshape = "file"\nfile = "{}"\nparticles = 1000\n'


def usage(bench):
    for verb in ("run", "sweep", "prepare", "new", "check", "schema", "measure", "compare", "render", "export"):
        bench.check("Usage" in bench.accepted(verb, "--help"), f"{verb} --help shows no usage")
        bench.check(verb in bench.accepted("--help"), f"--help does not list {verb}")
    bench.check(bench.accepted("--version").startswith("corticle "), "--version")
    bench.write("case.toml", "")
    bench.refused([], ["subcommand"])
    bench.refused(["fold"], ["fold", "measure"])
    bench.refused(["run"], ["case"])
    bench.refused(["run", "case.toml", "--fast"], ["--fast"])
    bench.refused(["run", "case.toml", "more.toml"], ["more.toml"])
    bench.refused(["run", "case.toml", "--threads", "0"], ["--threads", "0"])
    bench.refused(["run", "case.toml", "--threads", "many"], ["--threads", "many"])
    bench.refused(["measure", "a.stl", "--unit", "inch"], ["inch", "mm"])
    bench.refused(["render", "no_such_run"], ["no_such_run"])
    bench.refused(["export", "no_such_run", "--format", "gifti"], ["no_such_run", "surface.pvd"])
    bench.refused(["export", "no_such_run", "--format", "nifti"], ["nifti", "freesurfer"])
    bench.refused(["export", "no_such_run"], ["--format"])


def schema(bench):
    text, markdown = bench.accepted("schema"), bench.accepted("schema", "--markdown")
    for key in ("radius_mm", "lambda", "zeta", "distance", "end", "checkpoint_minutes"):
        bench.check(key in text, f"schema lacks {key}")
        bench.check(f"| `{key}` |" in markdown, f"schema --markdown lacks {key}")
    page = (bench.source / "docs" / "guide" / "parameters.md").read_text(encoding="utf-8")
    bench.check(page.endswith(markdown.lstrip("\n")), "docs/guide/parameters.md is not what schema --markdown prints")


def starter(bench):
    for shape in ("sphere", "ellipsoid", "file"):
        bench.accepted("new", f"{shape}.toml", "--shape", shape)
        bench.check((bench.folder / f"{shape}.toml").is_file(), f"new wrote no {shape}.toml")
    bench.accepted("check", "sphere.toml", "--set", "geometry.particles=1000")
    bench.refused(["new", "sphere.toml"], ["sphere.toml", "exists"])
    bench.refused(["new", "case.txt"], ["case.txt", ".toml"])
    bench.refused(["new", "no_such_folder/case.toml"], ["no_such_folder"])
    bench.refused(["new", "a.toml", "--shape", "cube"], ["cube", "sphere"])


def bad_cases(bench):
    def refused(text, parts, *more):
        bench.write("case.toml", text)
        bench.refused(["run", "case.toml", "--out", "out", *more], parts)
        bench.refused(["check", "case.toml", *more], parts)

    refused("[geometry]\n\n\nraduis_mm = 3\n", ["geometry.raduis_mm", "case.toml:4", "geometry.radius_mm?"])
    refused("[geometri]\n", ["geometri", "case.toml:1", "[geometry]?"])
    refused('[geometry]\nradius_mm = "big"\n', ["geometry.radius_mm", "case.toml:2", '"big"', "number"])
    refused("[geometry]\nradius_mm = -1\n", ["geometry.radius_mm", "case.toml:2", "-1", "(0, 1000]"])
    refused("[time]\nend = nan\n", ["time.end", "nan"])
    refused("[time]\nend = 1\nend = 1\n", ["case.toml:3"])
    refused("[time\n", ["case.toml:1"])
    refused("[geometry]\nparticles = 499\n", ["499", "500"])
    refused("[geometry]\nparticles = 100000001\n", ["100000001", "100000000"])
    refused("[geometry]\nspacing_mm = 5\n", ["spacing_mm", "particles", "500"])
    refused("[geometry]\nspacing_mm = 0.001\n", ["spacing_mm", "particles", "100000000"])
    refused("[geometry]\nspacing_mm = 1\nparticles = 1000\n", ["both"])
    refused('[geometry]\nshape = "file"\n', ["geometry.file"])
    refused(FILE_CASE.format("no_such.stl"), ["no_such.stl"])
    refused("[tissue]\nlambda = 0.5\n", ["tissue.lambda", "binary"])
    refused('[solver]\nmethod = "mpm"\n', ["mpm", "tlsph", "fem"])
    refused(b"\xff\xfe\x00", ["case.toml"])
    refused("a = " + "[" * 100000, ["case.toml"])
    refused("", ["time.ends", "time.end?"], "--set", "time.ends=1")
    refused("", ["--set", "section.key=value"], "--set", "time.end")
    bench.refused(["run", "no_such_case.toml"], ["no_such_case.toml"])
    bench.refused(["run", "."], ["directory"])
    bench.refused(["check", "/dev/zero"], ["/dev/zero"])


def bad_surfaces(bench):
    bench.refused(["measure", "no_such.stl"], ["no_such.stl"])
    bench.refused(["measure", "."], [])
    for file, content, parts in _surfaces.bad_surfaces().values():
        bench.write(file, content)
        bench.refused(["measure", file], parts)
        bench.write("case.toml", FILE_CASE.format(file))
        bench.refused(["run", "case.toml", "--out", "out"], parts)
    ball = bench.write("ball.off", _surfaces.off(_surfaces.icosphere()))
    for spacing in (5, 0.01): # fewer than 500 particles, more than 100 million
        bench.write("case.toml", f'[geometry]\nshape = "file"\nfile = "{ball}"\nspacing_mm = {spacing}\n')
        bench.refused(["run", "case.toml", "--out", "out"], ["particles"])


def bad_folders(bench):
    bench.write("case.toml", "[geometry]\nparticles = 1000\n")
    bench.write("file", "not a folder")
    bench.refused(["run", "case.toml", "--out", "file"], ["file"])
    bench.refused(["run", "case.toml", "--out", "file/run"], ["file"])
    bench.refused(["run", "case.toml", "--out", "/proc/no_such_folder/run"], ["/proc"])


def measure(bench):
    ball = _surfaces.icosphere()
    for file, content, tolerance in (("ball.off", _surfaces.off(ball), 1e-9), ("ball.obj", _surfaces.obj(ball), 1e-9),
                                     ("ball.stl", _surfaces.stl(ball), 1e-5)): # STL holds 32-bit numbers
        bench.write(file, content)
        measures = json.loads(bench.accepted("measure", file, "--json") or "{}")
        bench.check(math.isclose(measures.get("volume_mm3", 0), _surfaces.volume(ball), rel_tol=tolerance),
                    f"measure {file}: volume {measures.get('volume_mm3')}")
        bench.check(abs(measures.get("gi_hull", 0) - 1) < 1e-4, f"measure {file}: gi_hull {measures.get('gi_hull')}")
        bench.check(1 < measures.get("gi_sphere", 0) < 1.05, f"measure {file}: gi_sphere {measures.get('gi_sphere')}")
        bench.check(abs(measures.get("gi_zilles", 0) - 1) < 1e-4, f"measure {file}: gi_zilles {measures.get('gi_zilles')}")
        depth = measures.get("sulcal_depth_max_mm", 1)
        bench.check(abs(depth) < 1e-4, f"measure {file}: sulcal_depth_max_mm {depth} of a convex body")
    closed = json.loads(bench.accepted("measure", "ball.off", "--json", "--outer", "closed") or "{}")
    bench.check(closed.get("sulcal_depth_max_mm", 1) < 1e-4 and abs(closed.get("gi_local_mean", 0) - 1) < 0.01,
                "a convex body has depth or folds below its closed outer surface")
    bench.refused(["measure", "ball.off", "--outer", "box"], ["box", "closed"])
    scaled = json.loads(bench.accepted("measure", "ball.off", "--json", "--unit", "cm") or "{}")
    bench.check(math.isclose(scaled.get("volume_mm3", 0), 1000 * _surfaces.volume(ball), rel_tol=1e-9), "--unit cm")
    bench.check("volume" in bench.accepted("measure", "ball.off"), "measure prints no volume")


def check(bench):
    bench.write("case.toml", "[geometry]\nparticles = 1000\n")
    output = bench.accepted("check", "case.toml", "--set", "tissue.thickness_mm=0.2")
    bench.check("thickness_mm = 0.2" in output, "check does not print the resolved case")
    bench.check("warning" in output and "spacings" in output, "check does not warn of a cortex below two spacings")
    output = bench.accepted("check", "case.toml", "--set", "tissue.thickness_mm=5")
    bench.check("spacings of" not in output, "check warns of a thick cortex")
    bench.check(sorted(path.name for path in bench.folder.iterdir()) == ["case.toml"], "check wrote something")


if __name__ == "__main__":
    _command.main(__doc__, usage, schema, starter, bad_cases, bad_surfaces, bad_folders, measure, check)
