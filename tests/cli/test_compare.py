# SPDX-License-Identifier: GPL-3.0-or-later
"""`corticle compare`: two runs, a run with itself, a run beside surfaces with their weeks, and what is refused."""

import contextlib
import json
import math
import os
import shutil

import _command
import _surfaces

CASE = ('[geometry]\nparticles = {}\n[tissue]\nlayer = "binary"\nlambda = 0.75\n'
        '[time]\nend = {}\n[output]\ncount = 2\npictures = "off"\n')
MEASURES = ("area_mm2", "volume_mm3", "area_ratio", "gi_hull", "gi_sphere", "J_mean", "energy_elastic")
FRAME_KEYS = ("J_mean_difference", "J_largest_difference", "surface_distance_mean_mm", "surface_distance_95_mm",
              "surface_distance_hausdorff_mm")


@contextlib.contextmanager
def nothing_to_draw_with():
    """Without a display and without Xvfb there are no pictures, which take most of the time."""
    kept = {key: os.environ.pop(key, None) for key in ("DISPLAY", "PATH")}
    os.environ["PATH"] = "/no/such/folder"
    try:
        yield
    finally:
        os.environ.update({key: value for key, value in kept.items() if value is not None})


def make_runs(bench, **cases):
    for name, (particles, end) in cases.items():
        bench.write(f"{name}.toml", CASE.format(particles, end))
        bench.accepted("run", f"{name}.toml", "--out", name, "--quiet")


def compared(bench, *arguments):
    """comparison.json as printed; it must be the file, too."""
    text = bench.accepted("compare", *arguments, "--json")
    out = bench.folder / arguments[arguments.index("--out") + 1]
    bench.check((out / "comparison.json").read_text() == text, f"{out.name}: --json prints another comparison.json")
    bench.check((out / "report.md").is_file(), f"{out.name}: no report.md")
    return json.loads(text)


def check_report(bench, out, has_pictures):
    """The pictures that the report shows exist, whole."""
    folder = bench.folder / out
    report = (folder / "report.md").read_text()
    names = {line.split("(")[-1].rstrip(")") for line in report.splitlines() if line.startswith("![")}
    bench.check(names == {path.name for path in folder.glob("*.png")}, f"{out}: the report shows {names}")
    bench.check(bool(names) == has_pictures, f"{out}: pictures {names}")
    for name in names:
        bench.check((folder / name).read_bytes().startswith(b"\x89PNG"), f"{out}: {name} is no PNG")
    return report


def many_runs(bench):
    """Runs of one body that differ in the imperfection, and what are none of it."""
    names = ("seed1", "seed2", "seed3")
    for seed, name in enumerate(names, 1):
        bench.write(f"{name}.toml", CASE.format(800, 0.3) + f"[imperfection]\nseed = {seed}\n")
        bench.accepted("run", f"{name}.toml", "--out", name, "--quiet")
    found = compared(bench, *names, "--out", "seeds")
    bench.check(found["kind"] == "variation" and found["t"] == 0.3 and found["runs"] == list(names), f"variation: {found['runs']}")
    ends = [json.loads((bench.folder / name / "summary.json").read_text())["area_ratio"] for name in names]
    spread = found["measures"]["area_ratio"]
    bench.check(math.isclose(spread["mean"], sum(ends) / 3, rel_tol=1e-12), f"mean area ratio {spread['mean']} of {ends}")
    bench.check((spread["lowest"], spread["highest"]) == (min(ends), max(ends)), f"range {spread} of {ends}")
    pattern = found["pattern"]["depth_correlation"]
    bench.check(-1 <= pattern["lowest"] <= pattern["mean"] <= pattern["highest"] < 1, f"correlations {pattern}")
    surface = (bench.folder / "seeds" / "variation.vtp").read_bytes()
    bench.check(all(f'Name="{name}"'.encode() in surface for name in ("sulcal_share", "depth_mean", "depth_sd")), "maps in variation.vtp")
    check_report(bench, "seeds", bool(found["pictures"]))
    earlier = compared(bench, *names, "--time", "0.15", "--out", "earlier")
    bench.check(earlier["t"] == 0.15, f"--time 0.15: t = {earlier['t']}")
    same = compared(bench, "seed1", "seed1", "seed1", "--out", "same")["pattern"]["depth_correlation"]
    bench.check(math.isclose(same["mean"], 1.0, rel_tol=1e-9), f"a run beside itself: {same}")
    bench.write("other.toml", CASE.format(900, 0.3))
    bench.accepted("run", "other.toml", "--out", "other", "--quiet")
    bench.refused(("compare", "seed1", "seed2", "other"), ["other: is of another body than seed1"])
    bench.refused(("compare", *names, "--time", "0.2"), ["--time 0.2: seed1 has no output then"])
    bench.refused(("compare", *names, "--time", "0.15", "--time", "0.3"), ["got 2 times for 3 runs; expected one"])
    bench.refused(("compare", "seed1", "seed2", "other.toml@24"), ["other.toml@24: not a folder, among run folders"])


