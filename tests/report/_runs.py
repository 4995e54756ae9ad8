# SPDX-License-Identifier: GPL-3.0-or-later
"""Small runs whose reports are looked at."""

SMALL = ("geometry.particles=2500", "output.pictures=off")


def run(bench, name, case, *settings):
    """A run folder runs/NAME with its report; made once."""
    folder = bench.folder / "runs" / name
    if folder.exists():
        return folder
    sets = [part for setting in (*SMALL, *settings) for part in ("--set", setting)]
    bench.accepted("run", case, "--out", f"runs/{name}", "--quiet", *sets, timeout=300)
    return folder


def sphere(bench, name="sphere", *settings):
    return run(bench, name, bench.source / "cases/sphere.toml", "time.end=0.4", "output.count=4", *settings)


def brain(bench, name="brain"):
    """A phantom brain from 24 to 27 weeks."""
    if not (bench.folder / "brain.toml").exists():
        bench.accepted("new", "brain")
    return run(bench, name, "brain.toml", "time.clock=wang", "time.start_week=24", "time.end_week=27", "output.count=3",
               "size.law=quadratic", "geometry.particles=4000")


def weeks(bench, name="weeks"):
    """A phantom brain at each week from 23 to 38."""
    if not (bench.folder / "brain.toml").exists():
        bench.accepted("new", "brain")
    return run(bench, name, "brain.toml", "time.clock=wang", "time.start_week=23", "time.end_week=38", "output.count=15",
               "size.law=quadratic", "output.report=off")
