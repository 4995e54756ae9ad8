#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits and sensitivity analyses: what is found, the same bytes after any interruption, failed runs recorded, refusals."""

import csv
import json
import signal
import sys
import xml.etree.ElementTree

import _command
from _run_folders import stop, temporaries, wait_for

BASE = """[geometry]
particles = 500
[tissue]
thickness_mm = 4.0
[time]
end = 0.02
[output]
count = 2
"""
PARAMETERS = """[[parameter]]
key = "tissue.alpha_t"
low = 1.0
high = 3.0
[[parameter]]
key = "tissue.alpha_white"
low = 0.2
high = 0.8
scale = "log"
"""
# Of a run with alpha_t = 2 and alpha_white = 0.4, see truth().
TARGETS = """[[target]]
measure = "volume_ratio"
t = 0.02
value = {volume_ratio}
relative_sd = 0.0002
[[target]]
measure = "cortex_volume_mm3"
t = 0.02
value = {cortex_volume_mm3}
relative_sd = 0.0002
[[predict]]
measure = "area_ratio"
t = [0.01, 0.02]
"""
SURROGATE = """[surrogate]
points = 8
refinements = 1
share = 1e-9
runs_a_round = 2
[posterior]
samples = 2000
"""
FIT_OF = ("fit", "fit.toml", "--out", "F", "--jobs", "2")


def truth(bench):
    bench.write("base.toml", BASE)
    bench.accepted("run", "base.toml", "--out", "T", "--overwrite", "--quiet", "--set", "tissue.alpha_t=2", "--set", "tissue.alpha_white=0.4",
                   "--set", "output.pictures=off", "--set", "output.report=off")
    with open(bench.folder / "T/measures.csv", encoding="utf-8", newline="") as stream:
        row = {key.split(" ")[0]: value for key, value in list(csv.DictReader(stream))[-1].items()}
    return TARGETS.format(**row)


def write(bench, *parts):
    bench.write("fit.toml", 'base = "base.toml"\ntitle = "Two & two"\n' + "".join(parts))


def document(bench, out="F"):
    return json.loads((bench.folder / out / "fit.json").read_text(encoding="utf-8"))


def rows(bench, out="F"):
    with open(bench.folder / out / "evaluations.csv", encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def results(bench, out):
    """What a fit writes, apart from its runs."""
    folder = bench.folder / out
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and path.relative_to(folder).parts[0] != "runs"}


def found_again(bench):
    """The parameters of a run are found from its measures; all files are there and say the same."""
    write(bench, PARAMETERS, truth(bench), SURROGATE)
    output = bench.accepted(*FIT_OF)
    bench.check("wrote" in output, f"it says {output!r}")
    found = document(bench)
    for one, value in zip(found["parameters"], (2.0, 0.4)):
        posterior = one["posterior"]
        bench.check(abs(posterior["median"] / value - 1) < 0.02, f"{one['key']}: {posterior}")
        bench.check(posterior["low"] < value < posterior["high"], f"{one['key']}: {posterior}")
        bench.check(one["sd_over_prior"] < 0.2 and one["r_hat"] < 1.2, f"{one}")
    names = [one["name"] for one in found["quantities"]]
    bench.check(names == ["volume_ratio@t=0.02", "cortex_volume_mm3@t=0.02", "area_ratio@t=0.01", "area_ratio@t=0.02"], f"{names}")
    bench.check("observed" not in found["quantities"][2], "a prediction was observed")
    table = rows(bench)
    bench.check([row["stage"] for row in table] == 8 * ["design"] + 2 * ["refinement"], f"stages of {table}")
    bench.check(len({row["folder"] for row in table}) == 10, "runs share folders")
    best = min(table, key=lambda row: float(row["misfit"]))
    bench.check(table[found["best"]["number"] - 1] == best and float(best["misfit"]) == found["best"]["misfit"], "another best")
    case = bench.accepted("check", "F/best.toml")
    bench.check(f"alpha_white = {float(best['tissue.alpha_white'])}" in case, "best.toml is another case")
    text = (bench.folder / "F/fit.md").read_text(encoding="utf-8")
    for name in ("objective", "parameters", "predicted", "pairs"):
        bench.check(f"plots/{name}.svg" in text, f"fit.md lacks {name}.svg")
        xml.etree.ElementTree.parse(bench.folder / f"F/plots/{name}.svg")
    before = results(bench, "F")
    bench.accepted(*FIT_OF)
    bench.check(results(bench, "F") == before, "made again it has other bytes")