def two_runs(bench):
    make_runs(bench, a=(800, 0.1), b=(1000, 0.1), short=(800, 0.06))
    bench.accepted("compare", "a", "b") # with pictures, where they can be made
    folder = bench.folder / "compare_a_b"
    drawn = json.loads((folder / "comparison.json").read_text())["pictures"]
    report = check_report(bench, "compare_a_b", bool(drawn))
    if drawn:
        bench.check(drawn == ["measures.png", "surface_J_0001.png", "cut_J_0001.png", "surface_J_0002.png",
                              "cut_J_0002.png"], f"pictures: {drawn}")
    else:
        print("no pictures can be made here: not checked")
    bench.check("interpolated" in report and "800 and 1000" in report, "the report does not say interpolated")
    bench.check("`gi_sphere`" in report and "Hausdorff" in report, "the report lacks a table")

    with nothing_to_draw_with():
        compared(bench, "a", "b", "--out", "compare_a_b", "--overwrite")
        check_report(bench, "compare_a_b", False) # the pictures of the earlier comparison are gone
        got = compared(bench, "a", "b", "--out", "ab")
        check_report(bench, "ab", False)
        back = compared(bench, "b", "a", "--out", "ba")
        again = compared(bench, "a", "b", "--out", "again")
        other = compared(bench, "a", "short", "--out", "as", "--time", "0.05")
    bench.check(got["kind"] == "runs" and [run["particles"] for run in got["runs"]] == [800, 1000], "runs")
    bench.check(got == again, "the same comparison gives another result")
    bench.check(len(got["t"]) == 3 and len(got["frames"]) == 3, f"t: {got['t']}")
    for key in MEASURES:
        pair = got["measures"].get(key, {})
        bench.check(all(len(pair.get(part, ())) == 3 for part in ("a", "b", "difference_percent")), f"{key}: {pair}")
        scale = max(abs(value) for value in pair["a"] + pair["b"])
        for a, b, got_percent in zip(pair["a"], pair["b"], pair["difference_percent"]):
            if got_percent is None:
                bench.check(abs(a) < max(0.01 * abs(b), 1e-6 * scale), f"{key}: no difference of {a} and {b} in percent")
            else:
                percent = 100 * (b - a) / abs(a) if a else 0
                bench.check(math.isclose(percent, got_percent, rel_tol=1e-6, abs_tol=1e-9), f"{key}: difference in percent")
        bench.check(pair["difference"] == [b - a for a, b in zip(pair["a"], pair["b"])], f"{key}: differences")
    for there, home in zip(got["frames"], back["frames"]):
        bench.check(there["J_interpolated"] is True and there["J_compared_share"] == 1, f"{there}")
        for key in FRAME_KEYS:
            bench.check(math.isclose(there[key], home[key], rel_tol=1e-9, abs_tol=1e-12), f"{key} is not symmetric")
    bench.check(0 < got["frames"][-1]["J_mean_difference"] < 0.2, f"J at the end: {got['frames'][-1]}")

    # The same body up to t = 0.06: interpolated in time, directly in space; near, but no longer equal.
    bench.check(other["t"] == [0, 0.03, 0.05, 0.06], f"t of a short run: {other['t']}")
    bench.check(len(other["frames"]) == 1 and not other["frames"][0]["J_interpolated"], f"{other['frames']}")


