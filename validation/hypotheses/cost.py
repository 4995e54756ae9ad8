#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the terms of the hypotheses cost: one body, one thread, none of them, each of them, and all, in turns.

Runs are made with $CORTICLE into $CORTICLE_OUT (none_1_0.02, none_1_0.1, ...), or read with --runs. Writes cost.md and
cost.json beside itself. Times are those on processors, of a run to the later end less one to the earlier, the least of all
rounds: so preparation counts for nothing, and other work on the machine for little.
"""

import json
import resource
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent)]

import _runs  # noqa: E402

CASES = _runs.ROOT / "cases" / "hypotheses"
CASE = CASES / "differential_growth.toml"
PARTICLES = 8000
ROUNDS = 1
ENDS = (0.01, 0.3)
MOST_FACTOR = 1.6

TERMS = {
    "skull and fluid": {"boundary.shape": "offset", "boundary.offset_mm": 0.7, "boundary.fluid": "conserved"},
    "fibres": {"fibres.direction": "radial", "fibres.stiffness": 0.5, "fibres.active_stress": 0.2, "fibres.growth_rate": 2.0},
    "tracts": {"tracts.file": CASES / "tracts.csv", "tracts.stiffness": 5.0, "tracts.rest": 0.6, "tracts.growth_rate": 1.0,
               "tracts.reach_mm": 2.5},
    "protomap": {"map.protomap_amplitude": 0.3, "map.protomap_wavelength_mm": 18.0},
    "growth by stress": {"stress_growth.rate": 3.0},
    "relaxation": {"relaxation.share": 0.5, "relaxation.time": 0.1},
}
VARIANTS = {"none": {}} | TERMS | {"all": {key: value for term in TERMS.values() for key, value in term.items()}}


def folder_of(base, name, number, end):
    return base / f"{name.replace(' ', '_')}_{number}_{end:g}"


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def make_runs(arguments, base):
    """Every run to both ends, and the time on processors that each took, in cpu.json."""
    shared = {"geometry.particles": arguments.particles, "output.count": 1, "output.pictures": "off", "output.report": "off"}
    taken = {}
    base.mkdir(parents=True, exist_ok=True)
    for number in range(1, arguments.rounds + 1):
        for name in arguments.variants:
            settings = VARIANTS[name]
            for end in ENDS:
                words = [f"{key}={value}" for key, value in (shared | settings | {"time.end": end}).items()]
                start = cpu_seconds()
                _runs.make_run(arguments, CASE, folder_of(base, name, number, end), words)
                taken.setdefault(name, []).append(cpu_seconds() - start)
                (base / "cpu.json").write_text(json.dumps(taken, indent=2) + "\n", encoding="utf-8")


def describe(base, name, taken):
    folders = [folder_of(base, name, 1, end) for end in ENDS]
    if name not in taken or not all(map(_runs.is_complete, folders)):
        return None
    few, many = (_runs.read_summary(folder) for folder in folders)
    seconds = [later - earlier for earlier, later in zip(taken[name][::2], taken[name][1::2])]
    steps = many["steps"] - few["steps"]
    return {"name": name, "particles": many["particles"], "threads": many["threads"], "steps": steps, "seconds": seconds,
            "ms_per_step": 1000 * min(seconds) / steps}


def main():
    def add(parser):
        parser.add_argument("--particles", type=int, default=PARTICLES)
        parser.add_argument("--variants", nargs="+", choices=VARIANTS, default=list(VARIANTS), help="runs to make")
        parser.add_argument("--rounds", type=int, default=ROUNDS)

    arguments = _runs.parse_arguments(__doc__, [], add)
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/hypotheses_cost")
    if not arguments.runs:
        make_runs(arguments, base)
    taken = json.loads((base / "cpu.json").read_text(encoding="utf-8"))
    results = [result for result in (describe(base, name, taken) for name in VARIANTS) if result]
    if not results or results[0]["name"] != "none":
        sys.exit("no complete run")
    none = results[0]
    columns = [("terms", lambda r: r["name"], ""), ("steps", lambda r: r["steps"], ",d"),
               ("ms per step", lambda r: r["ms_per_step"], ".2f"),
               ("over none, per step", lambda r: r["ms_per_step"] / none["ms_per_step"], ".2f"),
               ("over none, whole run", lambda r: min(r["seconds"]) / min(none["seconds"]), ".2f")]
    problems = [f"{r['name']}: a step takes {r['ms_per_step'] / none['ms_per_step']:.2f} times as long, expected at most {MOST_FACTOR}"
                for r in results if r["ms_per_step"] > MOST_FACTOR * none["ms_per_step"]]
    text = (f"# Cost of the terms\n\nWritten by `cost.py`; see [README.md](README.md). {none['particles']:,} particles, "
            f"{none['threads']} thread(s), from t = {ENDS[0]} to {ENDS[1]}.\n\n{_runs.table(columns, results)}\n## What differs\n\n"
            + ("".join(f"- DIFFERS: {problem}\n" for problem in problems) or "Nothing.\n"))
    (HERE / "cost.md").write_text(text, encoding="utf-8")
    (HERE / "cost.json").write_text(json.dumps(results, indent=2) + "\n", encoding="utf-8")
    print(text)
    _runs.finish(problems)


main()
