# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for inputs that the user has in memory: the library reads them as it reads any other."""

import tempfile
from pathlib import Path
from typing import Any, Dict, Mapping, Optional

import numpy as np

from corticle import _arrays, _corticle
from corticle.errors import InputError


class Scratch:
    """A folder for temporary files, deleted with the object."""

    def __init__(self) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="corticle-")
        self.path = Path(self._folder.name)

    def save_image(self, image: Any) -> str:
        """An image of nibabel as a file; its path."""
        if not hasattr(image, "to_filename") or not hasattr(image, "header"):
            raise InputError(f"labels_image: got an object of type {type(image).__name__}, expected a path or an image of nibabel")
        path = self.path / "labels.nii.gz"
        image.to_filename(str(path))
        return str(path)

    def contents(self) -> Dict[str, bytes]:
        """The files by path."""
        return {str(path): path.read_bytes() for path in sorted(self.path.iterdir())}

    def restore(self, contents: Mapping[str, bytes]) -> Dict[str, str]:
        """Writes such files; where each of the old paths is now."""
        moved = {}
        for old, content in contents.items():
            path = self.path / Path(old).name
            path.write_bytes(content)
            moved[old] = str(path)
        return moved


def _arrays_of(vertices: Any, triangles: Any) -> Any:
    if triangles is None:
        if not hasattr(vertices, "vertices") or not hasattr(vertices, "triangles"):
            raise InputError("triangles: got None, expected (m, 3) indices of vertices, or a Surface in place of both")
        vertices, triangles = vertices.vertices, vertices.triangles
    points = _arrays.points(vertices)
    return points, _arrays.triangles(triangles, len(points))


def _write_map(scratch: Scratch, name: str, values: Any, count: int) -> Dict[str, str]:
    path = scratch.path / f"{name}.csv"
    np.savetxt(path, _arrays.numbers(values, count, name), fmt="%.17g")
    return {f"map.{name}_file": str(path)}


def write_inputs(scratch: Scratch, vertices: Any, triangles: Any, maps: Mapping[str, Any],
                 region_growth: Optional[Mapping[int, float]]) -> Dict[str, str]:
    """Writes a surface and the maps at its vertices; the keys that name the files."""
    points, corners = _arrays_of(vertices, triangles)
    surface = str(scratch.path / "surface.ply")
    _corticle.write_ply(surface, points, corners)
    keys = {"geometry.file": surface}
    for name, values in maps.items():
        if values is not None:
            keys.update(_write_map(scratch, name, values, len(points)))
    if region_growth is not None:
        table = scratch.path / "regions.csv"
        rows = [f"{int(label)},{float(factor)!r}" for label, factor in region_growth.items()]
        table.write_text("\n".join(["label,growth", *rows]) + "\n", encoding="utf-8")
        keys["map.region_table"] = str(table)
    return keys
