#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes every sweep of cases/thesis and puts its table and pictures into validation/thesis/<sweep>.

A sweep is a TOML file with a `base`. Runs are kept in runs/validation/thesis/<sweep>: a second call goes on where the first
one stopped. To make less: name sweeps, or change all runs with --set.
"""

import argparse
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
INTERRUPTED = 130


def sweeps(chosen):
    for file in sorted((ROOT / "cases/thesis").glob("*.toml")):
        with open(file, "rb") as stream:
            if "base" in tomllib.load(stream) and (not chosen or file.stem in chosen):
                yield file


def publish(made, folder):
    """The table as results.md, with its pictures."""
    shutil.rmtree(folder / "pictures", ignore_errors=True)
    text = (made / "sweep.md").read_text(encoding="utf-8")
    for picture in sorted(made.glob("plots/*.png")) + sorted(made.glob("surfaces.png")):
        name = picture.relative_to(made).as_posix()
        if f"]({name})" in text:
            (folder / "pictures").mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture, folder / "pictures" / picture.name)
            text = text.replace(f"![{name}]({name})", f"![{picture.stem}](pictures/{picture.name})")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.md").write_text(text, encoding="utf-8")
    shutil.copyfile(made / "sweep.csv", folder / "results.csv")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, required=True)
    parser.add_argument("--runs", type=Path, default=ROOT / "runs/validation/thesis", help="where runs are kept")
    parser.add_argument("--out", type=Path, default=ROOT / "validation/thesis", help="where tables and pictures go")
    parser.add_argument("--set", action="append", default=[], metavar="SECTION.KEY=VALUE", help="for all runs")
    parser.add_argument("--jobs", type=int, help="runs side by side")
    parser.add_argument("names", nargs="*", help="sweeps; all when none is named")
    arguments = parser.parse_args()
    failed = []
    files = list(sweeps(arguments.names))
    for file in files:
        print(f"== {file.stem}", flush=True)
        made = arguments.runs / file.stem
        words = [str(arguments.command.resolve()), "sweep", str(file), "--out", str(made)]
        words += [word for setting in arguments.set for word in ("--set", setting)]
        words += ["--jobs", str(arguments.jobs)] if arguments.jobs else []
        status = subprocess.run(words, check=False).returncode
        if status == INTERRUPTED:
            sys.exit(status)
        if status == 0:
            publish(made, arguments.out / file.stem)
        else:
            failed.append(file.stem)
    if not files:
        sys.exit("validate_thesis: no such sweep in cases/thesis")
    if failed:
        sys.exit(f"validate_thesis: not made: {', '.join(failed)}")


main()
