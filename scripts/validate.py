#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every comparison in validation/ (run.py or run.sh) and says which agree.

Each is started in its own folder, with CORTICLE set to the built command and CORTICLE_OUT to a folder for what it
writes; exit status 0 says that it agrees, 77 that it could not be made here.
"""

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WORDS = {0: "agrees", 77: "skipped"}


def scripts(chosen):
    for folder in sorted(path for path in (ROOT / "validation").glob("*") if path.is_dir()):
        if chosen and folder.name not in chosen:
            continue
        for name in ("run.py", "run.sh"):
            if (folder / name).is_file():
                yield folder / name
                break


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, required=True)
    parser.add_argument("names", nargs="*", help="folders of validation/; all when none is named")
    arguments = parser.parse_args()
    results = []
    for script in scripts(arguments.names):
        name = script.parent.name
        out = ROOT / "runs" / "validation" / name
        out.mkdir(parents=True, exist_ok=True)
        print(f"== {name}", flush=True)
        environment = dict(os.environ, CORTICLE=str(arguments.command.resolve()), CORTICLE_OUT=str(out))
        start = time.monotonic()
        interpreter = sys.executable if script.suffix == ".py" else "bash"
        status = subprocess.run([interpreter, str(script)], cwd=script.parent, env=environment, check=False).returncode
        results.append((name, status, time.monotonic() - start))
    print()
    for name, status, seconds in results:
        print(f"{name:<32}{WORDS.get(status, 'DIFFERS'):<10}{seconds:8.1f} s")
    if not results:
        sys.exit("validate: nothing to run in validation/")
    sys.exit(0 if all(status in WORDS for _, status, _ in results) else 1)


main()
