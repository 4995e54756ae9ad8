# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program did not write is neither replaced nor removed, whatever its name and whichever the command."""

import shutil

import _command
import _surfaces

CASE = ('[geometry]\nparticles = 600\n[tissue]\nthickness_mm = 5\n[time]\nend = 0.02\n[output]\ncount = 1\n'
        'pictures = "off"\n')
LIST = "corticle-files.txt"
# Named as files of a run are, or nearly so.
MINE = ("surface_lh.vtp", "cut_list.png", ".x.tmp", ".measures.csv.tmp", "particles_mine.vtu", "pictures/surface_mine.png",
        "surface_0009.vtp", "notes.txt")


def write_mine(bench, folder, names=MINE):
    for name in names:
        bench.write(f"{folder}/{name}", f"mine: {name}")


def check_mine(bench, folder, how, names=MINE):
    for name in names:
        path = bench.folder / folder / name
        bench.check(path.is_file() and path.read_text() == f"mine: {name}", f"{how}: {folder}/{name} is lost or changed")


def runs(bench):
    """Beside files of the user a run is made, resumed and replaced; in place of one it is not."""
    bench.write("case.toml", CASE)
    write_mine(bench, "u")
    run = ("run", "case.toml", "--out", "u", "--quiet")
    for how in ((), ("--overwrite",), ("--resume",)):
        bench.accepted(*run, *how)
        check_mine(bench, "u", f"run {how}")
    listed = set((bench.folder / "u" / LIST).read_text().splitlines()[1:])
    written = {str(path.relative_to(bench.folder / "u")) for path in (bench.folder / "u").rglob("*") if path.is_file()}
    bench.check(listed == written - set(MINE) - {LIST}, f"the list differs from what was written: {listed ^ written}")
    bench.accepted(*run, "--overwrite", "--set", "output.count=2")
    bench.accepted(*run, "--overwrite")
    bench.check(not (bench.folder / "u/surface_0002.vtp").exists(), "--overwrite left a file of the earlier run")
    bench.refused(run, ["--out u", "holds a run already"])
    for name in ("measures.csv", "surface_0001.vtp", "run.log", "checkpoint.h5", "case.toml"):
        for how in ((), ("--overwrite",), ("--resume",)):
            write_mine(bench, "v", [name])
            bench.refused(["run", "case.toml", "--out", "v", *how], ["--out v", name, "in the way"])
            check_mine(bench, "v", f"run {how}", [name])
            shutil.rmtree(bench.folder / "v")
    bench.write("w/pictures", "a file where a folder is wanted")
    bench.refused(["run", "case.toml", "--out", "w", "--set", "output.pictures=on"], ["--out w", "pictures"])
    # As the program left folders before it kept lists.
    (bench.folder / "u" / LIST).unlink()
    for how in ((), ("--overwrite",), ("--resume",)):
        bench.refused([*run, *how], ["--out u", LIST])
    bench.write(f"u/{LIST}", "surface_lh.vtp\n")
    bench.refused([*run, "--overwrite"], [LIST])


def here(bench):
    """A case folded in its own folder, beside its own surface."""
    bench.write("u/surface_lh.off", _surfaces.off(_surfaces.icosphere()))
    bench.write("u/mine.toml", CASE.replace("[tissue]", 'shape = "file"\nfile = "surface_lh.off"\nunit = "cm"\n[tissue]'))
    write_mine(bench, "u")
    bench.write("u/measures.csv", "mine: measures.csv")
    status, _, errors = bench.call("run", "u/mine.toml", "--out", "u")
    bench.check(status == 2 and "measures.csv" in errors, f"over a table of mine: {status} {errors!r}")
    check_mine(bench, "u", "refused", (*MINE, "measures.csv"))


def preparations(bench):
    bench.write("case.toml", CASE)
    prepare = ("prepare", "case.toml", "--out", "p", "--quiet")
    write_mine(bench, "p", ["notes.txt", "pictures/mine.png", "surface_lh.vtp"])
    bench.accepted(*prepare)
    bench.refused(prepare, ["--out p", "prepared body already"])
    bench.accepted(*prepare, "--overwrite")
    check_mine(bench, "p", "prepare", ["notes.txt", "pictures/mine.png", "surface_lh.vtp"])
    bench.refused(["run", "case.toml", "--out", "p", "--overwrite"], ["--out p", "holds a prepared body"])
    for name in ("surface.vtp", "body.h5", "case.toml"):
        write_mine(bench, "q", [name])
        bench.refused(["prepare", "case.toml", "--out", "q", "--overwrite"], ["--out q", name])
        shutil.rmtree(bench.folder / "q")


