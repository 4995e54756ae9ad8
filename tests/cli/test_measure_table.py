#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of measures (`corticle schema --measures`) is what measures.csv and the guide hold."""

import _command

CASE = ('[geometry]\nparticles = 600\n[tissue]\nthickness_mm = 4\n[time]\nend = 0.001\n'
        '[output]\ncount = 1\npictures = "off"\n')


def table(bench):
    lines = bench.accepted("schema", "--measures").splitlines()
    return [tuple(cell.strip() for cell in line.strip("|").split("|")) for line in lines[2:]]


def in_the_guide_and_in_files(bench):
    rows = table(bench)
    bench.check(len(rows) > 50 and all(len(row) == 3 and row[2] for row in rows), f"no table: {rows[:3]}")
    guide = (bench.source / "docs" / "guide" / "run-folder.md").read_text(encoding="utf-8")
    for key, _, _ in rows:
        bench.check(key in guide, f"docs/guide/run-folder.md does not explain {key}")
    bench.write("case.toml", CASE)
    bench.accepted("run", "case.toml", "--out", "run", "--quiet")
    header = (bench.folder / "run" / "measures.csv").read_text(encoding="utf-8").splitlines()[0]
    expected = ",".join(f"{key.strip('`')} [{unit}]" for key, unit, _ in rows)
    bench.check(header == expected, f"measures.csv begins {header!r}, expected {expected!r}")


if __name__ == "__main__":
    _command.main(__doc__, in_the_guide_and_in_files)
