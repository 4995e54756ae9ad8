# SPDX-License-Identifier: GPL-3.0-or-later
"""Run folders: to make them and to read them."""

import base64
import html
import json
import os
import warnings
from collections.abc import Sequence as AbstractSequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Union

import numpy as np

from corticle import _child, _corticle
from corticle._arrays import FloatArray
from corticle._core import path_text, warn
from corticle._progress import Progress
from corticle.cases import Case, PathLike
from corticle.errors import CorticleWarning, InputError, RunError
from corticle.surfaces import Surface


@dataclass(frozen=True)
class RunOutput:
    """What `corticle.run` shows at an output time.

    Attributes:
        number: of the output, from 0 at the start of the run.
        t: growth time [-].
        week: gestational age [weeks]; None without a clock.
        steps: number of steps taken.
        surface: in mm at the week, without arrays; those are in the files.
    """

    number: int
    t: float
    week: Optional[float]
    steps: int
    surface: Surface


@dataclass(frozen=True)
class Particles:
    """Particles of a frame.

    Attributes:
        positions: (n, 3) [mm at the week].
        arrays: by name, (n,), (n, 3) or (n, 3, 3): J, theta, growth, F, stress, displacement, depth, normal, volume, id.
    """

    positions: FloatArray
    arrays: Dict[str, Any]

    def __getitem__(self, name: str) -> Any:
        return self.arrays[name]

    def __len__(self) -> int:
        return len(self.positions)


class Frame:
    """One output time of a run. Its files are read when they are asked for, every time anew."""

    def __init__(self, t: float, week: Optional[float], surface_file: str, particle_file: str) -> None:
        self.t = t
        self.week = week
        self._surface_file = surface_file
        self._particle_file = particle_file

    @property
    def surface(self) -> Surface:
        """The folded surface [mm at the week] with all arrays of its file."""
        vertices, triangles, arrays = _corticle.read_surface_file(self._surface_file)
        return Surface(vertices, triangles, arrays, t=self.t, week=self.week)

    @property
    def particles(self) -> Particles:
        """The particles with all arrays of their file."""
        positions, arrays = _corticle.read_particle_file(self._particle_file)
        square = {name: values.reshape(-1, 3, 3) for name, values in arrays.items() if values.ndim == 2 and values.shape[1] == 9}
        return Particles(positions, {**arrays, **square})

    def __repr__(self) -> str:
        week = "" if self.week is None else f", week {self.week:.4g}"
        return f"<corticle.Frame at t = {self.t:.4g}{week}>"


class Frames(AbstractSequence):  # type: ignore[type-arg]
    """The output times of a run, in order."""

    def __init__(self, frames: Sequence[Frame]) -> None:
        self._frames = list(frames)

    def __getitem__(self, index: Any) -> Any:
        return self._frames[index]

    def __len__(self) -> int:
        return len(self._frames)

    def nearest(self, t: Optional[float] = None, *, week: Optional[float] = None) -> Frame:
        """The frame nearest to a growth time or a week.

        Raises:
            InputError: neither or both are given, or the run has no weeks.
        """
        if (t is None) == (week is None):
            raise InputError("nearest: expected t or week, and one of them only")
        if t is not None:
            return self._frames[int(np.argmin([abs(frame.t - t) for frame in self._frames]))]
        if any(frame.week is None for frame in self._frames):
            raise InputError("nearest: the run has no weeks (time.clock); expected t, a growth time")
        return min(self._frames, key=lambda frame: abs(frame.week - week))  # type: ignore[operator]


