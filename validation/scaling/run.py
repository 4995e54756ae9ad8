#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Partitions counted, and how fast runs of many ranks would be.

Bodies are counted by corticle_partitions, and a rank's part of contact is timed by corticle_contact_shares (cmake --build --preset release
--target corticle_partitions corticle_contact_shares), which stand beside $CORTICLE.
"""

import argparse
import json
import math
import os
import subprocess
import sys
from pathlib import Path

# What one rank of two cores was measured to take (docs/performance.md): a million particles, 22 % of which at 200,000 are enriched.
SECONDS_PER_PAIR = 1.84e-9          # both passes, memory-bound
SECONDS_PER_PARTICLE = 12e-9        # integrator and the rest of a step
# A node's network, shared by the ranks of two cores on it only as far as stated.
BYTES_PER_SECOND = 12.5e9
LATENCY = 2e-6
# Of a step, see docs/theory/ranks.md.
BYTES_PER_VERTEX = 56
BYTES_PER_BLOCK = 176
COLLECTIVES = 8                     # surface, two of sums, five of contact


def read_json(*words):
    return json.loads(subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout)


def mean(values):
    return sum(values) / len(values)


def local_seconds(rank):
    return rank["cost"] * SECONDS_PER_PAIR + rank["owned"] * SECONDS_PER_PARTICLE


def step_seconds(ranks, overlapped, contact=None):
    """The slowest rank, and what all wait for. contact: seconds of a surface of so many vertices, by the number of ranks."""
    vertices = sum(rank["surface"] for rank in ranks)
    blocks = sum(rank["blocks"] for rank in ranks)

    def of(rank):
        sent = 2 * rank["neighbours"] * LATENCY + rank["bytes"] / BYTES_PER_SECOND
        inner = local_seconds(rank) * rank["inner_blocks"] / max(rank["blocks"], 1)
        return local_seconds(rank) + (max(0.0, sent - inner) if overlapped else sent)

    of_contact = contact[str(len(ranks))] * vertices / contact["vertices"] if contact else 0.0
    gathered = COLLECTIVES * LATENCY * math.ceil(math.log2(len(ranks))) if len(ranks) > 1 else 0.0
    gathered += (vertices * BYTES_PER_VERTEX + blocks * BYTES_PER_BLOCK) / BYTES_PER_SECOND if len(ranks) > 1 else 0.0
    return max(map(of, ranks)) + of_contact + gathered


def whole(ranks):
    """The same body on one rank."""
    keys = ("owned", "surface", "blocks", "cost")
    return [{**{key: sum(rank[key] for rank in ranks) for key in keys}, "neighbours": 0, "bytes": 0, "inner_blocks": 0, "ghosts": 0}]


def row(counted, number, contact):
    ranks = counted["ranks"][str(number)]
    without = step_seconds(whole([{**rank, "surface": 0} for rank in ranks]), False)
    no_surface = [{**rank, "surface": 0} for rank in ranks]

    def percent(reference, seconds):
        return f"{100 * reference / (number * seconds):.0f} %"

    costs = [rank["cost"] for rank in ranks]
    return [counted["shape"], f"{counted['particles']:,}", number, f"{mean([rank['owned'] for rank in ranks]):,.0f}",
            f"{mean([rank['ghosts'] for rank in ranks]):,.0f}", f"{max(rank['ghosts'] for rank in ranks):,}",
            f"{2 * mean([rank['neighbours'] for rank in ranks]):.0f}", f"{mean([rank['bytes'] for rank in ranks]) / 1e6:.2f}",
            f"{100 * (max(costs) / mean(costs) - 1):.1f} %",
            f"{100 * sum(rank['inner_blocks'] for rank in ranks) / sum(rank['blocks'] for rank in ranks):.0f} %",
            percent(without, step_seconds(no_surface, False)), percent(without, step_seconds(no_surface, True)),
            *(percent(step_seconds(whole(ranks), False, contact[state]), step_seconds(ranks, True, contact[state]))
              for state in ("smooth", "folded"))]


HEADER = ["body", "particles", "ranks", "owned", "ghosts", "most", "messages", "MB sent", "imbalance", "inner blocks", "tissue, plain",
          "tissue, overlapped", "with contact, smooth", "with contact, fully folded"]


def table(rows):
    lines = ["| " + " | ".join(map(str, cells)) + " |" for cells in (HEADER, ["---"] * len(HEADER), *rows)]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counter", type=Path, default=Path(os.environ.get("CORTICLE", "corticle")).parent / "corticle_partitions")
    parser.add_argument("--out", type=Path, default=Path(os.environ.get("CORTICLE_OUT", ".")))
    parser.add_argument("--particles", type=int, nargs="+", default=[1_000_000, 10_000_000])
    parser.add_argument("--ranks", type=int, nargs="+", default=[8, 64, 512])
    arguments = parser.parse_args()
    timer = arguments.counter.parent / "corticle_contact_shares"
    for program in (arguments.counter, timer):
        if not program.is_file():
            print(f"{program} is not built")
            sys.exit(77)
    rows = []
    for particles in arguments.particles:
        contact = read_json(timer, particles, *arguments.ranks)
        print(json.dumps(contact), flush=True)
        for shape in ("sphere", "brain"):
            counted = read_json(arguments.counter, shape, particles, *arguments.ranks)
            rows += [row(counted, number, contact) for number in arguments.ranks]
            (arguments.out / "results.md").write_text("# Partitions counted\n\n" + table(rows), encoding="utf-8")
    print(table(rows))


main()
