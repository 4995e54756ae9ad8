# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the built command in a scratch folder and gathers what went wrong."""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
PREFIX = "corticle: error: "


class Bench:
    """A scratch folder, the command, and the problems found so far."""

    def __init__(self, command, folder):
        self.command = str(Path(command).resolve())
        self.folder = Path(folder)
        self.checks = 0
        self.problems = []

    def write(self, name, content):
        """A file of the scratch folder; returns its name."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def start(self, *arguments):
        return subprocess.Popen([self.command, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")

    def call(self, *arguments, timeout=300):
        """(exit status, stdout, stderr); status None when it ran past the time limit."""
        process = self.start(*arguments)
        try:
            output, errors = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return None, "", ""
        return process.returncode, output, errors

    def check(self, condition, what):
        self.checks += 1
        if not condition:
            self.problems.append(what)
            print("FAILED:", what, flush=True)
        return bool(condition)

    def listing(self):
        return sorted((str(path), path.stat().st_size, path.stat().st_mtime_ns) for path in self.folder.rglob("*")
                      if not path.is_dir()) + sorted(str(path) for path in self.folder.rglob("*") if path.is_dir())

    def refused(self, arguments, parts=(), status=2):
        """The command must end with this status, say why in one line that holds all `parts`, and write nothing."""
        before = self.listing()
        got, output, errors = self.call(*arguments, timeout=60)
        name = " ".join(map(str, arguments))
        self.check(got == status, f"`{name}`: exit status {got}, expected {status}; stderr {errors!r}")
        one_line = errors.endswith("\n") and errors.count("\n") == 1 and errors.startswith(PREFIX)
        self.check(one_line, f"`{name}`: expected one line on stderr, got {errors!r}")
        self.check(output == "", f"`{name}`: expected nothing on stdout, got {output[:200]!r}")
        for part in parts:
            self.check(part.lower() in errors.lower(), f"`{name}`: {errors!r} does not say {part!r}")
        self.check(self.listing() == before, f"`{name}`: it wrote something")

    def accepted(self, *arguments, timeout=300):
        """The command must succeed; returns its stdout."""
        status, output, errors = self.call(*arguments, timeout=timeout)
        self.check(status == 0, f"`{' '.join(map(str, arguments))}`: exit status {status}; stderr {errors[-500:]!r}")
        return output


def main(description, *tests):
    """Runs each test(bench) in a scratch folder of its own and ends the process."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--command", required=True)
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    if not Path(arguments.command).is_file():
        print(f"no command at {arguments.command}")
        sys.exit(SKIPPED)
    problems, checks = [], 0
    for test in tests:
        with tempfile.TemporaryDirectory(prefix="corticle cli ") as folder:
            bench = Bench(arguments.command, folder)
            bench.source = arguments.source.resolve()
            test(bench)
            problems += bench.problems
            checks += bench.checks
    print(f"{checks} checks, {len(problems)} failed")
    sys.exit(1 if problems else 0)
