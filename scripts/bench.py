#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks and prints one table: each figure, and the share of what this machine can do that it stands for.

The machine's own limits, bandwidth (STREAM triad) and fused multiply-adds, are measured in the same run. All benchmarks
that are built are run (bench_*); the JSON of each stays in the folder --out.
"""

import argparse
import json
import math
import os
import subprocess
import sys
from pathlib import Path

# Every benchmark but those of the machine takes the number of particles (or elements), 4000 for the quick run.
QUICK = r"(^fma_peak|^triad/1|/4000)(/|$)"
REPETITIONS = 3  # the fastest counts: whatever else the machine does only adds time
COLUMNS = ("benchmark", "particles, tets", "ms", "us/particle-step", "ns/tet-step", "ns/pair", "GB/s", "of triad", "GFLOP/s", "of peak")


def environment():
    """As the command sets it for itself: threads that wait sleep soon."""
    chosen = {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT"} & os.environ.keys()
    return os.environ if chosen else os.environ | {"GOMP_SPINCOUNT": "20000"}


def machine_line():
    """Processor and threads."""
    name = "unknown processor"
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    threads = int(os.environ.get("OMP_NUM_THREADS") or len(os.sched_getaffinity(0)))
    return f"{name}, {threads} {'thread' if threads == 1 else 'threads'}, load {os.getloadavg()[0]:.1f}"


def run(binary, out, quick):
    """The benchmarks of one binary, as Google Benchmark writes them, the fastest repetition of each."""
    result = out / f"{binary.name.removeprefix('bench_')}.json"
    result.unlink(missing_ok=True)
    command = [binary, f"--benchmark_out={result}", "--benchmark_out_format=json", "--benchmark_color=false",
               f"--benchmark_filter={QUICK if quick else '-/4000(/|$)'}"]
    command += ["--benchmark_min_time=0.01"] if quick else [f"--benchmark_repetitions={REPETITIONS}"]
    print(f"bench: {binary.name}", file=sys.stderr, flush=True)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment())
    if done.returncode != 0 or not result.is_file():
        sys.exit(f"bench: {binary.name} failed (exit status {done.returncode}):\n{done.stdout}")
    try:
        rows = json.loads(result.read_text())["benchmarks"]
    except json.JSONDecodeError:
        return []  # nothing matched the filter
    fastest = {}
    for row in rows:
        if row["run_type"] == "iteration":
            best = fastest.setdefault(row["name"], row)
            fastest[row["name"]] = min(best, row, key=lambda one: one.get("real_time", math.inf))
    return list(fastest.values())


def stem(row):
    return row["name"].split("/")[0]


def argument(row):
    parts = row["name"].split("/")
    return int(parts[1]) if len(parts) > 1 and parts[1].isdigit() else None


class Machine:
    """What the triad and the multiply-adds measured."""

    def __init__(self, rows):
        self.triads = [(row["working_set_MB"], row["GB_per_s"]) for row in rows if stem(row) == "triad"]
        self.peak = max((row["GFLOP_per_s"] for row in rows if stem(row) == "fma_peak"), default=None)

    def bandwidth(self, megabytes):
        """That of the triad nearest in size."""
        if not self.triads:
            return None
        return min(self.triads, key=lambda triad: abs(math.log(triad[0] / megabytes)))[1]


def number(value, digits=3):
    """With so many digits, none of them an exponent."""
    if value is None or not math.isfinite(value):
        return ""
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:,.{decimals}f}"


def share(value, limit):
    return f"{100 * value / limit:.0f} %" if value and limit else ""


def cells(row, machine):
    milliseconds = row["real_time"] * {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}[row["time_unit"]]
    rate, flops = row.get("GB_per_s"), row.get("GFLOP_per_s")
    in_memory = "working_set_MB" in row and stem(row) != "triad"  # files are not held against memory
    size = f"{row['working_set_MB']:,.0f} MB" if stem(row) == "triad" else f"{argument(row):,}" if argument(row) else ""
    return (stem(row), size, number(milliseconds), number(row.get("us_per_particle_step")),
            number(row.get("ns_per_tet")), number(row.get("ns_per_pair")),
            number(rate), share(rate, machine.bandwidth(row["working_set_MB"])) if in_memory else "", number(flops),
            share(flops, machine.peak) if stem(row) != "fma_peak" else "")


def table(rows):
    machine = Machine(rows)
    lines = [COLUMNS] + [cells(row, machine) for row in rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(COLUMNS))]
    shown = ["| " + " | ".join(cell.ljust(width) if k == 0 else cell.rjust(width)
                               for k, (cell, width) in enumerate(zip(line, widths))) + " |" for line in lines]
    rule = "|" + "|".join("-" * (width + 1) + ("-" if k == 0 else ":") for k, width in enumerate(widths)) + "|"
    return "\n".join([shown[0], rule] + shown[1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binaries", type=Path, required=True, help="folder of the built bench_*")
    parser.add_argument("--out", type=Path, required=True, help="folder for the JSON")
    parser.add_argument("--quick", action="store_true", help="only small sizes, briefly: do they run at all?")
    parser.add_argument("names", nargs="*", help="benchmarks to run (force, contact, ...); all when none is named")
    arguments = parser.parse_args()
    binaries = sorted(path for path in arguments.binaries.glob("bench_*")
                      if path.is_file() and (not arguments.names or path.name.removeprefix("bench_") in
                                             arguments.names + ["machine"]))
    if not binaries:
        sys.exit(f"bench: no benchmarks in {arguments.binaries}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    binaries.sort(key=lambda path: path.name != "bench_machine")  # the limits first
    described = machine_line()
    rows = [row for binary in binaries for row in run(binary, arguments.out, arguments.quick)]
    failed = [row["name"] for row in rows if row.get("error_occurred")]
    if failed or not rows:
        sys.exit(f"bench: {', '.join(failed) or 'nothing'} failed")
    text = f"{described}\n\n{table(rows)}"
    (arguments.out / "table.md").write_text(text + "\n")
    print(text)


if __name__ == "__main__":
    main()
