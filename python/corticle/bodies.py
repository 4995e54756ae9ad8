# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies: what a case folds, before it grows."""

import os
from typing import Any, List, Mapping, Optional, Sequence

import numpy as np

from corticle import _arrays, _corticle
from corticle._arrays import FloatArray, IntArray
from corticle._core import warn
from corticle.cases import Case
from corticle.errors import InputError
from corticle.surfaces import Surface


class Body:
    """A body before it grows: particles (or nodes of tets), surface, tissue. Constant; simulations can share one.

    Made by `prepare`. Its arrays are read-only views without a copy, and stay valid after the body is gone.
    """

    def __init__(self, core: Any, case: Case, fields: Optional[Mapping[str, FloatArray]] = None) -> None:
        self._core = core
        self._case = case
        self._fields = dict(fields or {})

    @property
    def case(self) -> Case:
        """A copy of the case that it was prepared for."""
        return self._case.copy()

    @property
    def positions(self) -> FloatArray:
        """(n, 3) reference positions X of the particles [mm]."""
        return self._core.positions

    @property
    def volumes(self) -> FloatArray:
        """(n,) reference volumes of the particles [mm³]."""
        return self._core.volumes

    @property
    def depth(self) -> FloatArray:
        """(n,) reference distance of the particles' material to the surface [mm]."""
        return self._core.depth

    @property
    def normals(self) -> FloatArray:
        """(n, 3) unit normals that growth is tangential to, in the reference frame [-]."""
        return self._core.normals

    @property
    def growth(self) -> FloatArray:
        """(n,) regional growth, a factor of alpha_t, without the imperfection [-]."""
        return self._core.growth

    @property
    def thickness(self) -> Optional[FloatArray]:
        """(n,) thickness of the cortex at the closest surface point, at t = 0 [mm]; None: the same everywhere."""
        values: FloatArray = self._core.thickness
        return values if len(values) else None

    @property
    def fibres(self) -> Optional[FloatArray]:
        """(n, 3) unit directions of the fibres, in the reference frame [-]; None in a case without fibres. Where there is no
        white matter, or a direction of length 0 was given, there are no fibres, whatever is said here."""
        values: FloatArray = self._core.fibres
        return values if len(values) else None

    @property
    def surface_particles(self) -> IntArray:
        """(k,) the particle that sits on each vertex of the surface."""
        return self._core.surface_particles

    @property
    def spacing(self) -> float:
        """Mean distance between adjacent particles, at the surface [mm]."""
        return self._core.spacing

    @property
    def surface(self) -> Surface:
        """The reference surface [mm]; its vertices are particles."""
        return Surface(self._core.vertices, self._core.triangles)

    @property
    def source(self) -> str:
        """What it was made from: "sphere", "ellipsoid", "surface", "labels" or "tets"."""
        return self._core.source

    @property
    def notes(self) -> List[str]:
        """What was found in the input and done to it, one line each."""
        return self._core.notes

    @property
    def warnings(self) -> List[str]:
        """What is probably not meant, one line each; `prepare` has warned of them."""
        return self._core.warnings

    def with_fields(self, *, growth: Any = None, thickness: Any = None, fibres: Any = None) -> "Body":
        """The same particles with another tissue, given at the particles.

        Args:
            growth: (n,) regional growth, a factor of alpha_t, not negative [-]; None: as it is.
            thickness: (n,) thickness of the cortex at t = 0, positive [mm]; None: as it is.
            fibres: (n, 3) directions of the fibres of white matter in the reference frame, in place of what
                fibres.direction says; their length and sign do not matter, 0 is no fibre [-]; None: as they are.

        Raises:
            InputError: an array has the wrong shape or numbers, the case has no fibres, or the body is of tets.
        """
        given = {"growth": growth, "thickness": thickness}
        fields = {name: _arrays.numbers(values, len(self), name) for name, values in given.items() if values is not None}
        if fibres is not None:
            fields["fibres"] = _arrays.points(fibres, "fibres")
        core = self._core.with_fields(fields.get("growth"), fields.get("thickness"), fields.get("fibres"))
        made = Body(core, self._case, {**self._fields, **fields})
        warn(made.warnings)
        return made

    def __len__(self) -> int:
        """Number of particles or nodes."""
        return len(self._core.positions)

    def __reduce__(self) -> Any:
        """As its case: it is prepared again, to the same bits on the same kind of processor."""
        return _prepared_again, (self._case, self._fields)

    def __repr__(self) -> str:
        return (f"<corticle.Body of {self.source}: {len(self)} particles, {len(self.surface_particles)} of them on the "
                f"surface, spacing {self.spacing:.4g} mm>")


