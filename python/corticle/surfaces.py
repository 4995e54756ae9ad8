# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces: what folds look like, and what they measure."""

import base64
import html
import io
import os
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from corticle import _arrays, _corticle
from corticle._arrays import FloatArray, IntArray
from corticle._core import path_text, warn
from corticle.errors import InputError

PathLike = Union[str, "os.PathLike[str]"]

_FOLD_ARRAYS = ("mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "sulcal_depth", "local_gyrification")


class Surface:
    """A triangulated surface with arrays at its vertices.

    Args:
        vertices: (n, 3) [mm], in the frame of the input.
        triangles: (m, 3) indices of vertices, counter-clockwise seen from outside.
        arrays: by name, (n,) or (n, k).
        t: growth time [-], of a surface of a run.
        week: gestational age [weeks], of one with a clock.

    Raises:
        InputError: an array has the wrong shape or type, or vertices are not finite.
    """

    def __init__(self, vertices: Any, triangles: Any, arrays: Optional[Mapping[str, Any]] = None, *,
                 t: Optional[float] = None, week: Optional[float] = None) -> None:
        self._vertices = _arrays.kept(_arrays.points(vertices), vertices)
        count = len(self._vertices)
        self._triangles = _arrays.kept(_arrays.triangles(triangles, count), triangles)
        self.t = t
        self.week = week
        self._arrays: Dict[str, Any] = {}
        for name, values in (arrays or {}).items():
            array = np.asarray(values)
            if array.ndim == 0 or len(array) != count:
                raise InputError(f"{name}: got an array of shape {array.shape}, expected one row for each of {count} vertices")
            self._arrays[name] = _arrays.kept(array, values)

    @property
    def vertices(self) -> FloatArray:
        """(n, 3) [mm]; read-only."""
        return self._vertices

    @property
    def triangles(self) -> IntArray:
        """(m, 3) indices of vertices, counter-clockwise seen from outside; read-only."""
        return self._triangles

    @property
    def arrays(self) -> Dict[str, Any]:
        """Arrays at the vertices, by name; those of folds too, once they were asked for."""
        return dict(self._arrays)

    def __getitem__(self, name: str) -> Any:
        """An array at the vertices: one of `arrays`, or one of the folds, which is then computed: mean_curvature [1/mm],
        gaussian_curvature [1/mm²], shape_index [-], curvedness [1/mm], sulcal_depth [mm], local_gyrification [-].

        Raises:
            KeyError: there is no array of this name.
            InputError: the surface is not closed, so that it has no folds.
        """
        if name not in self._arrays and name in _FOLD_ARRAYS:
            for key, values in self.fold_arrays().items():
                self._arrays.setdefault(key, values)
        return self._arrays[name]

    @property
    def sulcal_depth(self) -> FloatArray:
        """(n,) depth below the convex hull [mm]."""
        return self["sulcal_depth"]

    @property
    def mean_curvature(self) -> FloatArray:
        """(n,) mean curvature, positive on gyri [1/mm]."""
        return self["mean_curvature"]

    def fold_arrays(self, outer: str = "hull") -> Dict[str, FloatArray]:
        """The arrays of the folds; depth and local gyrification against "hull" or "closed" (a ball rolled around)."""
        return _corticle.fold_fields(*self._plain(), outer)

    def measures(self, outer: str = "hull") -> Dict[str, float]:
        """Size, indices and folds, as `corticle measure` gives them. Raises InputError where it is not closed."""
        return _corticle.measure_surface(*self._plain(), outer)

    def to_nibabel(self) -> Any:
        """As a nibabel GiftiImage: coordinates [mm] and triangles."""
        from nibabel.gifti import GiftiDataArray, GiftiImage

        points = GiftiDataArray(self.vertices.astype(np.float32), intent="NIFTI_INTENT_POINTSET", datatype="NIFTI_TYPE_FLOAT32")
        corners = GiftiDataArray(np.array(self.triangles), intent="NIFTI_INTENT_TRIANGLE", datatype="NIFTI_TYPE_INT32")
        return GiftiImage(darrays=[points, corners])

    def to_shape(self, name: str) -> Any:
        """One array as a nibabel GiftiImage of intent SHAPE: what a .shape.gii holds."""
        from nibabel.gifti import GiftiDataArray, GiftiImage, GiftiMetaData

        values = np.asarray(self[name], dtype=np.float32)
        array = GiftiDataArray(values, intent="NIFTI_INTENT_SHAPE", datatype="NIFTI_TYPE_FLOAT32",
                               meta=GiftiMetaData({"Name": name}))
        return GiftiImage(darrays=[array])

    def to_meshio(self) -> Any:
        """As a meshio Mesh, with the arrays as point data."""
        import meshio

        return meshio.Mesh(np.array(self.vertices), [("triangle", np.array(self.triangles))],
                           point_data={name: np.array(values) for name, values in self._arrays.items()})

    def to_vtk(self) -> Any:
        """As a vtkPolyData, with the arrays as point data."""
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.array(self.vertices, order="C"), deep=True))
        corners = np.hstack([np.full((len(self.triangles), 1), 3), self.triangles]).astype(np.int64)
        cells = vtkCellArray()
        cells.SetCells(len(self.triangles), numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
        data = vtkPolyData()
        data.SetPoints(points)
        data.SetPolys(cells)
        for name, values in self._arrays.items():
            array = numpy_to_vtk(np.array(values, order="C"), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        return data

    def to_pyvista(self) -> Any:
        """As a pyvista PolyData. Raises ImportError where pyvista is not installed."""
        import pyvista

        return pyvista.wrap(self.to_vtk())

    def to_trimesh(self) -> Any:
        """As a trimesh Trimesh, vertices as they are. Raises ImportError where trimesh is not installed."""
        import trimesh

        return trimesh.Trimesh(np.array(self.vertices), np.array(self.triangles), process=False)

    def save(self, path: PathLike) -> None:
        """Writes the surface: GIFTI (.gii, with nibabel), else what meshio knows of the extension (.vtu, .ply, .stl, ...)."""
        name = path_text(path)
        if name.endswith(".gii"):
            self.to_nibabel().to_filename(name)
        else:
            self.to_meshio().write(name)

    def save_shape(self, name: str, path: PathLike) -> None:
        """Writes one array as GIFTI: `surface.save_shape("sulcal_depth", "depth.shape.gii")`."""
        self.to_shape(name).to_filename(path_text(path))

    def __repr__(self) -> str:
        at = "" if self.t is None else f" at t = {self.t:.4g}"
        week = "" if self.week is None else f", week {self.week:.4g}"
        return f"<corticle.Surface{at}{week}: {len(self.vertices)} vertices, {len(self.triangles)} triangles>"

    def _repr_png_(self) -> Optional[bytes]:
        """A small picture from the left, by depth along the view; None without matplotlib."""
        try:
            from matplotlib.backends.backend_agg import FigureCanvasAgg
            from matplotlib.figure import Figure
        except ImportError:
            return None
        figure = Figure(figsize=(4, 3), layout="tight")
        FigureCanvasAgg(figure)
        _draw(figure.add_subplot(), self.vertices, self.triangles)
        png = io.BytesIO()
        figure.savefig(png, format="png", dpi=100)
        return png.getvalue()

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(str(np.shape(values)))}</td></tr>"
                       for name, values in self._arrays.items())
        png = self._repr_png_()
        picture = "" if png is None else f'<img src="data:image/png;base64,{base64.b64encode(png).decode()}">'
        return f"<p>{html.escape(repr(self)[1:-1])}</p>{picture}<table>{rows}</table>"

    def _plain(self) -> Tuple[FloatArray, IntArray]:
        return np.ascontiguousarray(self._vertices), np.ascontiguousarray(self._triangles)