def reports(bench):
    """Comparisons, exports and pictures of two runs of the same name."""
    bench.write("case.toml", CASE)
    for name, value in (("a", 1.0), ("b", 1.5), ("c", 2.0)):
        bench.accepted("run", "case.toml", "--set", f"tissue.alpha_t={value}", "--out", f"{name}/run", "--quiet")
    bench.accepted("compare", "a/run", "b/run")
    bench.accepted("compare", "a/run", "c/run")
    bench.accepted("compare", "a/run", "a/run/surface_0001.vtp@t=0.02")
    folders = sorted(path.name for path in bench.folder.glob("compare_*"))
    bench.check(len(folders) == 3, f"three comparisons went to {folders}")
    bench.refused(["compare", "a/run", "b/run"], ["holds a report"])
    bench.accepted("compare", "a/run", "b/run", "--overwrite")
    for name in ("report.md", "comparison.json"):
        write_mine(bench, "notes", [name])
        for others in (["b/run"], ["a/run/surface_0001.vtp@t=0.02"]):
            bench.refused(["compare", "a/run", *others, "--out", "notes", "--overwrite"], ["--out notes", name])
        shutil.rmtree(bench.folder / "notes")

    export = ("export", "a/run", "--format", "ply", "--out", "e")
    write_mine(bench, "e", ["notes.txt"])
    bench.accepted(*export)
    bench.accepted(*export, "--time", "0")
    bench.refused(export, ["--out e", "surface_t0.020.ply", "earlier export"])
    bench.refused(["export", "b/run", "--format", "ply", "--out", "e"], ["--out e", "surface_t0.020.ply"])
    bench.accepted(*export, "--overwrite")
    check_mine(bench, "e", "export", ["notes.txt"])
    write_mine(bench, "f", ["surface_t0.020.stl"])
    bench.refused(["export", "a/run", "--format", "stl", "--out", "f", "--overwrite"], ["--out f", "surface_t0.020.stl"])

    write_mine(bench, "a/run", ["pictures/cut_0001.png"])
    bench.refused(["render", "a/run"], ["a/run", "pictures/cut_0001.png"])

    bench.write("points.csv", "x,y,z\n" + "".join(f"{i % 4},{i // 4 % 4},{i // 16}\n" for i in range(64)))
    write_mine(bench, ".", ["out.vtp"])
    bench.refused(["measure", "points.csv", "--surface", "delaunay", "--out", "out.vtp"], ["--out out.vtp"])


def sweeps(bench):
    bench.write("case.toml", CASE)
    bench.write("sweep.toml", 'base = "case.toml"\npictures = false\n[[axis]]\nkey = "geometry.seed"\nvalues = [1, 2]\n')
    write_mine(bench, "S", ["notes.txt", "cases/mine.toml"])
    bench.accepted("sweep", "sweep.toml", "--out", "S", "--quiet")
    bench.accepted("sweep", "sweep.toml", "--out", "S", "--quiet")
    check_mine(bench, "S", "sweep", ["notes.txt", "cases/mine.toml"])
    for name in ("sweep.csv", "cases/seed-1.toml"):
        write_mine(bench, "T", [name])
        bench.refused(["sweep", "sweep.toml", "--out", "T"], ["--out", name])
        shutil.rmtree(bench.folder / "T")


def names(bench):
    """Names that the system does not take are a line, and so are values that a resumed run cannot reach."""
    bench.write("case.toml", CASE)
    longest = 300 * "x"
    bench.refused(["run", "case.toml", "--out", longest], ["--out", "too long"])
    bench.refused(["prepare", "case.toml", "--out", longest], ["--out", "too long"])
    bench.refused(["run", "case.toml", "--body", longest], ["too long"])
    bench.accepted("run", "case.toml", "--out", "r", "--quiet")
    for command in (["export", "r", "--format", "ply", "--out", longest], ["compare", "r", "r", "--out", longest]):
        bench.refused(command, ["--out", "too long"])
    for command in (["export", longest, "--format", "ply"], ["compare", longest, "r"], ["render", longest]):
        bench.refused(command)
    bench.refused(["run", "case.toml", "--out", "r", "--resume", "--set", "time.end=0.01"], ["--resume r", "0.02", "0.01"])
    bench.accepted("run", "case.toml", "--out", "r", "--resume", "--quiet", "--set", "time.end=0.03")


if __name__ == "__main__":
    _command.main(__doc__, runs, here, preparations, reports, sweeps, names)
