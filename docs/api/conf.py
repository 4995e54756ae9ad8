# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference of the Python package, made from its docstrings: make docs."""

import corticle

project = "Corticle"
version = release = corticle.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
html_theme = "alabaster"
html_theme_options = {"description": "Meshless simulation of cortical folding"}
