# SPDX-License-Identifier: GPL-3.0-or-later
"""What the project checks share: which files are the project's own, and how a check ends."""

import argparse
import sys
from pathlib import Path

CODE_FOLDERS = ("src", "apps", "python", "tests", "benchmarks")
SKIPPED = 77


def parse_arguments(description, add=None):
    """The arguments every script test is given; `--source` defaults to the tree this file stands in."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--command", help="the built command (unused here)")
    if add:
        add(parser)
    arguments = parser.parse_args()
    arguments.source = arguments.source.resolve()
    return arguments


def cpp_files(source):
    """All C++ sources and headers of the project, sorted."""
    found = (path for folder in CODE_FOLDERS for path in (source / folder).rglob("*"))
    return sorted(path for path in found if path.suffix in (".cpp", ".hpp"))


def finish(problems, count, what):
    """Prints the problems and ends the process."""
    for problem in problems:
        print(problem)
    print(f"{count} files, {len(problems)} {what}")
    sys.exit(1 if problems else 0)