def with_itself(bench):
    make_runs(bench, a=(800, 0.05))
    shutil.copytree(bench.folder / "a", bench.folder / "elsewhere" / "a")
    with nothing_to_draw_with():
        got = compared(bench, "a", "elsewhere/a", "--out", "aa")
    bench.check([run["name"] for run in got["runs"]] == ["a", "elsewhere/a"], "names of runs that are named alike")
    for key, pair in got["measures"].items():
        bench.check(not any(pair["difference_percent"]), f"{key} differs from itself: {pair}")
    for frame in got["frames"]:
        bench.check(not frame["J_interpolated"], "J of a run and itself is interpolated")
        bench.check(frame["J_mean_difference"] == 0 and frame["J_largest_difference"] == 0, f"J: {frame}")
        bench.check(frame["surface_distance_hausdorff_mm"] < 1e-12, f"distances: {frame}")


def beside_real_surfaces(bench):
    make_runs(bench, a=(800, 0.1))
    ball = _surfaces.icosphere()
    bench.write("ball.off", _surfaces.off(ball))
    with nothing_to_draw_with():
        got = compared(bench, "a", "ball.off@t=0.05", "ball.off@t=0.075", "ball.off@t=2", "--out", "real")
        same = compared(bench, "a", "a/surface_0001.vtp@t=0.05", "--out", "same")
        cm = compared(bench, "a", "ball.off@t=0.1", "--unit", "cm", "--out", "cm")
    bench.check(got["kind"] == "real" and got["axis"] == "t" and len(got["t"]) == 3, f"axis: {got['axis']}")
    first, between, beyond = (real["measures"] for real in got["reals"])
    bench.check(math.isclose(first["volume_mm3"]["real"], _surfaces.volume(ball), rel_tol=1e-9), f"{first}")
    area = got["run_measures"]["area_mm2"]
    bench.check(math.isclose(between["area_mm2"]["run"], (area[1] + area[2]) / 2, rel_tol=1e-9), "between two times")
    bench.check(beyond["area_mm2"]["run"] is None, "beyond the run")
    for key, values in same["reals"][0]["measures"].items():
        # Read from a file the vertices stand in another order: round-off, which the wavelength of a body without folds amplifies.
        tolerance = 5.0 if key == "fold_wavelength_mm" else 1e-9
        difference = values["difference"] if values["difference_percent"] is None else values["difference_percent"]
        bench.check(abs(difference) <= tolerance, f"a surface of the run differs from the run in {key}: {values}")
    bench.check(math.isclose(cm["reals"][0]["measures"]["volume_mm3"]["real"], 1000 * _surfaces.volume(ball),
                             rel_tol=1e-9), "--unit cm")

    # A run with a clock: weeks from 22 at t = 0 to 32 at t = 0.1.
    shutil.copytree(bench.folder / "a", bench.folder / "weeks")
    table = bench.folder / "weeks" / "measures.csv"
    rows = [line.split(",") for line in table.read_text().splitlines()]
    bench.check(rows[0][1] == "week [weeks]" and rows[1][1] == "nan", f"weeks without a clock: {rows[0][1]}, {rows[1][1]}")
    for row in rows[1:]:
        row[1] = repr(22 + 100 * float(row[0]))
    table.write_text("".join(",".join(row) + "\n" for row in rows))
    with nothing_to_draw_with():
        got = compared(bench, "weeks", "ball.off@27", "ball.off@t=0.1", "--out", "by_week")
    bench.check(got["axis"] == "week" and [round(week, 9) for week in got["week"]] == [22, 27, 32], f"{got['week']}")
    bench.check(round(got["reals"][1]["week"], 9) == 32, "week of a growth time")
    bench.check(math.isclose(got["reals"][0]["measures"]["area_mm2"]["run"], area[1], rel_tol=1e-9), "at week 27")
    bench.refused(["compare", "weeks", "ball.off@40"], ["week", "22", "32", "ball.off@40"])


