# SPDX-License-Identifier: GPL-3.0-or-later
"""Each source names its licence, stays under 400 lines, and leaves threads to base/parallel.hpp; folders stay under 4,000."""

import collections
import re

from _project import cpp_files, finish, parse_arguments

LICENCE = "SPDX-License-Identifier: GPL-3.0-or-later"
LONGEST = 400
LARGEST = 4000  # lines of the sources of one folder, without those below it
THREADS = re.compile(r"^\s*#\s*(pragma\s+omp\s+(?!simd|declare\s+simd)|include\s*<(omp\.h|thread)>)", re.MULTILINE)
MAY_KNOW_THREADS = ("src/corticle/base/parallel.hpp",)


def other_sources(source):
    """Scripts and build files: they too name their licence and stay short."""
    folders = ("scripts", "tests", "validation", "benchmarks", "apps", "src", "python", "examples")
    found = [path for folder in folders for path in (source / folder).rglob("*")]
    chosen = [path for path in found if path.suffix in (".py", ".sh", ".cmake") or path.name == "CMakeLists.txt"]
    return sorted(chosen) + [source / "CMakeLists.txt", source / "Makefile"]


def check(path, source):
    name = path.relative_to(source).as_posix()
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    if not any(LICENCE in line for line in lines[:5]):
        yield f"{name}: its first lines lack '{LICENCE}'"
    if len(lines) > LONGEST:
        yield f"{name}: {len(lines)} lines, more than {LONGEST}: split it by concept"
    if path.suffix == ".hpp" and "#pragma once" not in text:
        yield f"{name}: lacks #pragma once"
    if name.startswith("src/") and name not in MAY_KNOW_THREADS and (match := THREADS.search(text)):
        line = text.count("\n", 0, match.start()) + 1
        yield f"{name}:{line}: only base/parallel.hpp knows threads"


def check_folders(files, source):
    lines = collections.Counter()
    for path in files:
        lines[path.parent] += len(path.read_text(encoding="utf-8").splitlines())
    for folder, count in lines.items():
        if count > LARGEST:
            yield f"{folder.relative_to(source).as_posix()}: {count} lines, more than {LARGEST}: split it by concept"


def main():
    source = parse_arguments(__doc__).source
    files = cpp_files(source) + other_sources(source)
    problems = [problem for path in files for problem in check(path, source)]
    finish([*problems, *check_folders(files, source)], len(files), "faults")


main()