def interrupted(bench):
    """SIGTERM and SIGKILL at several moments of search and design: the same evaluations and the same bytes at the end."""
    search = '[search]\nmethod = "{}"\nevaluations = 5\n'
    write(bench, PARAMETERS, truth(bench), search.format("BOBYQA"), SURROGATE)
    bench.accepted("fit", "fit.toml", "--out", "whole", "--quiet")
    bench.check([row["stage"] for row in rows(bench, "whole")][:6] == 5 * ["search"] + ["design"], "no search")
    for number, count in ((signal.SIGTERM, 2), (signal.SIGKILL, 4), (signal.SIGTERM, 8)):
        process = bench.start(*FIT_OF)
        begun = wait_for(process, lambda: len(list((bench.folder / "F/runs").glob("*/surface_0000.vtp"))) >= count, 120)
        bench.check(begun, f"no {count} runs were begun")
        status, errors = stop(process, number)
        bench.check(status == (130 if number == signal.SIGTERM else -9), f"{number!r}: status {status}, {errors!r}")
    bench.accepted(*FIT_OF)
    whole, got = results(bench, "whole"), results(bench, "F")
    bench.check(whole.keys() == got.keys(), f"files {whole.keys() ^ got.keys()}")
    for name in sorted(whole.keys() & got.keys()):
        bench.check(whole[name] == got[name], f"{name} differs after interruptions")
    bench.check(temporaries(bench.folder / "F") == [], "files left behind")
    write(bench, PARAMETERS, truth(bench), search.format("CRS"), "[surrogate]\npoints = 0\n")
    bench.accepted("fit", "fit.toml", "--out", "global", "--quiet")
    bench.check(len(rows(bench, "global")) == 5 and "posterior" not in document(bench, "global"), "without a surrogate")


def failing(bench):
    """Runs that fail are rows and do not end the fit; where all fail the error says why."""
    targets = truth(bench)
    write(bench, PARAMETERS, targets, '[search]\nmethod = "COBYLA"\nevaluations = 4\n', "[surrogate]\npoints = 0\n",
          '[set]\nsolver.max_halvings = 0\nsolver.time_step = 0.0001\n')
    status, _, errors = bench.call(*FIT_OF)
    table = rows(bench)
    bench.check(status in (0, 3) and len(table) == 4, f"{status} {errors!r} {table}")
    if status == 3:
        bench.check("all 4 runs failed" in errors, f"{errors!r}")
        bench.check(all(row["status"] == "failed" and row["reason"] for row in table), f"{table}")


def corrected(bench):
    """Dear runs correct what cheap ones predict."""
    write(bench, PARAMETERS, truth(bench), SURROGATE, "[fidelity]\nruns = 2\n[fidelity.set]\ngeometry.particles = 900\n")
    bench.accepted(*FIT_OF)
    table = rows(bench)
    bench.check([row["stage"] for row in table][-2:] == ["dear", "dear"], f"{table}")
    found = document(bench)
    bench.check(found["best"]["stage"] == "dear", f"{found['best']}")
    bench.check(found["quantities"][1]["correction"] != 0.0, "nothing was corrected")
    bench.check("particles = 900" in (bench.folder / "F/best.toml").read_text(encoding="utf-8"), "best.toml is a cheap case")


def sensitive(bench):
    """White growth matters for the volume of the body, not the seed of the imperfection."""
    bench.write("base.toml", BASE)
    parameters = PARAMETERS + '[[parameter]]\nkey = "imperfection.seed"\nlow = 1\nhigh = 9\n'
    bench.write("sens.toml", 'base = "base.toml"\nmeasures = ["volume_ratio@0.02"]\n' + parameters +
                "[morris]\npaths = 2\n[sobol]\npoints = 16\nsamples = 512\n")
    bench.accepted("sensitivity", "sens.toml", "--out", "S", "--jobs", "2")
    found = json.loads((bench.folder / "S/sensitivity.json").read_text(encoding="utf-8"))
    growth, white, seed = found["measures"][0]["parameters"]
    bench.check(white["mu_star"] > 10 * seed["mu_star"] and growth["mu_star"] > 10 * seed["mu_star"], f"{found['measures']}")
    bench.check(abs(seed["total"]) < 0.05 and growth["first"] + white["first"] > 0.9, f"{found['measures']}")
    for name in ("morris", "sobol"):
        xml.etree.ElementTree.parse(bench.folder / f"S/plots/{name}.svg")
    bench.check("volume\\_ratio@t=0.02" in (bench.folder / "S/sensitivity.md").read_text(encoding="utf-8"), "sensitivity.md")
    bench.refused(["fit", "sens.toml", "--out", "S"], ["measures"])


def refusals(bench):
    bench.write("base.toml", BASE)
    bench.refused(["fit"], ["study"])
    bench.refused(["fit", "none.toml"], ["none.toml"])
    target = '[[target]]\nmeasure = "gi_hull"\nt = 0.02\nvalue = 1\nsd = 0.1\n'
    write(bench, PARAMETERS)
    bench.refused(FIT_OF, ["[[target]]"])
    write(bench, PARAMETERS, target.replace("0.02", "0.5"))
    bench.refused(FIT_OF, ["fit.toml:", "t = 0.5", "0.02"])
    write(bench, PARAMETERS, target.replace("measure = \"gi_hull\"", 'file = "none.stl"\nmeasures = ["gi_hull"]').replace("value = 1\n", ""))
    bench.refused(FIT_OF, ["none.stl"])
    write(bench, PARAMETERS, target, '[search]\nmethod = "LD_MMA"\n')
    bench.refused(FIT_OF, ["LD_MMA", "BOBYQA"])
    bench.write("sens.toml", 'base = "base.toml"\nmeasures = ["gi_hull@0.02"]\n' + PARAMETERS + "[morris]\nlevels = 3\n")
    bench.refused(["sensitivity", "sens.toml"], ["even number"])
    bench.write("sens.toml", 'base = "base.toml"\nmeasures = ["gi_hul@0.02"]\n' + PARAMETERS)
    bench.refused(["sensitivity", "sens.toml"], ["gi_hul"])


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)
    _command.main(__doc__, found_again, interrupted, failing, corrected, sensitive, refusals)