def _draw(axes: Any, vertices: FloatArray, triangles: IntArray) -> None:
    """Triangles that face the viewer (from -x), far ones first, lit from the viewer."""
    from matplotlib.collections import PolyCollection

    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = -normals[:, 0] / np.where(lengths > 0.0, lengths, 1.0)
    facing = np.flatnonzero(light > 0.0)
    order = facing[np.argsort(-corners[facing, :, 0].mean(axis=1))]
    axes.add_collection(PolyCollection(corners[order][:, :, 1:], array=light[order], cmap="gray", clim=(-0.3, 1.0),
                                       edgecolors="face", linewidths=0.2))
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_axis_off()


def measure(source: Any, triangles: Any = None, *, labels: Optional[Sequence[int]] = None, outer: str = "hull",
            unit: str = "mm", coordinates: str = "scanner") -> Dict[str, float]:
    """Size, indices and folds of a closed surface or of labels, as `corticle measure` gives them.

    Args:
        source: a path (STL, OBJ, PLY, OFF, VTP, GIFTI, FreeSurfer, or NIfTI labels), a Surface, or (n, 3) vertices [mm].
        triangles: (m, 3) indices of the vertices.
        labels: those of a label volume that are the body; None: all but 0.
        outer: what depth and the local index are measured against: "hull" or "closed".
        unit, coordinates: of a surface file, as the keys of [geometry].

    Returns:
        The measures by name; `corticle.Surface.measures` has the same.

    Raises:
        InputError: what is measured cannot be read, is not closed, or crosses itself.
    """
    if isinstance(source, Surface):
        return source.measures(outer)
    if not isinstance(source, (str, os.PathLike)):
        return Surface(source, triangles).measures(outer)
    wanted = [] if labels is None else [int(label) for label in labels]
    rows, lines = _corticle.measure_file(path_text(source), wanted, unit, coordinates, outer)
    warn(lines)
    return rows


def read_surface(path: PathLike, *, unit: str = "mm", coordinates: str = "scanner") -> Surface:
    """A surface file as `Case.file` reads it: vertices at the same position merged, in mm, in scanner coordinates where
    the file says how. Raises InputError where it cannot be read."""
    return Surface(*_corticle.read_surface(path_text(path), unit, coordinates))


def phantom(path: PathLike, *, length_mm: float = 64.0, voxel_mm: float = 0.8) -> None:
    """Writes the labels of a phantom of a fetal brain as NIfTI (.nii or .nii.gz), as `corticle new brain` does: cortical
    grey matter 2, white matter 3, ventricles 5, deep grey matter 7, fluid 1.

    Raises:
        InputError: the file is there already, or sizes are not positive or make too many voxels.
    """
    name = path_text(path)
    if os.path.lexists(name):
        raise InputError(f"{name}: is there already, and phantom never overwrites")
    _corticle.write_phantom(name, float(length_mm), float(voxel_mm))