class Run:
    """A run folder, as `corticle run` or `corticle.run` left it. `refresh()` reads it again while a run goes on.

    Raises:
        InputError: the folder is not that of a run, or has no output times.
    """

    def __init__(self, folder: PathLike) -> None:
        self._folder = Path(path_text(folder, "folder"))
        self.refresh()

    def refresh(self) -> "Run":
        """Reads the list of output times and the measures again."""
        contents = _corticle.read_run(str(self._folder))
        self._columns: Dict[str, FloatArray] = contents["measures"]
        self._units: Dict[str, str] = contents["units"]
        self._frames = Frames([Frame(t, self._week_at(t), *files) for t, *files in contents["frames"]])
        return self

    @property
    def folder(self) -> Path:
        return self._folder

    @property
    def case(self) -> Case:
        """The case of the run, with every key."""
        return Case.load(self._folder / "case.toml")

    @property
    def summary(self) -> Dict[str, Any]:
        """summary.json: status, sizes, times, final measures; empty while the run goes on for the first time."""
        path = self._folder / "summary.json"
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}

    @property
    def status(self) -> str:
        """"completed", "interrupted", "failed", or "running" where there is no summary yet."""
        return str(self.summary.get("status", "running"))

    @property
    def columns(self) -> Dict[str, FloatArray]:
        """The measures by name, one number for each output time."""
        return dict(self._columns)

    @property
    def units(self) -> Dict[str, str]:
        """Units of the measures by name; "-": a pure number."""
        return dict(self._units)

    @property
    def measures(self) -> Any:
        """The measures as a pandas DataFrame, one row for each output time; `columns` where pandas is not installed."""
        try:
            import pandas
        except ImportError:
            return self.columns
        return pandas.DataFrame({name: np.array(values) for name, values in self._columns.items()})

    @property
    def frames(self) -> Frames:
        """The output times, in order; files are read when a frame is asked for its surface or particles."""
        return self._frames

    @property
    def pictures(self) -> List[Path]:
        """The pictures of the run."""
        return sorted((self._folder / "pictures").glob("*.png"))

    def __repr__(self) -> str:
        return f"<corticle.Run {self._folder}: {self.status}, {len(self._frames)} output times>"

    def _repr_html_(self) -> str:
        """The report of the run; without one its picture, and the measures of its end."""
        report = self._folder / "report.html"
        if report.exists():
            page = html.escape(report.read_text(encoding="utf-8", errors="replace"), quote=True)
            return f'<iframe srcdoc="{page}" width="100%" height="600" frameborder="0"></iframe>'
        rows = "".join(f"<tr><td>{html.escape(name)}</td><td>{values[-1]:.6g}</td><td>{html.escape(self._units[name])}</td></tr>"
                       for name, values in self._columns.items())
        return f"<p>{html.escape(repr(self)[1:-1])}</p>{self._picture()}<table>{rows}</table>"

    def _picture(self) -> str:
        surfaces = [path for path in self.pictures if path.name.startswith("surface_J")] or self.pictures
        if not surfaces:
            png = self._frames[-1].surface._repr_png_()
        else:
            png = surfaces[-1].read_bytes()
        return "" if png is None else f'<img width="480" src="data:image/png;base64,{base64.b64encode(png).decode()}">'

    def _week_at(self, t: float) -> Optional[float]:
        weeks = self._columns.get("week")
        if weeks is None:
            return None
        week = float(weeks[int(np.argmin(np.abs(self._columns["t"] - t)))])
        return None if np.isnan(week) else week


def open_run(folder: PathLike) -> Run:
    """A run folder, to read: `open_run("runs/sphere").measures`. Raises InputError where it is none."""
    return Run(folder)


def render(folder: PathLike) -> None:
    """Draws the pictures of a run folder again, as `corticle render` does, in a process of its own.

    Raises:
        InputError: it is not a run folder, or a run still writes to it.
        RunError: pictures cannot be drawn, for instance because there is neither a display nor Xvfb.
    """
    _child.call("render", os.path.abspath(path_text(folder, "folder")))


def report(folder: PathLike, *, max_mb: float = 40.0) -> Path:
    """Writes the page report.html of a run, a comparison or a sweep into its folder, as `corticle report` does.

    Args:
        folder: of a run, a comparison or a sweep.
        max_mb: how large the page may be [MB]; beyond that output times, and then vertices, are left out.

    Raises:
        InputError: it is none of these.
        RunError: three.js is not installed (Debian: libjs-three), or the page cannot be written.
    """
    return Path(_corticle.report(path_text(folder, "folder"), float(max_mb)))


