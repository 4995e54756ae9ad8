# SPDX-License-Identifier: GPL-3.0-or-later
"""All C++ files are as clang-format writes them; `--fix` rewrites them."""

import re
import shutil
import subprocess
import sys

from _project import SKIPPED, cpp_files, parse_arguments

COMPLAINT = re.compile(r"^(.+?):\d+:\d+: (?:error|warning): .*$", re.MULTILINE)


def main():
    arguments = parse_arguments(__doc__, lambda parser: parser.add_argument("--fix", action="store_true"))
    tool = shutil.which("clang-format") or shutil.which("clang-format-14")
    if tool is None:
        print("skipped: clang-format is not installed")
        sys.exit(SKIPPED)
    files = [str(path) for path in cpp_files(arguments.source)]
    mode = ["-i"] if arguments.fix else ["--dry-run", "--Werror"]
    command = [tool, "--style=file", *mode, *files]
    result = subprocess.run(command, check=False, capture_output=True, text=True) if files else None
    failed = result is not None and result.returncode != 0
    if failed:
        first = {}  # one line a file: clang-format complains of every blank
        for match in COMPLAINT.finditer(result.stderr):
            first.setdefault(match.group(1), match.group(0))
        print("\n".join(first.values()) or result.stderr)
    print(f"{len(files)} files: " + ("run `make format`" if failed else "as clang-format writes them"))
    sys.exit(1 if failed else 0)


main()
