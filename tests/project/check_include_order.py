# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder of src/corticle includes only itself and the folders before it in ORDER."""

import re

from _project import finish, parse_arguments

ORDER = """
base base/ranks mesh material dynamics mechanics mechanics/tlsph mechanics/fem mechanics/boundary mechanics/tracts mechanics/contact mechanics/thesis model
geometry imaging cloud metrics/surface metrics formats formats/volumes formats/surfaces formats/tets prepare/thesis
prepare config/parameters config record view view/figures study study/comparison study/sweep study/surrogate study/fit study/sensitivity study/regions report
""".split()
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]corticle/([^"<>]+)[">]', re.MULTILINE)
RELATIVE = re.compile(r'^\s*#\s*include\s*"(?!corticle/)([^"]+)"', re.MULTILINE)


def check(path, library):
    folder = path.parent.relative_to(library).as_posix()
    if folder not in ORDER:
        yield f"{path}: folder '{folder}' has no place in the order {' '.join(ORDER)}"
        return
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        other = match.group(1).rpartition("/")[0]
        where = f"{path}:{text.count(chr(10), 0, match.start(1)) + 1}"
        if other not in ORDER:
            yield f"{where}: includes unknown folder '{other}'"
        elif ORDER.index(other) > ORDER.index(folder):
            yield f"{where}: {folder} comes before {other} and must not include it"
        elif not (library / match.group(1)).is_file():
            yield f"{where}: there is no corticle/{match.group(1)}"
    for match in RELATIVE.finditer(text):
        line = text.count("\n", 0, match.start(1)) + 1
        yield f'{path}:{line}: write "corticle/<folder>/{match.group(1)}", from the root of src'


def main():
    library = parse_arguments(__doc__).source / "src" / "corticle"
    files = sorted(path for path in library.rglob("*") if path.suffix in (".cpp", ".hpp"))
    finish([problem for path in files for problem in check(path, library)], len(files), "includes out of order")


main()
