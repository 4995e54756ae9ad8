# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases: what is folded, and how."""

import html
import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from corticle import _corticle
from corticle._core import parameters, path_text
from corticle._files import Scratch, write_inputs
from corticle.errors import InputError
from corticle.sections import Sections, is_in_list

PathLike = Union[str, "os.PathLike[str]"]

_PARAMETERS = {row["key"]: row for row in parameters()}


def _full_key(name: str) -> str:
    """The key "section.key" of a name that is one, or of a key alone that only one section has."""
    if name in _PARAMETERS:
        return name
    found = [key for key in _PARAMETERS if key.rsplit(".", 1)[1] == name and not is_in_list(key)]
    if len(found) > 1:
        raise InputError(f"key {name}: is in several sections, expected one of {', '.join(found)}")
    return found[0] if found else name


def _plain(value: Any) -> Any:
    """Scalars and arrays of numpy, tuples and paths as what a case holds."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (tuple, range)):
        return [_plain(item) for item in value]
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value


class Case(Sections):
    """What is folded, and how: the keys of a case file, with the same names, defaults, checks and messages.

    Every key is an attribute of its section, `case.geometry.particles`, and an item, `case["geometry.particles"]`. To set
    one checks its type and range; what several keys must fulfil together is checked when the case is used, or by
    `check()`. To delete one takes back what was set. `corticle.parameters()` lists all.

    A case is made by one of `Case.load`, `Case.from_toml`, `Case.sphere`, `Case.ellipsoid`, `Case.file`, `Case.brain` and
    `Case.surface`. Where they take keys by name, a key alone will do if one section has it:
    `Case.sphere(particles=8000)`. What is set here replaces what a case file says, as `--set` does.
    """

    def __init__(self, keys: Optional[Mapping[str, Any]] = None, **named: Any) -> None:
        super().__init__()
        self._text = ""
        self._name = "case"
        self._folder = ""
        self._given: Dict[str, Any] = {}
        self._scratch: Optional[Scratch] = None
        self.update(keys, **named)

    # Where cases come from

    @classmethod
    def load(cls, path: PathLike, **keys: Any) -> "Case":
        """The case of a file (TOML), with other values for some keys.

        Raises:
            InputError: no such file, or something in it is wrong; the message names the line.
        """
        name = path_text(path, "case")
        return cls.from_toml(_corticle.read_case_text(name), os.path.dirname(name), name, keys)

    @classmethod
    def from_toml(cls, text: str, folder: PathLike = "", name: str = "case", keys: Optional[Mapping[str, Any]] = None) -> "Case":
        """The case of a text, with other values for some keys. `folder` is what its paths are relative to, `name` what
        messages call it.

        Raises:
            InputError: something in the text is wrong; the message names the line.
        """
        if not isinstance(text, str):
            raise InputError(f"{name}: got an object of type {type(text).__name__}, expected TOML as text")
        case = cls()
        case._text, case._name, case._folder = text, name, os.path.abspath(path_text(folder, "folder") or ".")
        case.update(keys)
        case.check()
        return case

    @classmethod
    def sphere(cls, keys: Optional[Mapping[str, Any]] = None, **named: Any) -> "Case":
        """A sphere, of `radius_mm`."""
        return cls({"geometry.shape": "sphere"}).update(keys, **named)

    @classmethod
    def ellipsoid(cls, keys: Optional[Mapping[str, Any]] = None, **named: Any) -> "Case":
        """An ellipsoid, of `semi_axes_mm`."""
        return cls({"geometry.shape": "ellipsoid"}).update(keys, **named)

    @classmethod
    def file(cls, path: PathLike, keys: Optional[Mapping[str, Any]] = None, **named: Any) -> "Case":
        """A body from a file: a closed surface, a label volume or a tet mesh."""
        return cls({"geometry.shape": "file", "geometry.file": path}).update(keys, **named)

    @classmethod
    def brain(cls, labels_image: Any, labels: Optional[Sequence[int]] = None, keys: Optional[Mapping[str, Any]] = None,
              **named: Any) -> "Case":
        """A brain from an image of tissue labels.

        Args:
            labels_image: path of a NIfTI file, or an image of nibabel.
            labels: those that are the body; None: all but 0.

        Raises:
            InputError: the image is neither.
        """
        case = cls()
        if isinstance(labels_image, (str, os.PathLike)):
            path = path_text(labels_image, "labels_image")
        else:
            path = case._keep().save_image(labels_image)
        case.update({"geometry.shape": "file", "geometry.file": path})
        if labels is not None:
            case["geometry.labels"] = labels
        return case.update(keys, **named)

    @classmethod
    def surface(cls, vertices: Any, triangles: Any = None, *, growth: Any = None, thickness: Any = None, still: Any = None,
                regions: Any = None, region_growth: Optional[Mapping[int, float]] = None,
                keys: Optional[Mapping[str, Any]] = None, **named: Any) -> "Case":
        """A body within a closed surface, given by arrays, with maps at its vertices.

        The arrays are written to a folder for temporary files, which is deleted after the last case, body and simulation
        that needs it.

        Args:
            vertices: (n, 3) [mm]; or a `corticle.Surface`, without triangles.
            triangles: (m, 3) indices of vertices, counter-clockwise seen from outside.
            growth: (n,) regional growth, a factor of alpha_t [-].
            thickness: (n,) thickness of the cortex at t = 0 [mm].
            still: (n,) not 0 where nothing grows.
            regions: (n,) labels, whole numbers.
            region_growth: factor of alpha_t in each region [-], by label.

        Raises:
            InputError: an array has the wrong shape or type, or holds what is not finite.
        """
        case = cls()
        maps = {"growth": growth, "thickness": thickness, "still": still, "region": regions}
        files = write_inputs(case._keep(), vertices, triangles, maps, region_growth)
        return case.update({"geometry.shape": "file", **files}).update(keys, **named)

    # Keys

    def __getitem__(self, name: str) -> Any:
        """The value of a key; None where it has none.

        Raises:
            InputError: there is no such key; the message names the nearest.
        """
        key = _full_key(name)
        if key in self._given:
            value = self._given[key]
            return list(value) if isinstance(value, list) else value
        if key not in _PARAMETERS:
            _corticle.check_value(key, None, f"case.{key}")
        try:
            return self._resolved().value(key)
        except InputError:  # keys that do not go together yet: check() says which
            return _corticle.resolve(self._text, self._name, [], self._folder).value(key)

    def __setitem__(self, name: str, value: Any) -> None:
        """Sets a key.

        Raises:
            InputError: there is no such key, or the value has the wrong type or is out of range.
        """
        key = _full_key(name)
        value = _plain(value)
        _corticle.check_value(key, value, f"case.{key}")
        if _PARAMETERS[key]["is_path"] and value:
            value = os.path.abspath(path_text(value, f"case.{key}"))
        self._given.pop(key, None)
        self._given[key] = value

    def __delitem__(self, name: str) -> None:
        """Takes back what was set: the key has the value of the case file again, or its default."""
        key = _full_key(name)
        if key not in _PARAMETERS:
            _corticle.check_value(key, None, f"case.{key}")
        self._given.pop(key, None)

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            raise InputError(f"case.{name}: is no key; expected case.SECTION.KEY, or case[\"SECTION.KEY\"]")
        object.__setattr__(self, name, value)

    def update(self, keys: Optional[Mapping[str, Any]] = None, **named: Any) -> "Case":
        """Sets several keys; returns the case."""
        for key, value in {**(keys or {}), **named}.items():
            self[key] = value
        return self

    def keys(self) -> List[str]:
        """All keys that a case can have, "section.key"."""
        return list(_PARAMETERS)

    # Use

    def check(self) -> List[str]:
        """Checks the case as a whole; returns what is allowed but probably not meant, one line each.

        Raises:
            InputError: keys that exclude or need each other, and the like.
        """
        return self._resolved().warnings()

    def to_toml(self) -> str:
        """The case with every key, as the run folder's case.toml has it. Raises InputError as `check()` does."""
        return self._resolved().text

    def save(self, path: PathLike) -> None:
        """Writes `to_toml()` to a file, for `corticle run`."""
        Path(path_text(path)).write_text(self.to_toml(), encoding="utf-8")

    def copy(self) -> "Case":
        """Another case of the same keys."""
        other = type(self)()
        other.__dict__.update({key: value for key, value in self.__dict__.items() if key not in self._sections()})
        other._given = dict(self._given)
        return other

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Case":
        return self.copy()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self.to_toml() == other.to_toml()

    __hash__ = None  # type: ignore[assignment]

    def __getstate__(self) -> Dict[str, Any]:
        return {"text": self._text, "name": self._name, "folder": self._folder, "given": self._given,
                "files": self._scratch.contents() if self._scratch else {}}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        Case.__init__(self)
        self._text, self._name, self._folder = state["text"], state["name"], state["folder"]
        self._given = dict(state["given"])
        moved = self._keep().restore(state["files"]) if state["files"] else {}
        self._given.update({key: moved[value] for key, value in self._given.items() if _hashable_in(value, moved)})

    def __repr__(self) -> str:
        given = ", ".join(f"{key}={value!r}" for key, value in self._given.items())
        return f"<corticle.Case {self._name}{': ' if given else ''}{given}>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.to_toml())}</pre>"

    @classmethod
    def _sections(cls) -> List[str]:
        return list({key.split(".", 1)[0]: None for key in _PARAMETERS})

    def _resolved(self) -> Any:
        return _corticle.resolve(self._text, self._name, list(self._given.items()), self._folder)

    def _keep(self) -> Scratch:
        """The folder of files that the case was made with."""
        if self._scratch is None:
            self._scratch = Scratch()
        return self._scratch


def _hashable_in(value: Any, known: Mapping[str, str]) -> bool:
    return isinstance(value, str) and value in known