def _output(show: Callable[[RunOutput], Any]) -> Callable[[Dict[str, Any]], Any]:
    def made(parts: Dict[str, Any]) -> Any:
        week = None if np.isnan(parts["week"]) else parts["week"]
        surface = Surface(parts["vertices"], parts["triangles"], t=parts["t"], week=week)
        return show(RunOutput(parts["number"], parts["t"], week, parts["steps"], surface))

    return made


def _draw(folder: str, case: Any) -> None:
    if case.value("output.pictures") == "on":
        try:
            render(folder)
        except RunError as error:
            warnings.warn(f"no pictures: {error}", CorticleWarning, stacklevel=3)
    if case.value("output.report") == "on":
        try:
            report(folder)
        except RunError as error:
            warnings.warn(f"no report: {error}", CorticleWarning, stacklevel=3)


def run(case: Case, out: PathLike, *, body: Optional[PathLike] = None, resume: bool = False, overwrite: bool = False,
        pictures: bool = True, on_output: Optional[Callable[[RunOutput], Any]] = None, progress: bool = False) -> Run:
    """Runs a case into a run folder, as `corticle run` does: the same files, to the same bits.

    Warnings are CorticleWarnings. Ctrl-C, and what `on_output` raises, interrupt the run: a checkpoint is written, and
    `resume=True` goes on from it.

    Args:
        case: what to run.
        out: the run folder.
        body: a body file of `corticle prepare`, or its folder; None: the body is prepared now.
        resume: go on with the run in the folder from its checkpoint.
        overwrite: remove an earlier run in the folder first.
        pictures: False draws none and writes no report; True those of the case, after the run, pictures in a process of
            its own.
        on_output: called at output times, when the files of the output are written.
        progress: show how far it is.

    Raises:
        InputError: something in the case, a file or an argument is wrong; nothing was written.
        RunError: the run failed (with step, t and particle); the last good checkpoint is kept.
        KeyboardInterrupt: after the present step, with a checkpoint.
    """
    if not isinstance(case, Case):
        raise InputError(f"case: got an object of type {type(case).__name__}, expected a corticle.Case")
    if on_output is not None and not callable(on_output):
        raise InputError(f"on_output: got an object of type {type(on_output).__name__}, expected a function or None")
    folder = path_text(out, "out")
    body_file = "" if body is None else path_text(body, "body")
    if os.path.isdir(body_file):
        body_file = os.path.join(body_file, "body.h5")
    resolved = case._resolved()
    show = None if on_output is None else _output(on_output)
    with Progress(progress, resolved.start, resolved.end) as shown:
        _corticle.run(resolved, folder, body_file, bool(resume), bool(overwrite), lambda line: warn([line]), show, shown.tell)
    if pictures:
        _draw(folder, resolved)
    return Run(folder)


def compare(run_folder: Union[PathLike, Run], others: Union[PathLike, Run, Sequence[Union[str, Run]]], out: PathLike, *,
            overwrite: bool = False) -> Dict[str, Any]:
    """Compares a run with another run, or with real surfaces, as `corticle compare` does, in a process of its own.

    Args:
        run_folder: a run, or its folder.
        others: another run or its folder; or real surfaces or labels, "FILE@WEEK" or "FILE@t=T" each.
        out: folder of the report.
        overwrite: replace an earlier report there.

    Returns:
        What comparison.json holds.

    Raises:
        InputError: something cannot be read or compared; nothing was written.
    """
    several = [others] if isinstance(others, (str, os.PathLike, Run)) else list(others)
    names = [str(other.folder) if isinstance(other, Run) else path_text(other, "others") for other in several]
    if not names:
        raise InputError("others: got none, expected a run or surfaces FILE@WEEK")
    folder = str(run_folder.folder) if isinstance(run_folder, Run) else path_text(run_folder, "run_folder")
    _, text, _, lines = _child.call("compare", folder, names, path_text(out, "out"), bool(overwrite))
    warn(lines)
    result: Dict[str, Any] = json.loads(text)
    return result
