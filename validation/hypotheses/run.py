#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Strips under plane strain beside published numbers: a thin film, springs, the pressure of a fluid, white matter that follows.

Runs are made with $CORTICLE into $CORTICLE_OUT (film_s3_c5_K50_L150, springs_9_150, ...), or read with --runs.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

import _film  # noqa: E402
import _plot  # noqa: E402
import _pressure  # noqa: E402
import _runs  # noqa: E402
import _springs  # noqa: E402
import _white  # noqa: E402

PARTS = {
    "film": (_film, [("A thin film on a soft base", "table"), ("Each of its folds", "modes_table")]),
    "springs": (_springs, [("A tract of springs", "table")]),
    "pressure": (_pressure, [("Under the pressure of a fluid", "table"),
                             ("Change of the strain by the pressure", "changes_table"),
                             ("Linear theory under a pressure", "theory_table")]),
    "white": (_white, [("White matter that grows as it is stretched, means over seeds", "table")]),
}


def main():
    def add(parser):
        parser.add_argument("--parts", nargs="+", choices=PARTS, default=list(PARTS), help="comparisons to make")

    arguments = _runs.parse_arguments(__doc__, [], add)
    base = Path(arguments.runs or arguments.out or _runs.ROOT / "runs/validation/hypotheses")
    results, sections, panels, problems = {}, [], [], []
    for name in arguments.parts:
        part, tables = PARTS[name]
        found = part.results_of(arguments, base)
        if not found:
            continue
        results[name] = found
        sections += [(heading, getattr(part, table)(found)) for heading, table in tables]
        panels += part.panels(found)
        problems += part.differences(found)
    if not results:
        sys.exit("no complete run")
    _plot.write(HERE / "results.svg", panels)
    sections.append(("What differs", "".join(f"- DIFFERS: {problem}\n" for problem in problems) or "Nothing.\n"))
    _runs.write_results(HERE, "Strips under plane strain", results, sections)
    _runs.finish(problems)


main()
