# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of a case, with an attribute for every key: made from the one table of parameters.

`sections.pyi` says the same to type checkers; `python -m corticle.sections` prints it, from the same table.
"""

import keyword

from corticle import _corticle
from corticle.errors import InputError

_TYPES = {"bool": "bool", "int": "int", "float": "float", "str": "str", "list": "Sequence[float]", "integers": "Sequence[int]"}


def _split(key):
    """Section, which may be one within another, and name: tissue.labels, cortex."""
    return key.rsplit(".", 1)


def is_in_list(key):
    """Whether a key is one of a list of tables: support.1.kind."""
    return _split(key)[0][-1].isdigit()


def _class_name(section):
    return "".join(part.capitalize() for part in section.split("."))


def attribute(key):
    """The attribute of a key in its section; one that Python keeps for itself gets an underscore: tissue.lambda_."""
    name = _split(key)[1]
    return f"{name}_" if keyword.iskeyword(name) else name


def _name(attribute_name):
    """The key of an attribute within its section."""
    bare = attribute_name[:-1]
    return bare if attribute_name.endswith("_") and keyword.iskeyword(bare) else attribute_name


class Section:
    """The keys of one section of a case. To set one checks it; to delete one takes back what was set."""

    __slots__ = ("_case",)
    _name = ""
    _keys = ()

    def __init__(self, case):
        object.__setattr__(self, "_case", case)

    def __setattr__(self, name, value):
        self._case[f"{self._name}.{_name(name)}"] = value

    def __delattr__(self, name):
        del self._case[f"{self._name}.{_name(name)}"]

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self._case[f"{self._name}.{_name(name)}"]
        except ValueError as error:
            raise AttributeError(str(error)) from None

    def __dir__(self):
        return [*super().__dir__(), *self._keys]

    def __repr__(self):
        return "\n".join([f"[{self._name}]", *(f"{_name(name)} = {getattr(self, name)!r}" for name in self._keys)])


class Tables(Section):
    """A list of tables: `case.support[2]` is the second [[support]]."""

    __slots__ = ()

    def __getitem__(self, number):
        """One of the tables, from 1. Raises InputError where there is none of this number."""
        if isinstance(number, bool) or not isinstance(number, int) or str(number) not in self._keys:
            raise InputError(f"case.{self._name}: got [{number!r}], expected an integer from 1 to {len(self)}")
        return getattr(self, str(number))

    def __len__(self):
        """How many there can be."""
        return len(self._keys)

    def __dir__(self):
        return object.__dir__(self)


def _key(row):
    """The attribute of a key, with its documentation."""
    key = row["key"]
    expected = row["expected"] + ("" if row["default"] is None else f"; by default {row['default']!r}")
    return property(lambda self: self._case[key], lambda self, value: self._case.__setitem__(key, value),
                    lambda self: self._case.__delitem__(key), f"{row['sentence']} Expected: {expected}.")


def _sections():
    rows = {}
    for row in _corticle.parameters():
        section = _split(row["key"])[0]
        if "." in section:
            rows.setdefault(section.rsplit(".", 1)[0], [])
        rows.setdefault(section, []).append(row)
    return rows


def _inner(name):
    """Names of the sections within one."""
    return [section.rsplit(".", 1)[1] for section in _sections() if "." in section and section.rsplit(".", 1)[0] == name]


def _is_list(name):
    """Whether the sections within one are tables of a list: support.1, support.2 ..."""
    inner = _inner(name)
    return bool(inner) and all(part.isdigit() for part in inner)


def _section(name):
    """The attribute of a section within another."""
    return property(lambda self: SECTIONS[name](self._case), doc=f"The keys of [{name}].")


def _section_class(name, rows):
    keys = {attribute(row["key"]): _key(row) for row in rows}
    inner = {part: _section(f"{name}.{part}") for part in _inner(name)}
    members = {"__slots__": (), "__doc__": f"The keys of [{name}].", "_name": name, "_keys": (*keys, *inner), **keys, **inner}
    return type(_class_name(name), (Tables if _is_list(name) else Section,), members)


SECTIONS = {name: _section_class(name, rows) for name, rows in _sections().items()}
globals().update({made.__name__: made for made in SECTIONS.values()})


class Sections:
    """What has a section of every name as an attribute."""

    def __init__(self):
        for name, made in SECTIONS.items():
            if "." not in name:
                object.__setattr__(self, name, made(self))


def _type_of(row):
    read = _TYPES.get(row["kind"], "str")
    return f"Optional[{read}]" if row["default"] is None else read


def _stub_of_section(name, rows):
    first = f"{name}.1"
    if _is_list(name):
        return [f"class {_class_name(name)}(Section):", f"    def __getitem__(self, number: int) -> {_class_name(first)}: ...",
                "    def __len__(self) -> int: ...", ""]
    lines = [f"class {_class_name(name)}(Section):", *(f"    {attribute(row['key'])}: {_type_of(row)}" for row in rows)]
    for part in _inner(name):
        lines += ["    @property", f"    def {part}(self) -> {_class_name(name + '.' + part)}: ..."]
    return [*lines, ""]


def stub():
    """The text of sections.pyi."""
    lines = ["# SPDX-License-Identifier: GPL-3.0-or-later",
             "# Made by `python -m corticle.sections > python/corticle/sections.pyi`; a test says when that is due.",
             "from typing import Any, Optional, Sequence", "",
             "def is_in_list(key: str) -> bool: ...", "",
             "class Section:", "    def __init__(self, case: Any) -> None: ...", ""]
    for name, rows in _sections().items():
        if not name[-1].isdigit() or name.endswith(".1"):  # tables of a list are all of one kind
            lines += _stub_of_section(name, rows)
    lines += ["class Sections:", "    def __init__(self) -> None: ..."]
    for name in _sections():
        if "." not in name:
            lines += ["    @property", f"    def {name}(self) -> {_class_name(name)}: ..."]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(stub(), end="")
