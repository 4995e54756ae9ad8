#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy over the project's sources, as compile_commands.json of a build folder tells how to compile them."""

import argparse
import json
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "dev")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("files", nargs="*", type=Path, help="only these; src/ and apps/ when none is named")
    arguments = parser.parse_args()
    tool = shutil.which("clang-tidy") or shutil.which("clang-tidy-14")
    if tool is None:
        sys.exit("lint: clang-tidy is not installed (scripts/setup.sh --dev)")

    commands = json.loads((arguments.build / "compile_commands.json").read_text(encoding="utf-8"))
    known = {Path(entry["directory"], entry["file"]).resolve() for entry in commands}
    if arguments.files:
        files = [path.resolve() for path in arguments.files]
    else:
        files = sorted(path for path in known if {"src", "apps"} & set(path.relative_to(ROOT).parts[:1]))
    unknown = [str(path) for path in files if path not in known]
    if unknown:
        sys.exit(f"lint: not compiled in {arguments.build}: {' '.join(unknown)}")

    def check(path):
        # g++'s own warning options mean nothing to clang-tidy.
        options = ["--quiet", "-p", str(arguments.build), "--extra-arg=-Wno-unknown-warning-option"]
        return path, subprocess.run([tool, *options, str(path)], check=False, capture_output=True, text=True)

    failed = 0
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for path, result in pool.map(check, files):
            bad = result.returncode != 0
            failed += bad
            print(f"{'FAULT' if bad else 'ok   '} {path.relative_to(ROOT)}", flush=True)
            if bad:
                print(result.stdout.strip() or result.stderr.strip(), flush=True)
    print(f"{len(files)} files, {failed} with faults")
    sys.exit(1 if failed else 0)


main()