def refusals(bench):
    make_runs(bench, a=(800, 0.05))
    bench.write("ball.off", _surfaces.off(_surfaces.icosphere()))
    (bench.folder / "empty").mkdir()
    shutil.copytree(bench.folder / "a", bench.folder / "begun")
    for path in (bench.folder / "begun").iterdir():
        if path.name != "case.toml":
            path.unlink()
    shutil.copytree(bench.folder / "a", bench.folder / "late")
    for name in ("surface.pvd", "particles.pvd"):
        path = bench.folder / "late" / name
        changed = path.read_text().replace('timestep="0"', 'timestep="0.9"', 1)
        path.write_text(changed.rsplit("<!-- checksum", 1)[0])

    bench.refused(["compare"], ["run"])
    bench.refused(["compare", "a"], ["required"])
    bench.refused(["compare", "a", "no_such_run"], ["no_such_run", "FILE@WEEK"])
    bench.refused(["compare", "no_such_run", "a"], ["no_such_run", "run folder"])
    bench.refused(["compare", "a", "empty"], ["empty", "not a run folder"])
    bench.refused(["compare", "begun", "a"], ["begun", "no frames"])
    bench.refused(["compare", "a", "ball.off"], ["ball.off", "FILE@WEEK"])
    bench.refused(["compare", "a", "ball.off@"], ["ball.off@", "not a number"])
    bench.refused(["compare", "a", "ball.off@nan"], ["ball.off@nan", "not a number"])
    bench.refused(["compare", "a", "ball.off@30"], ["no weeks", "FILE@t=T"])
    bench.refused(["compare", "a", "ball.off@t=0.9"], ["no common times", "0.05"])
    bench.refused(["compare", "a", "no_such.off@t=0.05"], ["no_such.off"])
    bench.refused(["compare", "a", "a", "--time", "0.5"], ["--time", "0.05"])
    bench.refused(["compare", "a", "a", "--out", "a"], ["--out", "holds a run"])
    bench.refused(["compare", "a", "a", "--out", "ball.off"], ["--out", "ball.off"])
    bench.refused(["compare", "a", "late"], ["late", "ascending"])

    def damaged(name, change, parts):
        kept = (bench.folder / "begun" / name).read_bytes()
        bench.write(f"begun/{name}", change(kept))
        bench.refused(["compare", "a", "begun"], parts)
        bench.write(f"begun/{name}", kept)

    shutil.rmtree(bench.folder / "begun")
    shutil.copytree(bench.folder / "a", bench.folder / "begun")
    damaged("measures.csv", lambda text: b"", ["measures.csv"])
    damaged("measures.csv", lambda text: b"a,b\n1,2\n", ["measures.csv", "column t"])
    damaged("measures.csv", lambda text: text.replace(b",", b",x", 200), ["measures.csv"])
    damaged("measures.csv", lambda text: text.splitlines()[0] + b"\n", ["measures.csv", "no rows"])
    damaged("surface_0002.vtp", lambda data: data[:len(data) // 2], ["surface_0002.vtp"])
    damaged("particles_0001.vtu", lambda data: data.replace(b'"F"', b'"G"'), ["particles_0001.vtu", "F"])
    damaged("particles.pvd", lambda text: b"", ["particles.pvd"])


if __name__ == "__main__":
    _command.main(__doc__, two_runs, many_runs, with_itself, beside_real_surfaces, refusals)
