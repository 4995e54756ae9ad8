#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps: all runs made, none twice, whatever stops them; a failed run is a row; bad files are refused."""

import csv
import json
import os
import signal
import sys
import time

import _command
from _run_folders import check_same, stop, temporaries, wait_for

BASE = """[geometry]
particles = 800
[tissue]
thickness_mm = 3.0
[time]
end = 0.02
[output]
count = 2
pictures = "off"
checkpoint_minutes = 0.001
"""
SWEEP = """title = "Two by two"
base = "base.toml"
reference = "finest"
measures = ["particles", "gi_hull", "J_max", "gi_hull@0.01"]
plots = ["gi_hull"]
[[axis]]
key = "solver.cfl"
values = [0.3, 0.6]
[[axis]]
key = "geometry.particles"
values = [600, 800]
"""
PLAIN = SWEEP.replace("[[axis]]", "pictures = false\n[[axis]]", 1)
SWEEP_OF = ("sweep", "sweep.toml", "--out", "S")


def write(bench, sweep=PLAIN, base=BASE):
    bench.write("base.toml", base)
    bench.write("sweep.toml", sweep)


def rows(bench, out="S"):
    with open(bench.folder / out / "sweep.csv", encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def made(bench, out="S"):
    """What shows whether a run was made again: its log, by the name of its folder."""
    return {path.parent.name: path.read_bytes() for path in (bench.folder / out / "runs").glob("*/run.log")}


def check_kept(bench, before, out="S"):
    after = made(bench, out)
    for name, log in before.items():
        bench.check(after.get(name) == log, f"run {name} was made again")


def whole_sweep(bench):
    """A 2x2 sweep, its tables, and the same runs as `corticle run` makes."""
    write(bench, SWEEP)
    output = bench.accepted(*SWEEP_OF)
    bench.check("4 completed, 0 failed" in output, f"it says {output!r}")
    table = rows(bench)
    names = [f"cfl-{cfl}_particles-{size}" for cfl in (0.3, 0.6) for size in (600, 800)]
    bench.check([row["name"] for row in table] == names, f"runs {[row['name'] for row in table]}")
    for row in table:
        bench.check(row["status"] == "completed" and row["reason"] == "" and float(row["t"]) == 0.02, f"row {row}")
        bench.check(row["particles"] == row["geometry.particles"], f"{row['name']}: {row['particles']} particles")
        bench.check(float(row["wall_s"]) > 0 and float(row["step_s"]) > 0 and int(float(row["steps"])) > 0, f"row {row}")
        bench.check(row["reference"] == "cfl-0.3_particles-800", f"{row['name']}: reference {row['reference']}")
        bench.check(0.9 < float(row["gi_hull@0.01"]) < 1.1, f"{row['name']}: gi_hull@0.01 is {row['gi_hull@0.01']}")
        bench.check(float(row["md_J_t"]) == 0.02, f"{row['name']}: J compared at {row['md_J_t']}")
    md = {row["name"]: float(row["md_J"]) for row in table}
    bench.check(md["cfl-0.3_particles-800"] == 0.0 < md["cfl-0.6_particles-800"] < md["cfl-0.6_particles-600"], f"MD {md}")
    document = json.loads((bench.folder / "S/sweep.json").read_text(encoding="utf-8"))
    bench.check([run["name"] for run in document["runs"]] == names, "sweep.json holds other runs")
    text = (bench.folder / "S/sweep.md").read_text(encoding="utf-8")
    for part in ("# Two by two", "MD of J", "reference", "`gi_hull`"):
        bench.check(part in text, f"sweep.md lacks {part}")
    for picture in document["pictures"]:
        bench.check((bench.folder / "S" / picture).stat().st_size > 1000 and picture in text, f"picture {picture}")
    bench.check(len(document["pictures"]) in (0, 5), f"pictures {document['pictures']}")
    bench.accepted("run", "base.toml", "--set", "solver.cfl=0.6", "--set", "geometry.particles=600", "--out", "alone", "--quiet")
    check_same(bench, "alone", "S/runs/cfl-0.6_particles-600", "in a sweep and alone", also_volatile=["threads"])
    before = made(bench)
    write(bench)
    bench.check("4 kept" in bench.accepted(*SWEEP_OF), "the finished sweep is not said to be kept")
    check_kept(bench, before)
    known = [key for key, value in document["runs"][0]["summary"].items() if isinstance(value, (int, float))]
    write(bench, SWEEP.replace('"particles", "gi_hull", "J_max",', json.dumps(known)[1:-1] + ","))
    bench.accepted(*SWEEP_OF, "--list")


def alive(folder):
    """Processes that still work for a sweep."""
    found = []
    for entry in os.listdir("/proc"):
        try:
            if entry.isdigit() and os.fsencode(folder) in open(f"/proc/{entry}/cmdline", "rb").read():
                found.append(int(entry))
        except OSError:
            pass
    return found


LONG = BASE.replace("end = 0.02", "end = 0.3").replace("count = 2", "count = 10")


def begun(bench, count):
    """A condition: so many runs have come past their first output time."""
    return lambda: len(list((bench.folder / "S/runs").glob("*/surface_0003.vtp"))) >= count


def killed(bench):
    """SIGKILL amid the runs, then the same call: no finished run again, the bits of a sweep that was never stopped."""
    write(bench, base=LONG)
    bench.accepted("sweep", "sweep.toml", "--out", "whole", "--quiet")
    process = bench.start(*SWEEP_OF, "--jobs", "1", "--threads-per-run", "1")
    bench.check(wait_for(process, begun(bench, 2), 120), "no second run was begun")
    status, _ = stop(process, signal.SIGKILL)
    bench.check(status == -signal.SIGKILL, f"the kill missed the sweep: status {status}")
    finished = {name for name in made(bench) if (bench.folder / "S/runs" / name / "summary.json").is_file()}
    before = {name: log for name, log in made(bench).items() if name in finished}
    unfinished = set(made(bench)) - finished
    bench.check(finished and unfinished, f"finished {finished}, unfinished {unfinished}: the kill came at a bad time")
    output = bench.accepted(*SWEEP_OF)
    bench.check("4 completed" in output, f"resumed: {output!r}")
    check_kept(bench, before)
    for name in unfinished:
        bench.check(b"resumed at t" in made(bench)[name], f"{name} did not go on from its checkpoint")
    for row in rows(bench):
        check_same(bench, f"whole/runs/{row['name']}", f"S/runs/{row['name']}", "killed and resumed", also_volatile=["threads"])
    bench.check(temporaries(bench.folder / "S") == [], f"left behind: {temporaries(bench.folder / 'S')}")


def interrupted(bench):
    """SIGINT and SIGTERM: exit status 130, the processes ended with their checkpoints, the tables say so; it goes on."""
    write(bench, base=LONG.replace("end = 0.3", "end = 0.6"))
    for number, count in ((signal.SIGINT, 1), (signal.SIGTERM, 2)):
        process = bench.start(*SWEEP_OF, "--jobs", "2")
        bench.check(wait_for(process, lambda: begun(bench, count)() and alive(bench.folder / "S"), 120), "runs were not begun")
        other, _, errors = bench.call(*SWEEP_OF)
        bench.check(other == 2 and "another process" in errors, f"two sweeps in one folder: {other}, {errors!r}")
        status, errors = stop(process, number)
        bench.check(status == 130, f"{number!r}: exit status {status}, expected 130; stderr {errors!r}")
        bench.check(alive(bench.folder / "S") == [], f"{number!r}: processes are left")
        states = [row["status"] for row in rows(bench)]
        bench.check(set(states) <= {"interrupted", "pending", "completed"} and "interrupted" in states, f"states {states}")
    bench.check("4 completed" in bench.accepted(*SWEEP_OF), "it did not go on")


def orphans(bench):
    """The processes of a killed sweep end by themselves."""
    write(bench, base=LONG.replace("end = 0.3", "end = 1.0"))
    process = bench.start(*SWEEP_OF, "--jobs", "2")
    bench.check(wait_for(process, begun(bench, 1), 120), "runs were not begun")
    stop(process, signal.SIGKILL)
    deadline = time.monotonic() + 20
    while alive(bench.folder / "S") and time.monotonic() < deadline:
        time.sleep(0.05)
    bench.check(alive(bench.folder / "S") == [], "processes of a killed sweep go on")


def failed(bench):
    """Runs that cannot write, that crash and whose body cannot be prepared: rows with reasons; the others are made."""
    bench.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    sweep = """base = "base.toml"
reference = "none"
pictures = false
[[axis]]
key = "geometry.shape"
values = ["sphere", "ellipsoid", "file"]
zip = "body"
[[axis]]
key = "geometry.file"
values = ["", "", "open.off"]
zip = "body"
names = ["sphere", "ellipsoid", "file"]
"""
    write(bench, sweep)
    blocked = bench.folder / "S/runs/ellipsoid/surface.pvd"
    blocked.mkdir(parents=True)
    bench.check("1 completed, 2 failed" in bench.accepted(*SWEEP_OF), "it does not count the failures")
    table = rows(bench)
    bench.check([row["status"] for row in table] == ["completed", "failed", "failed"], f"rows {table}")
    for row, part in zip(table, ("", "surface.pvd", "open.off")):
        bench.check(part in row["reason"] and bool(part) == bool(row["reason"]), f"reason {row['reason']!r}")
        bench.check(part in (bench.folder / "S/sweep.md").read_text(encoding="utf-8"), f"sweep.md does not say {part}")
    bench.check(table[0]["md_J"] == "", "compared without a reference")
    before = made(bench)
    bench.accepted(*SWEEP_OF)
    check_kept(bench, before)
    blocked.rmdir()
    bench.accepted(*SWEEP_OF, "--retry")
    bench.check([row["status"] for row in rows(bench)] == ["completed", "completed", "failed"], f"retried: {rows(bench)}")


def crashed(bench):
    """A run that a signal ends is a row; the next call goes on with it."""
    write(bench, base=LONG)
    process = bench.start(*SWEEP_OF, "--jobs", "1")
    bench.check(wait_for(process, lambda: begun(bench, 1)() and alive(bench.folder / "S"), 120), "no run was begun")
    for number in alive(bench.folder / "S"):
        os.kill(number, signal.SIGSEGV)
    output, errors = process.communicate(timeout=120)
    bench.check(process.returncode == 0 and "3 completed, 1 failed" in output, f"{process.returncode} {output!r} {errors!r}")
    reasons = [row["reason"] for row in rows(bench) if row["status"] == "failed"]
    bench.check(len(reasons) == 1 and "signal 11" in reasons[0], f"reasons {reasons}")
    bench.check("4 completed" in bench.accepted(*SWEEP_OF), "it did not go on with the run that crashed")


def changed(bench):
    """Axes restricted, extended and renamed: runs of the same case are kept, others are left alone."""
    write(bench)
    bench.accepted(*SWEEP_OF, "--only", "1")
    bench.check([row["status"] for row in rows(bench)] == ["completed"] + 3 * ["pending"], "--only 1 made others")
    bench.accepted(*SWEEP_OF, "--only", "cfl-0.3_particles-800", "--only", "geometry.particles=600")
    bench.check([row["status"] for row in rows(bench)] == 3 * ["completed"] + ["pending"], "--only made others")
    before = made(bench)
    write(bench, PLAIN.replace("[0.3, 0.6]", "[0.3]"))
    output = bench.accepted(*SWEEP_OF)
    bench.check("2 runs: 2 kept" in output and "1 other run" in output, f"restricted: {output!r}")
    check_kept(bench, before)
    write(bench, PLAIN.replace("[0.3, 0.6]", "[0.3, 0.45, 0.6]"))
    output = bench.accepted(*SWEEP_OF)
    bench.check("6 runs: 3 kept" in output and "6 completed" in output, f"extended: {output!r}")
    check_kept(bench, before)
    before = made(bench)
    named = PLAIN.replace("values = [600, 800]", 'values = [600, 800]\nnames = ["coarse", "fine"]')
    write(bench, named.replace("[0.3, 0.6]", "[0.6]"), base=BASE.replace('"off"', '"on"'))
    bench.check("2 runs: 2 kept" in bench.accepted(*SWEEP_OF), "other names and pictures: made again")
    bench.check([row["name"] for row in rows(bench)] == ["cfl-0.6_coarse", "cfl-0.6_fine"], "names are not taken")
    check_kept(bench, before)
    write(bench, base=BASE.replace("3.0", "3.1"))
    bench.check("0 kept" in bench.accepted(*SWEEP_OF, "--only", "1"), "another base: runs were kept")
    check_kept(bench, before)
    bench.check((bench.folder / "S/runs/cfl-0.3_particles-600_2/summary.json").is_file(), "no folder for the other base")


def warned(bench):
    """What a run warns of is said by the sweep, when the run ends and in the tables."""
    write(bench, 'base = "base.toml"\npictures = false\n[[axis]]\nkey = "tissue.thickness_mm"\nvalues = [0.5, 5]\n')
    status, _, errors = bench.call(*SWEEP_OF, "--set", "time.end=0.001")
    lines = errors.splitlines()
    bench.check(status == 0 and lines and all(line.startswith("corticle: warning: thickness_mm-0.5: ") for line in lines),
                f"warnings: {status} {errors!r}")
    bench.check("two spacings" in errors, f"the thin cortex is not warned of: {errors!r}")
    document = json.loads((bench.folder / "S/sweep.json").read_text(encoding="utf-8"))
    bench.check([bool(run["warnings"]) for run in document["runs"]] == [True, False], "sweep.json: warnings")
    bench.check("Warnings of the runs" in (bench.folder / "S/sweep.md").read_text(encoding="utf-8"), "sweep.md: warnings")
    bench.check(bench.call(*SWEEP_OF, "--set", "time.end=0.002", "--quiet")[2] == "", "--quiet shows warnings")


def zipped(bench):
    """Zipped axes, ranges, settings from the command line, a reference by values."""
    sweep = """base = "base.toml"
reference = { solver.cfl = 0.2 }
compare_t = [0.015, 1.0]
pictures = false
[set]
tissue.mu_white = 1.5
[[axis]]
key = "solver.cfl"
start = 0.2
stop = 0.8
count = 3
spacing = "log"
zip = "a"
[[axis]]
key = "tissue.mu_cortex"
start = 1
stop = 2
step = 0.5
zip = "a"
[[axis]]
key = "tissue.layer"
values = ["smooth", "binary"]
"""
    write(bench, sweep)
    bench.accepted(*SWEEP_OF, "--set", "geometry.particles=500")
    table = rows(bench)
    got = [(float(row["solver.cfl"]), float(row["tissue.mu_cortex"]), row["tissue.layer"]) for row in table]
    expected = [(cfl, mu, layer) for cfl, mu in ((0.2, 1.0), (0.4, 1.5), (0.8, 2.0)) for layer in ("smooth", "binary")]
    bench.check(got == expected, f"runs {got}")
    for row in table:
        bench.check(row["reference"] == f"cfl-0.2_mu_cortex-1_layer-{row['tissue.layer']}", f"reference {row['reference']}")
        times = (float(row["md_J_t@0.015"]), float(row["md_J_t@1"]))
        bench.check(times == (0.01, 0.02), f"{row['name']}: J compared at {times}")
        case = (bench.folder / "S" / row["folder"] / "case.toml").read_text(encoding="utf-8")
        bench.check("mu_white = 1.5" in case and "particles = 500" in case, f"{row['name']}: settings are not in its case")


def cases_only(bench):
    """The cases of a sweep, run elsewhere, are gathered by it."""
    write(bench)
    bench.accepted(*SWEEP_OF, "--cases-only")
    cases = sorted((bench.folder / "S/cases").glob("*.toml"))
    bench.check(len(cases) == 4 and made(bench) == {}, f"cases {cases}, runs {made(bench)}")
    for case in cases:
        bench.accepted("run", case, "--out", f"S/runs/{case.stem}", "--resume", "--quiet")
    bench.check("4 runs: 4 kept" in bench.accepted(*SWEEP_OF), "runs made elsewhere are not kept")
    bench.check([row["status"] for row in rows(bench)] == 4 * ["completed"], f"rows {rows(bench)}")


def refusals(bench):
    def refused(old, new, *parts, more=()):
        assert old in SWEEP or not old
        write(bench, SWEEP.replace(old, new) if old else new + SWEEP)
        bench.refused([*SWEEP_OF, *more], parts)

    write(bench)
    bench.refused(["sweep"], ["sweep"])
    bench.refused(["sweep", "none.toml"], ["none.toml"])
    bench.refused([*SWEEP_OF, "--jobs", "0"], ["--jobs"])
    bench.refused([*SWEEP_OF, "--only", "5"], ["--only 5", "4"])
    bench.refused([*SWEEP_OF, "--only", "solver.cfl=7"], ["solver.cfl=7"])
    bench.refused([*SWEEP_OF, "--set", "solver.cfl=0.5"], ["solver.cfl", "axis"])
    bench.refused([*SWEEP_OF, "--set", "solver.clf=0.5"], ["solver.clf", "solver.cfl?"])
    refused("solver.cfl", "solver.clf", "sweep.toml:7", "solver.clf", "solver.cfl?")
    refused("[0.3, 0.6]", "[0.3, 1.6]", "sweep.toml:6", "solver.cfl", "1.6", "(0, 1]")
    refused("[0.3, 0.6]", '[0.3, "a"]', "sweep.toml:6", "solver.cfl", '"a"')
    refused("[0.3, 0.6]", "[0.3, 0.3]", "cfl-0.3")
    refused("[0.3, 0.6]", "[]", "sweep.toml:8", "values")
    refused("values = [0.3, 0.6]", "start = 0.1", "sweep.toml:6", "stop")
    refused("values = [0.3, 0.6]", "start = 0.1\nstop = 1\ncount = 100000000", "count")
    refused("values = [0.3, 0.6]", "start = 0\nstop = 1\ncount = 3\nspacing = \"log\"", "logarithmic")
    refused("values = [0.3, 0.6]", "start = 0\nstop = 1\nstep = 0", "step")
    refused("[0.3, 0.6]", "[0.3, 0.6]\nvaleus = 1", "valeus", "sweep.toml:9")
    refused('"geometry.particles"\nvalues = [600, 800]', '"solver.cfl"\nvalues = [0.1]', "two axes", "solver.cfl")
    refused("[600, 800]", "[600, 499]", "499", "500")
    refused("[600, 800]", "[600.5]", "geometry.particles", "integer")
    refused("[600, 800]", "[600, 700, 800]\nzip = \"a\"\n[[axis]]\nkey = \"geometry.seed\"\nvalues = [1]\nzip = \"a\"", "zipped")
    refused("[600, 800]", "[600, 800]\nnames = [\"a\"]", "names")
    refused("[600, 800]", "[600, 800]\nnames = [\"../a\", \"b\"]", "names", "../a")
    for name in ("", "a\\nb", "\\u0007"):
        refused("[600, 800]", f'[600, 800]\nnames = ["{name}", "b"]', "names of an axis", "sweep.toml:12", "letters, digits")
    refused('"J_max"', '""', "measures (sweep.toml:4)", "not empty")
    refused('base = "base.toml"\n', "", "base")
    refused("base.toml", "other.toml", "other.toml")
    refused('"finest"', '"coarsest"', "coarsest", "finest")
    refused('"finest"', "9", "reference", "9")
    refused('"finest"', "{ solver.cfl = 0.4 }", "reference", "sweep.toml:3")
    refused('"finest"', "{ tissue.mu_cortex = 1.0 }", "tissue.mu_cortex")
    refused('"J_max"', '"J_most"', "J_most", "sweep.toml:4")
    refused('"J_max"', '"J_max@2"', "J_max@2")
    refused('["gi_hull"]', '["gi_hul"]', "gi_hul", "plots")
    refused("", "[set]\nsolver.cfl = 0.4\n", "unknown key title")
    refused("[[axis]]\nkey = \"solver.cfl\"", "[set]\nsolver.cfl = 0.4\n[[axis]]\nkey = \"solver.cfl\"", "solver.cfl", "[set]")
    refused("[[axis]]\nkey = \"solver.cfl\"", "[set]\ntissue.lambda = 0.5\n[[axis]]\nkey = \"solver.cfl\"",
            "run cfl-0.3_particles-600", "tissue.lambda")
    refused("", "compare_t = [0.2, 0.1]\n", "compare_t", "increasing")
    refused("", "compare_t = \"end\"\n", "compare_t", "sweep.toml:1")
    refused("", "colour = 1\n", "colour", "sweep.toml:1")
    refused("", "axis = 3\n", "sweep.toml")
    refused("values = [0.3, 0.6]", "values = [0.3, 0.6]\n[[line]]\naxis = \"a\"\nmeasure = \"b\"\nlabel = \"c\"", "line")
    bench.write("sweep.toml", b"\xff\xfe\x00")
    bench.refused(SWEEP_OF, ["sweep.toml"])
    bench.refused(["sweep", "/dev/zero"], ["/dev/zero"])
    many = SWEEP.replace("[0.3, 0.6]", str([0.1 + 0.001 * i for i in range(200)])).replace("[600, 800]", str(list(range(600, 700))))
    write(bench, many)
    bench.refused(SWEEP_OF, ["10000"])
    write(bench)
    bench.accepted("run", "base.toml", "--out", "R", "--quiet")
    bench.refused(["sweep", "sweep.toml", "--out", "R"], ["--out", "R: holds a run"])


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)
    _command.main(__doc__, whole_sweep, killed, interrupted, orphans, failed, crashed, changed, warned, zipped, cases_only, refusals)
