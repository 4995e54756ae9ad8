# SPDX-License-Identifier: GPL-3.0-or-later
"""What all parts of the package use of the compiled module."""

import os
import sys
import warnings
from typing import Any, Dict, Iterable, List, Optional

from corticle import _corticle
from corticle.errors import CorticleWarning, InputError

__version__: str = _corticle.version


def threads() -> int:
    """Number of threads that simulations use, if the calling thread starts them."""
    return _corticle.threads()


def set_threads(count: Optional[int]) -> None:
    """Sets the number of threads of all work from now on; None: as many as OpenMP takes by itself, all cores.

    Results do not depend on it, bit for bit.

    Raises:
        InputError: count is not None or an integer from 1 to 1024.
    """
    if count is not None and (isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= 1024):
        raise InputError(f"threads: got {count!r}, expected an integer from 1 to 1024, or None for all cores")
    _corticle.set_threads(count or 0)


def parameters() -> List[Dict[str, Any]]:
    """Every key of a case, in order, as a dict: key, kind, unit, expected, choices, is_path, sentence, default."""
    return _corticle.parameters()


def path_text(path: Any, what: str = "path") -> str:
    """A path as the compiled module takes it.

    Raises:
        InputError: it is no path, or holds a character that no path has.
    """
    if not isinstance(path, (str, os.PathLike)):
        raise InputError(f"{what}: got an object of type {type(path).__name__}, expected a path")
    text = os.fspath(path)
    if not isinstance(text, str) or "\0" in text:
        raise InputError(f"{what}: got {text!r}, expected a path as text")
    return text


def warn(lines: Iterable[str]) -> None:
    """Each line as a CorticleWarning of the first caller outside of the package."""
    depth = 1
    frame = sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("corticle"):
        frame = frame.f_back
        depth += 1
    for line in lines:
        warnings.warn(line, CorticleWarning, stacklevel=depth)
