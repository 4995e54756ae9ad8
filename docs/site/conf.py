# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the project as a site: make docs. The source is the whole tree, so that links are those of the files."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

project = "Corticle"
version = release = next(line.split(" VERSION ")[1].split()[0].rstrip(")") for line in (ROOT / "CMakeLists.txt").read_text().splitlines()
                         if line.strip().startswith("project(") and " VERSION " in line)
extensions = ["myst_parser"]
root_doc = "docs/site/index"
include_patterns = ["docs/site/index.md", "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/guide/*.md", "docs/theory/*.md",
                    "docs/decisions/*.md", "validation/*/*.md", "validation/*/*/*.md"]
myst_heading_anchors = 4
# Links to cases, scripts and folders lead to files that are no pages.
suppress_warnings = ["myst.xref_missing", "myst.header", "toc.not_included"]
html_extra_path = ["start"]    # index.html, which leads to the first page
html_theme = "alabaster"
html_theme_options = {"description": "Meshless simulation of cortical folding", "page_width": "1100px"}
