# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages stay within 140 columns, rows of tables apart, and their links to files of the project lead somewhere."""

import re

from _project import finish, parse_arguments

WIDEST = 140
LINK = re.compile(r"\]\(([^()\s]+)\)")


def pages(source):
    """Those written by hand: the tables of results are written by the comparisons themselves."""
    found = [path for folder in ("docs", "validation") for path in (source / folder).rglob("*.md") if path.name != "results.md"]
    return sorted([*found, *source.glob("*.md")])


def anchors(text):
    """What GitHub makes of headings."""
    headings = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-") for heading in headings}


def check(path, source):
    name = path.relative_to(source).as_posix()
    text = path.read_text(encoding="utf-8")
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > WIDEST and not line.lstrip().startswith("|"):
            yield f"{name}:{number}: {len(line)} columns, at most {WIDEST}"
    for link in LINK.findall(re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)):
        if re.match(r"[a-z]+:", link):
            continue
        file, _, anchor = link.partition("#")
        target = (path.parent / file).resolve() if file else path
        if not target.exists():
            yield f"{name}: no {link}"
        elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text(encoding="utf-8")):
            yield f"{name}: no heading for {link}"


def main():
    source = parse_arguments(__doc__).source
    found = pages(source)
    finish([problem for path in found for problem in check(path, source)], len(found), "faults")


main()
