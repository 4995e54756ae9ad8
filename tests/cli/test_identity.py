#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Input files are known by their content: one that has changed is refused, a project that was moved goes on."""

import hashlib
import json
import shutil
import subprocess
import sys

import _command
import _surfaces

CASE = """[geometry]
shape = "file"
file = "body.off"
particles = 800
[map]
thickness_file = "thickness.txt"
[time]
end = {end}
[output]
count = 1
pictures = "off"
"""
QUIET = ("--quiet", "--threads", "1")


def project(bench, folder="", end=0.02, radius=20.0, thickness=7.0):
    """A case with its surface and a thickness map."""
    surface = _surfaces.icosphere(radius)
    bench.write(f"{folder}case.toml", CASE.format(end=end))
    bench.write(f"{folder}body.off", _surfaces.off(surface))
    bench.write(f"{folder}thickness.txt", f"{thickness}\n" * len(surface[0]))


def changed_inputs(bench):
    """--resume and --body with another surface or another map under the same name."""
    project(bench)
    bench.accepted("prepare", "case.toml", "--out", "body", "--quiet", "--set", "output.pictures=off")
    bench.accepted("run", "case.toml", "--out", "run", *QUIET)
    resumed = ("run", "case.toml", "--out", "run", "--resume", "--set", "time.end=0.03", *QUIET)
    taken = ("run", "case.toml", "--body", "body", "--out", "other", *QUIET)
    project(bench, radius=20.6)
    bench.refused(resumed, ["geometry.file", "body.off has changed", "SHA-256"])
    bench.refused(taken, ["geometry.file", "body.off has changed", "SHA-256"])
    project(bench, thickness=6.5)
    bench.refused(resumed, ["map.thickness_file", "thickness.txt has changed"])
    bench.refused(taken, ["map.thickness_file", "thickness.txt has changed"])
    bench.refused(["run", "run/case.toml", "--out", "again", *QUIET], ["map.thickness_file", "[inputs]"])
    project(bench)
    bench.accepted(*resumed)
    bench.accepted(*taken)


def moved_project(bench):
    project(bench, "one/")
    bench.accepted("run", "one/case.toml", "--out", "run", *QUIET)
    shutil.move(bench.folder / "one", bench.folder / "two")
    bench.accepted("run", "two/case.toml", "--out", "run", "--resume", "--set", "time.end=0.03", *QUIET)


def checksums_of_inputs(bench):
    """The summary and the report of a preparation name each file with the checksum that sha256sum gives."""
    project(bench)
    bench.accepted("prepare", "case.toml", "--out", "body", "--quiet", "--set", "output.pictures=off")
    bench.accepted("run", "case.toml", "--out", "run", *QUIET)
    for name in ("run/summary.json", "body/preparation.json"):
        inputs = json.loads((bench.folder / name).read_text(encoding="utf-8"))["inputs"]
        for key, file in (("geometry.file", "body.off"), ("map.thickness_file", "thickness.txt")):
            expected = hashlib.sha256((bench.folder / file).read_bytes()).hexdigest()
            bench.check(inputs.get(key, {}).get("sha256") == expected, f"{name}: {key} has another checksum: {inputs}")
    summary = json.loads((bench.folder / "run" / "summary.json").read_text(encoding="utf-8"))
    bench.check(summary["versions"] == summary["version"], f"versions: {summary['versions']!r}, {summary['version']!r}")


def sweep(bench):
    """A finished run of a sweep is kept while its files are the same, wherever they lie."""
    project(bench, "one/")
    bench.write("one/sweep.toml", 'base = "case.toml"\nmeasures = ["area_ratio"]\nreference = "none"\n'
                '[[axis]]\nkey = "tissue.alpha_t"\nvalues = [1.0, 2.0]\n')
    listed = ("sweep", "--out", "out", "--list")
    bench.accepted("sweep", "one/sweep.toml", "--out", "out", "--quiet")
    bench.check("2 kept" in bench.accepted(*listed, "one/sweep.toml"), "the runs are not kept")
    shutil.move(bench.folder / "one", bench.folder / "two")
    bench.check("2 kept" in bench.accepted(*listed, "two/sweep.toml"), "the runs of a moved project are not kept")
    project(bench, "two/", thickness=6.5)
    bench.check("0 kept" in bench.accepted(*listed, "two/sweep.toml"), "runs with another map are kept")


def make_fold(bench):
    """scripts/fold.py repeats a run whose map has changed, and no other."""
    project(bench)

    def fold():
        words = [sys.executable, "-B", str(bench.source / "scripts" / "fold.py"), "--command", bench.command, "--case",
                 "case.toml", "--out", "run"]
        done = subprocess.run(words, cwd=bench.folder, capture_output=True, text=True, check=False, timeout=200)
        bench.check(done.returncode == 0, f"fold: exit status {done.returncode}; stderr {done.stderr[-500:]!r}")
        return done.stdout

    bench.check("complete and current" not in fold(), "fold: the first run was not made")
    bench.check("complete and current" in fold(), "fold: a current run was repeated")
    project(bench, thickness=6.5)
    bench.check("complete and current" not in fold(), "fold: a run with another map counts as current")


if __name__ == "__main__":
    _command.main(__doc__, changed_inputs, moved_project, checksums_of_inputs, sweep, make_fold)
