# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of the user's, checked and in the form that the compiled module takes."""

from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from corticle.errors import InputError

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]


def _array(value: Any, what: str) -> "npt.NDArray[Any]":
    try:
        array = np.asarray(value)
    except Exception as error:
        raise InputError(f"{what}: got an object of type {type(value).__name__}, expected an array ({error})") from error
    if array.dtype.kind not in "fiu":
        raise InputError(f"{what}: got an array of {array.dtype}, expected real numbers")
    return array


def _finite(array: FloatArray, what: str) -> FloatArray:
    if not np.isfinite(array).all():
        where = np.argwhere(~np.isfinite(array))[0]
        raise InputError(f"{what}: got {array[tuple(where)]} at row {where[0]}, expected finite numbers")
    return array


def points(value: Any, what: str = "vertices") -> FloatArray:
    """(n, 3) finite float64 in C order, n > 0, of any real array of this shape."""
    array = _array(value, what)
    if array.ndim != 2 or array.shape[1] != 3 or array.shape[0] == 0:
        raise InputError(f"{what}: got an array of shape {array.shape}, expected (n, 3), n > 0")
    return _finite(np.ascontiguousarray(array, dtype=np.float64), what)


def numbers(value: Any, count: Optional[int], what: str) -> FloatArray:
    """(count,) finite float64 in C order, of any real array of this shape."""
    array = _array(value, what)
    if array.ndim != 1 or (count is not None and array.shape[0] != count):
        expected = "one dimension" if count is None else f"shape ({count},)"
        raise InputError(f"{what}: got an array of shape {array.shape}, expected {expected}")
    return _finite(np.ascontiguousarray(array, dtype=np.float64), what)


def triangles(value: Any, vertex_count: int, what: str = "triangles") -> IntArray:
    """(m, 3) int32 in C order, m > 0, of any array of integers from 0 to vertex_count - 1 of this shape."""
    array = _array(value, what)
    if array.ndim != 2 or array.shape[1] != 3 or array.shape[0] == 0:
        raise InputError(f"{what}: got an array of shape {array.shape}, expected (m, 3), m > 0")
    if array.dtype.kind == "f":
        raise InputError(f"{what}: got an array of {array.dtype}, expected integers, indices of vertices")
    if array.min() < 0 or array.max() >= vertex_count:
        bad = array.min() if array.min() < 0 else array.max()
        raise InputError(f"{what}: got the index {bad}, expected 0 to {vertex_count - 1}")
    return np.ascontiguousarray(array, dtype=np.int32)


def kept(array: "npt.NDArray[Any]", given: Any) -> "npt.NDArray[Any]":
    """`array`, made of what was given, read-only; a copy where others could still write to it."""
    is_shared = array is given or (isinstance(given, np.ndarray) and np.may_share_memory(array, given))
    mine = array.copy() if is_shared and given.flags.writeable else array.view()
    mine.flags.writeable = False
    return mine
