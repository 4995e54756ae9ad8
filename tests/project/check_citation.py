# SPDX-License-Identifier: GPL-3.0-or-later
"""CITATION.cff and codemeta.json are well formed and name the version and the licence of the build."""

import json
import re

from _project import finish, parse_arguments

try:
    import yaml
except ImportError:
    yaml = None

REQUIRED = {"cff-version", "message", "title", "authors"}  # by the Citation File Format 1.2.0


def key_of(text, key):
    """A key of the outermost level of CITATION.cff; enough where there is no YAML reader."""
    found = re.search(rf"^{key}: (.+)$", text, re.MULTILINE)
    return found[1] if found else None


def check_citation(text, version):
    if key_of(text, "version") != version:
        yield f"CITATION.cff: version {key_of(text, 'version')}, expected {version} as in CMakeLists.txt"
    if yaml is None:
        print("no YAML reader (python3-yaml): of CITATION.cff, only the version was checked")
        return
    citation = yaml.safe_load(text)
    for key in sorted(REQUIRED - citation.keys()):
        yield f"CITATION.cff: lacks {key}"
    if citation.get("license") != "GPL-3.0-or-later":
        yield f"CITATION.cff: license {citation.get('license')}, expected GPL-3.0-or-later"
    for reference in citation.get("references", []):
        for key in sorted({"type", "title", "authors"} - reference.keys()):
            yield f"CITATION.cff: a reference lacks {key}"


def check_codemeta(text, version):
    codemeta = json.loads(text)
    expected = {"@type": "SoftwareSourceCode", "version": version, "license": "https://spdx.org/licenses/GPL-3.0-or-later"}
    for key, value in expected.items():
        if codemeta.get(key) != value:
            yield f"codemeta.json: {key} is {codemeta.get(key)}, expected {value}"


def main():
    source = parse_arguments(__doc__).source
    version = re.search(r"project\(corticle VERSION ([\d.]+)", (source / "CMakeLists.txt").read_text())[1]
    problems = [*check_citation((source / "CITATION.cff").read_text(encoding="utf-8"), version),
                *check_codemeta((source / "codemeta.json").read_text(encoding="utf-8"), version)]
    finish(problems, 2, "faults")


main()
