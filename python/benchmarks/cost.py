# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python module costs beside the command: steps, views, simulations made and dropped.

    build/venv/bin/python python/benchmarks/cost.py --command build/release/bin/corticle

Both step the same body to the same t, by turns, so that what else the machine does meets both. Times are those of processors, with
one thread, as others may be at work on the machine, and what counts is the least of each, which is that of a run least disturbed;
preparation and outputs are taken off as the time of a run that ends early.
"""

import argparse
import gc
import os
import resource
import statistics
import subprocess
import tempfile
import time
import warnings
from pathlib import Path
from typing import Dict, List, Tuple

import corticle


def resident_mb() -> float:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def by_command(command: str, folder: str, end: float) -> float:
    """Processor time of a whole run [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([command, "run", f"{folder}/case.toml", "--body", f"{folder}/body", "--out", f"{folder}/run", "--overwrite", "--quiet",
                    "--threads", "1", "--set", f"time.end={end}"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def by_module(body: corticle.Body, end: float, one_by_one: bool) -> float:
    """The same of a simulation from its start."""
    started = time.process_time()
    simulation = corticle.Simulation(body)
    if one_by_one:
        while simulation.t < end:
            simulation.step(until=end)
    else:
        simulation.run(until=end)
    return time.process_time() - started


def steps(options: argparse.Namespace) -> None:
    case = corticle.Case.sphere({"geometry.particles": options.particles, "time.end": options.end, "output.count": 1,
                                 "output.pictures": "off"})
    with tempfile.TemporaryDirectory(prefix="corticle-") as folder:
        case.save(Path(folder) / "case.toml")
        subprocess.run([options.command, "prepare", f"{folder}/case.toml", "--out", f"{folder}/body", "--quiet"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        body = corticle.prepare(case)
        early = 0.1 * options.end
        spent: Dict[str, List[Tuple[float, float]]] = {"command": [], "module": []}
        for turn in range(options.pairs):
            for who in ("command", "module") if turn % 2 == 0 else ("module", "command"):
                long, short = (by_module(body, end, turn % 4 >= 2) if who == "module" else by_command(options.command, folder, end)
                               for end in (options.end, early))
                spent[who].append((long, short))
                print(f"{who:8} {long - short:.3f} s", flush=True)
    ratios = [(module[0] - module[1]) / (command[0] - command[1]) for module, command in zip(spent["module"], spent["command"])]
    least = {who: min(long for long, _ in times) - min(short for _, short in times) for who, times in spent.items()}
    print(f"steps of {options.particles} particles, module / command: least times {least['module'] / least['command']:.4f}, median of "
          f"{len(ratios)} pairs {statistics.median(ratios):.4f}")


def views(particles: int) -> None:
    simulation = corticle.Simulation(corticle.prepare(corticle.Case.sphere(particles=particles)))
    before = resident_mb()
    held = [simulation.positions for _ in range(1000)]
    addresses = {view.__array_interface__["data"][0] for view in held}
    print(f"1,000 views of {held[0].nbytes / 2**20:.2f} MB: {len(addresses)} memory, {resident_mb() - before:.2f} MB more")


def cycles(count: int) -> None:
    body = corticle.prepare(corticle.Case.sphere({"geometry.particles": 600, "time.end": 0.1}))

    def cycle(times: int) -> None:
        for _ in range(times):
            simulation = corticle.Simulation(body)
            simulation.add_force(lambda t, x, v, s=simulation: 0.0 * x)  # a cycle of references, too
            simulation.step()
            assert simulation.positions.shape == (len(body), 3)
        gc.collect()

    cycle(200)
    before, objects = resident_mb(), len(gc.get_objects())
    marks = []
    for _ in range(4):
        cycle(count // 4)
        marks.append(resident_mb() - before)
    print(f"{count} simulations made, stepped and dropped: resident memory {', '.join(f'{mark:+.2f}' for mark in marks)} MB after each "
          f"quarter, {len(gc.get_objects()) - objects:+d} objects")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", default="build/release/bin/corticle")
    parser.add_argument("--particles", type=int, default=45000)
    parser.add_argument("--end", type=float, default=0.02)
    parser.add_argument("--pairs", type=int, default=8)
    parser.add_argument("--cycles", type=int, default=10000)
    parser.add_argument("--only", choices=["steps", "views", "cycles"])
    options = parser.parse_args()
    corticle.set_threads(1)
    warnings.simplefilter("ignore", corticle.CorticleWarning)
    if options.only in (None, "views"):
        views(options.particles)
    if options.only in (None, "cycles"):
        cycles(options.cycles)
    if options.only in (None, "steps"):
        steps(options)


if __name__ == "__main__":
    main()
