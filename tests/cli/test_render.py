# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a run for papers: views, times, ranges, plots, movies; what is refused."""

import os
import shutil
import struct
import subprocess

import _command

CASE = ('[geometry]\nradius_mm = 10\nparticles = 800\n[tissue]\nthickness_mm = 3\n'
        '[time]\nend = 0.1\n[output]\ncount = 2\npictures = "off"\nreport = "off"\n')


def made_run(bench):
    bench.write("case.toml", CASE)
    bench.accepted("run", "case.toml", "--out", "run", "--quiet", "--threads", "2")


def size_of(png):
    """(width, height, whether it has transparency) of a PNG."""
    width, height, _, kind = struct.unpack(">IIBB", png.read_bytes()[16:26])
    return width, height, kind == 6


def names(folder):
    return sorted(path.name for path in folder.iterdir() if path.name != "corticle-files.txt")


def figures(bench):
    made_run(bench)
    output = bench.accepted("render", "run")
    bench.check(len(list((bench.folder / "run/pictures").glob("*.png"))) == 16, "render alone: not the usual pictures")
    output = bench.accepted("render", "run", "--array", "J,sulcal_depth", "--time", "0,0.1", "--width", "800")
    folder = bench.folder / "run/figures"
    bench.check(names(folder) == ["J_0000.png", "J_0002.png", "sulcal_depth_0000.png", "sulcal_depth_0002.png"],
                f"render wrote {names(folder)}")
    bench.check(output.count("wrote ") == 4, f"render says {output!r}")
    bench.check(len({size_of(path) for path in folder.glob("*.png")}) == 1, "pictures of a series differ in size")
    bench.check(size_of(folder / "J_0000.png")[0] == 800, "--width is not the width")
    bench.refused(["render", "run", "--array", "J"], ["J_0002.png", "--overwrite"])
    bench.accepted("render", "run", "--array", "J", "--overwrite")
    bench.check(size_of(folder / "J_0002.png")[0] == 2000, "--overwrite drew nothing new")

    bench.accepted("render", "run", "--view", "left-medial", "--transparent", "--width", "500", "--out", "one")
    bench.check(names(bench.folder / "one") == ["sulcal_depth_left-medial_0002.png"], "one view is not in the name")
    bench.check(size_of(bench.folder / "one/sulcal_depth_left-medial_0002.png")[2], "--transparent: it is not")

    bench.accepted("render", "run", "--array", "J", "--range=-1,9", "--map", "grey", "--width", "400", "--out", "grey")
    bench.accepted("render", "run", "--array", "J", "--range=-1,3", "--map", "grey", "--width", "400", "--out", "grey3")
    pictures = [(bench.folder / name / "J_0002.png").read_bytes() for name in ("grey", "grey3")]
    bench.check(pictures[0] != pictures[1], "--range changes nothing")

    status, _, errors = bench.call("render", "run", "--time", "0.04", "--width", "400", "--out", "near")
    bench.check(status == 0 and "time 0.05 is shown" in errors, f"--time 0.04: {status}, {errors!r}")


def plots(bench):
    made_run(bench)
    bench.accepted("render", "run", "--plots", "svg,pdf", "--out", "plots")
    bench.check(names(bench.folder / "plots") == ["measures.pdf", "measures.svg"], "plots alone draw more than plots")
    bench.check("gyrification index" in (bench.folder / "plots/measures.svg").read_text(), "SVG: no letters")
    bench.check((bench.folder / "plots/measures.pdf").read_bytes().startswith(b"%PDF"), "PDF: it is none")


def movies(bench):
    made_run(bench)
    movie = ("--movie-frames", "5", "--view", "dorsal", "--width", "401")
    (bench.folder / "bin").mkdir()
    if shutil.which("Xvfb"):
        (bench.folder / "bin/Xvfb").symlink_to(shutil.which("Xvfb"))
    path, os.environ["PATH"] = os.environ["PATH"], str(bench.folder / "bin")  # no ffmpeg
    status, _, errors = bench.call("render", "run", *movie, "--out", "bare")
    os.environ["PATH"] = path
    bench.check(status == 0 and "no MP4: ffmpeg is not installed" in errors, f"without ffmpeg: {status}, {errors!r}")
    bench.check(len(list((bench.folder / "bare").glob("*/*.png"))) == 5, "without ffmpeg: not every frame")
    bench.accepted("render", "run", *movie, "--out", "100%d film")
    folder = bench.folder / "100%d film/sulcal_depth_dorsal_movie"
    bench.check(names(folder) == [f"{k:04}.png" for k in range(1, 6)], f"frames: {names(folder)}")
    frames = [(folder / name).read_bytes() for name in names(folder)]
    bench.check(len(set(frames)) == 5, "frames of the movie are alike")
    mp4 = folder.parent / "sulcal_depth_dorsal.mp4"
    if shutil.which("ffmpeg") is None:
        bench.check(not mp4.exists(), "an MP4 without ffmpeg")
        return
    found = subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-i", f"file:{mp4}", "-f", "framehash", "-"],
                           capture_output=True, text=True)
    count = sum(not line.startswith("#") for line in found.stdout.splitlines())
    bench.check(found.returncode == 0 and count == 5, f"the MP4 has {count} frames; {found.stderr!r}")
    status, _, errors = bench.call("render", "run", *movie, "--transparent", "--out", "glass")
    bench.check(status == 0 and "no transparency" in errors and not list((bench.folder / "glass").glob("*.mp4")),
                f"a transparent MP4: {status}, {errors!r}")


def refusals(bench):
    made_run(bench)
    bench.refused(["render", "run", "--view", "above"], ["above", "left-lateral"])
    bench.refused(["render", "run", "--array", "depth"], ["depth", "sulcal_depth"])
    bench.refused(["render", "run", "--range", "3,1"], ["--range", "lower one first"])
    bench.refused(["render", "run", "--range", "1"], ["--range"])
    bench.refused(["render", "run", "--week", "30"], ["--week", "no weeks"])
    bench.refused(["render", "run", "--time", "nan"], ["--time", "nan"])
    bench.refused(["render", "run", "--width", "20"], ["--width", "300"])
    bench.refused(["render", "run", "--map", "jet"], ["--map", "viridis"])
    bench.refused(["render", "run", "--plots", "eps"], ["--plots", "svg"])
    bench.refused(["render", "nowhere", "--view", "dorsal"], ["nowhere"])


_command.main(__doc__, figures, plots, movies, refusals)