def _prepared_again(case: Case, fields: Mapping[str, FloatArray]) -> Body:
    body = Body(_corticle.prepare(case._resolved()), case)
    return body.with_fields(**fields) if fields else body


def _case_of(source: Any, triangles: Any, labels: Optional[Sequence[int]], maps: Mapping[str, Any], named: Mapping[str, Any]) -> Case:
    given_maps = {key: values for key, values in maps.items() if values is not None}
    if isinstance(source, Case):
        if labels is not None or triangles is not None or given_maps:
            raise InputError("prepare: got a case and arrays or labels beside it, expected them in the case: Case.surface, Case.brain")
        return source.copy().update(named)
    if triangles is not None or hasattr(source, "triangles"):
        if labels is not None:
            raise InputError("prepare: got a surface and labels, expected labels with an image only")
        return Case.surface(source, triangles, **given_maps, **named)
    if given_maps:
        raise InputError(f"prepare: got {', '.join(given_maps)} without a surface, expected maps at the vertices of a surface")
    if labels is None and isinstance(source, (str, os.PathLike)):
        return Case.file(source, **named)
    return Case.brain(source, labels, **named)


def _fibres_at_particles(body: Body, source: Any, fibres: Any) -> FloatArray:
    """Directions at the vertices of a surface, of the closest vertex of each particle."""
    vertices = _arrays.points(getattr(source, "vertices", source))
    directions = _arrays.points(fibres, "fibres")
    if len(directions) != len(vertices):
        raise InputError(f"fibres: got {len(directions)} directions, expected one for each of {len(vertices)} vertices")
    centre = vertices.mean(axis=0)  # from where differences of squares keep their digits
    vertices, places = vertices - centre, body.positions - centre
    squares = 0.5 * np.einsum("ij,ij->i", vertices, vertices)
    at_once = max(1, 10_000_000 // len(vertices))
    closest = [np.argmin(squares - part @ vertices.T, axis=1) for part in np.array_split(places, len(places) // at_once + 1)]
    return directions[np.concatenate(closest)]


def prepare(source: Any, triangles: Any = None, *, labels: Optional[Sequence[int]] = None, growth: Any = None,
            thickness: Any = None, still: Any = None, regions: Any = None, region_growth: Optional[Mapping[int, float]] = None,
            fibres: Any = None, **keys: Any) -> Body:
    """Makes the body of a case: surface, particles, tissue. Takes seconds to minutes; warnings are CorticleWarnings.

    `prepare(case)` is `corticle prepare`. In place of a case: `prepare(vertices, triangles, growth=...)` is that of
    `Case.surface`, `prepare(image, labels=[...])` that of `Case.brain`, `prepare(path)` that of `Case.file`.

    Args:
        source: a case; (n, 3) vertices [mm] of a closed surface; a Surface; an image of nibabel; or a path.
        triangles: (m, 3) indices of the vertices.
        labels: those of an image that are the body.
        growth, thickness, still, regions, region_growth: maps at the vertices, see `Case.surface`.
        fibres: (n, 3) directions at the vertices of a surface: particles have those of the closest vertex. The case needs a
            fibres.direction, in place of which they are taken; at particles see `Body.with_fields`.
        keys: of the case, as `Case.update` takes them.

    Raises:
        InputError: something in the case, an array or a file is wrong.
    """
    if fibres is not None and triangles is None and not hasattr(source, "triangles"):
        raise InputError("fibres: got them without a surface, expected directions at the vertices of a surface")
    maps = {"growth": growth, "thickness": thickness, "still": still, "regions": regions, "region_growth": region_growth}
    case = _case_of(source, triangles, labels, maps, keys)
    body = Body(_corticle.prepare(case._resolved()), case)
    warn(body.warnings)
    return body if fibres is None else body.with_fields(fibres=_fibres_at_particles(body, source, fibres))
