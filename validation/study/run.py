#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Twin test of `corticle fit`: four parameters found again from measures of a run, with noise of 2 % of several seeds.

The run and the fits are made with $CORTICLE into $CORTICLE_OUT. The fits share one folder of runs and one design, so that
all seeds together take little more than one. --sizes: number of particles; several are several tests.
"""

import csv
import json
import random
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402

TRUTH = {"tissue.thickness_mm": 2.6, "tissue.alpha_t": 1.8, "tissue.alpha_white": 0.3, "tissue.mu_cortex": 1.0}
BOUNDS = {"tissue.thickness_mm": (2.0, 3.4), "tissue.alpha_t": (1.2, 2.6), "tissue.alpha_white": (0.12, 0.6),
          "tissue.mu_cortex": (0.5, 2.0)}
MEASURES = ("volume_ratio", "area_ratio", "cortex_volume_mm3", "inner_area_mm2", "hull_area_mm2", "gi_hull",
            "abs_mean_curvature_per_mm", "curvedness_per_mm", "cortex_thickness_mm")
TIMES = tuple(round(0.05 * i, 2) for i in range(1, 11))
NOISE = 0.02
SEEDS = 10
WITHIN = 0.05
ENOUGH = 8       # of ten seeds


def add_options(parser):
    parser.add_argument("--points", type=int, default=44, help="runs of the design")
    parser.add_argument("--refinements", type=int, default=10, help="most rounds of four runs for each seed")
    parser.add_argument("--first-seed", type=int, default=1, help="of the noise; ten follow one another")
    parser.add_argument("--jobs", type=int, default=2)


def true_measures(folder):
    """{(measure, t): value}, and the onset."""
    with open(folder / "measures.csv", encoding="utf-8", newline="") as stream:
        rows = [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]
    found = {(key, t): next(row[key] for row in rows if abs(row["t"] - t) < 1e-9) for key in MEASURES for t in TIMES}
    found["onset_t", None] = _runs.read_summary(folder)["onset_t"]
    return found


def fit_text(arguments, particles, truth, seed):
    lines = [f'base = "{HERE / "twin.toml"}"', f'title = "Twin, noise seed {seed}"', "[set]", f"geometry.particles = {particles}"]
    for key, (low, high) in BOUNDS.items():
        lines += ["[[parameter]]", f'key = "{key}"', f"low = {low}", f"high = {high}", 'scale = "log"']
    for (measure, t), value in truth.items():
        noise = random.Random(f"{seed} {measure} {t}").gauss(0.0, 1.0)   # whatever other measures there are
        observed = value * (1.0 + NOISE * noise)
        lines += ["[[target]]", f'measure = "{measure}"', f"value = {observed!r}", f"sd = {NOISE * abs(value)!r}"]
        lines += [f"t = {t}"] if t is not None else []
    lines += ["[surrogate]", f"points = {arguments.points}", f"refinements = {arguments.refinements}", "runs_a_round = 4",
              "[posterior]", "samples = 8000"]
    return "\n".join(lines) + "\n"


def make_fit(arguments, folder, particles, truth, seed):
    file = folder / f"seed{seed}.toml"
    file.write_text(fit_text(arguments, particles, truth, seed), encoding="utf-8")
    words = [str(Path(arguments.command).resolve()), "fit", str(file), "--out", str(folder / f"seed{seed}"),
             "--runs", str(folder / "runs"), "--jobs", str(arguments.jobs)]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return json.loads((folder / f"seed{seed}" / "fit.json").read_text(encoding="utf-8"))


def judge(found):
    """For each parameter (estimate over truth - 1, the truth lies within the 90 % interval of it, and within that of all)."""
    result = {}
    for one in found["parameters"]:
        truth, posterior = TRUTH[one["key"]], one["posterior"]
        result[one["key"]] = (posterior["median"] / truth - 1.0, posterior["low"] <= truth <= posterior["high"],
                              posterior["low_together"] <= truth <= posterior["high_together"])
    return result


def table(judged):
    lines = ["| noise seed | " + " | ".join(f"`{key.split('.')[1]}`" for key in TRUTH) + " | within 5 % | in the 90 % intervals together |",
             "|---|" + "---|" * (len(TRUTH) + 2)]
    for seed, one in judged.items():
        cells = [f"{100 * off:+.1f} %{'' if inside else ' (outside its own)'}" for off, inside, _ in one.values()]
        near = sum(abs(off) <= WITHIN for off, _, _ in one.values())
        together = sum(together for _, _, together in one.values())
        lines.append(f"| {seed} | {' | '.join(cells)} | {near} of {len(one)} | {together} of {len(one)} |")
    return "\n".join(lines) + "\n"


def twin(arguments, particles):
    folder = Path(arguments.out or ".") / "study" / f"twin{particles}"
    folder.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    _runs.make_run(arguments, HERE / "twin.toml", folder / "truth", [f"geometry.particles={particles}"])
    truth = true_measures(folder / "truth")
    seeds = range(arguments.first_seed, arguments.first_seed + SEEDS)
    judged = {seed: judge(make_fit(arguments, folder, particles, truth, seed)) for seed in seeds}
    minutes = (time.monotonic() - begin) / 60.0
    runs = [_runs.read_summary(run) for run in (folder / "runs").iterdir()]
    cpu = sum(run.get("wall_s", 0.0) * run.get("threads", 1) for run in runs) / 60.0
    text = f"## {particles} particles\n\n{table(judged)}\n"
    count = {name: {key: sum(holds(one[key]) for one in judged.values()) for key in TRUTH}
             for name, holds in (("within 5 %", lambda one: abs(one[0]) <= WITHIN), ("in its own 90 % interval", lambda one: one[1]),
                                 ("in the 90 % interval of all together", lambda one: one[2]))}
    all_near = sum(all(abs(off) <= WITHIN for off, _, _ in one.values()) for one in judged.values())
    all_inside = sum(all(together for _, _, together in one.values()) for one in judged.values())
    text += f"| of {SEEDS} seeds | " + " | ".join(f"`{key.split('.')[1]}`" for key in TRUTH) + " | all four |\n|---|" + "---|" * 5 + "\n"
    alls = {"within 5 %": all_near, "in the 90 % interval of all together": all_inside}
    for name, of_keys in count.items():
        text += f"| {name} | " + " | ".join(str(of_keys[key]) for key in TRUTH) + f" | {alls.get(name, '')} |\n"
    text += f"\n{len(runs)} runs; {minutes:.1f} min here, {cpu:.1f} min of threads in runs.\n"
    faults = [f"all four {name} for {number} of {SEEDS} seeds" for name, number in alls.items() if number < ENOUGH]
    return text, faults


def main():
    arguments = _runs.parse_arguments(__doc__, [8000], add_options)
    if not Path(arguments.command).is_file():
        print(f"no command at {arguments.command}")
        sys.exit(_runs.SKIPPED)
    texts, faults = [], []
    for particles in arguments.sizes:
        text, found = twin(arguments, particles)
        print(text)
        texts.append(text)
        faults += [f"{particles} particles: {fault}" for fault in found]
    (Path(arguments.out or ".") / "study" / "results.md").write_text("# Twin test of `corticle fit`\n\n" + "\n".join(texts), encoding="utf-8")
    for fault in faults:
        print("FAILED:", fault)
    sys.exit(1 if faults else 0)


main()
