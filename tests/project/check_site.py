# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages build as a site without a warning, and every page is in it."""

import subprocess
import sys
import tempfile
from pathlib import Path

from _project import SKIPPED, finish, parse_arguments

PYTHON = "/usr/bin/python3"    # Debian's, which has its Sphinx


def pages(source):
    return [page for page in sorted([*(source / "docs").rglob("*.md"), *source.glob("*.md")]) if page.name != "index.md"]


def check(source):
    with tempfile.TemporaryDirectory() as folder:
        built = subprocess.run([PYTHON, "-B", "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "dirhtml", "-d", f"{folder}/trees", "-c",
                                source / "docs/site", source, f"{folder}/site"], capture_output=True, text=True, check=False)
        yield from built.stderr.splitlines()
        for page in pages(source):
            place = page.relative_to(source).with_suffix("")
            if not (Path(folder) / "site" / place / "index.html").is_file():
                yield f"{place}.md: not a page of the site"


def main():
    arguments = parse_arguments(__doc__)
    if subprocess.run([PYTHON, "-c", "import myst_parser"], capture_output=True, check=False).returncode != 0:
        print("skipped: no Sphinx with MyST here")
        sys.exit(SKIPPED)
    finish(list(check(arguments.source)), len(pages(arguments.source)), "faults of the site")


main()
