# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/fold.py (`make fold`): folds once, again when the case changes, and never over what it did not make."""

import subprocess
import sys

import _command

CASE = ('[geometry]\nparticles = 600\n[tissue]\nthickness_mm = 5\n[time]\nend = 0.02\n[output]\ncount = 1\n'
        'pictures = "off"\n')


def fold(bench):
    """(exit status, stdout, stderr) of the script."""
    done = subprocess.run([sys.executable, "-B", str(bench.source / "scripts/fold.py"), "--command", bench.command,
                           "--case", "case.toml", "--out", "runs/case"], cwd=bench.folder, text=True,
                          capture_output=True, check=False, timeout=300)
    return done.returncode, done.stdout, done.stderr


def own_runs(bench):
    bench.write("case.toml", CASE)
    status, output, errors = fold(bench)
    bench.check(status == 0 and "completed" in output, f"first: {status} {output!r} {errors!r}")
    log = (bench.folder / "runs/case/run.log").read_bytes()
    status, output, _ = fold(bench)
    bench.check(status == 0 and "current" in output, f"again: {status} {output!r}")
    bench.check((bench.folder / "runs/case/run.log").read_bytes() == log, "it was folded again")
    bench.write("case.toml", CASE.replace("0.02", "0.03"))
    status, output, errors = fold(bench)
    bench.check(status == 0 and "--overwrite" in output, f"another case: {status} {output!r} {errors!r}")


def runs_of_others(bench):
    """A run that the user made by hand stays, before and after one of make fold."""
    bench.write("case.toml", CASE)
    by_hand = ("run", "case.toml", "--quiet", "--set", "geometry.seed=7")
    bench.accepted(*by_hand)
    log = (bench.folder / "runs/case/run.log").read_bytes()
    status, _, errors = fold(bench)
    bench.check(status == 2 and "holds a run already" in errors, f"over a run by hand: {status} {errors!r}")
    bench.check((bench.folder / "runs/case/run.log").read_bytes() == log, "a run by hand was replaced")
    bench.accepted(*by_hand, "--overwrite", "--set", "geometry.seed=1")
    (bench.folder / "runs/case/corticle-files.txt").rename(bench.folder / "kept")
    bench.check(fold(bench)[0] == 2, "over a folder without a list")
    (bench.folder / "runs" / ".case.fold").write_text("mine\n")
    status, _, errors = fold(bench)
    bench.check(status == 2 and ".case.fold" in errors, f"over a file of mine: {status} {errors!r}")


if __name__ == "__main__":
    _command.main(__doc__, own_runs, runs_of_others)
