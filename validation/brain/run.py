#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A brain from a surface file at two resolutions: does it fold to the end without passing through itself?

The surface is given by --surface or $CORTICLE_BRAIN_SURFACE. Runs are made with $CORTICLE into $CORTICLE_OUT (b60, b250:
thousands of particles), or read with --runs.
"""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _runs  # noqa: E402

SIZES = [60000, 250000]
MOST_OVERLAP = 0.001
LEAST_RISE = 1.1 # of the hull index: sulci have formed


def differences(results):
    for result in results:
        yield from _runs.faults(result, MOST_OVERLAP)
        rise = result["end"]["gi_hull"] / result["start_gi_hull"]
        if rise < LEAST_RISE:
            yield f"{result['particles']} particles: the hull index rises by a factor of {rise:.3f}, expected {LEAST_RISE} at least"


def start_table(results):
    columns = [("particles", lambda r: r["particles"], ",d"), ("sphere index", lambda r: r["start_gi_sphere"], ".3f"),
               ("hull index", lambda r: r["start_gi_hull"], ".3f")]
    return _runs.table(columns, results)


def describe(folder):
    first = _runs.read_measures(folder)[0]
    return _runs.describe(folder) | {"start_gi_sphere": first["gi_sphere"], "start_gi_hull": first["gi_hull"]}


def main():
    def add(parser):
        parser.add_argument("--surface", type=Path, default=os.environ.get("CORTICLE_BRAIN_SURFACE"))

    arguments = _runs.parse_arguments(__doc__, SIZES, add)
    if not arguments.surface and not arguments.runs:
        print("skipped: no surface; give a closed one by --surface or CORTICLE_BRAIN_SURFACE")
        sys.exit(_runs.SKIPPED)
    settings = [f"geometry.file={Path(arguments.surface).resolve()}"] if arguments.surface else []
    case = _runs.ROOT / "cases" / "brain.toml"
    found = _runs.folders(arguments, case, "b", settings, _runs.ROOT / "runs/validation/brain")
    if not found:
        sys.exit("no complete run")
    results = [describe(folder) for _, folder in found]
    _runs.write_results(HERE, "A brain at two resolutions", results,
                        [("Before growth", start_table(results)), ("Controls", _runs.control_table(results)),
                         ("Half of the growth", _runs.time_table(results, "half")),
                         ("All of the growth", _runs.time_table(results, "end"))])
    missing = len(arguments.sizes) - len(found) if not arguments.runs else 0
    _runs.finish([*differences(results), *([f"{missing} runs did not complete"] if missing else [])])


main()
