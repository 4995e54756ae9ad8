# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations: a body as it grows, step by step."""

import math
import tempfile
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

from corticle import _arrays, _corticle
from corticle._arrays import FloatArray
from corticle._core import path_text, warn
from corticle._progress import Progress
from corticle.bodies import Body
from corticle.cases import Case, PathLike
from corticle.errors import InputError
from corticle.growth_laws import GrowthLaw, checked
from corticle.surfaces import Surface

_SAME_TIME = 1e-9  # times of growth closer than this are the same output time, in the library too

Force = Callable[[float, FloatArray, FloatArray], Union[FloatArray, Tuple[FloatArray, float]]]


def _number(value: Any, what: str) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{what}: got {value!r}, expected a number") from None
    if not math.isfinite(number):
        raise InputError(f"{what}: got {number}, expected a finite number")
    return number


def _checked(function: Force, what: str) -> Force:
    """The function, whose forces are checked and in the form that the compiled module takes."""

    def forces(t: float, positions: FloatArray, velocities: FloatArray) -> Any:
        answer = function(t, positions, velocities)
        if isinstance(answer, tuple) and len(answer) == 2:
            return _arrays.points(answer[0], what), _number(answer[1], f"{what}, energy")
        return _arrays.points(answer, what)

    return forces


class Simulation:
    """A body as it grows. Several can share a body, and run at once in threads of their own.

    While it steps, the interpreter is free for other threads (the GIL is released), but nobody can look at or step the
    same simulation: that is a RuntimeError. Ctrl-C raises KeyboardInterrupt after the present step, and the simulation
    can go on from there; so it can after what a callback raises.

    Args:
        body: what `prepare` made.
        case: another case than the body's, with the same [geometry] and [map]; None: that of the body.

    Raises:
        InputError: the case asks for another body, or something in it is wrong.
    """

    def __init__(self, body: Body, case: Optional[Case] = None) -> None:
        if not isinstance(body, Body):
            raise InputError(f"body: got an object of type {type(body).__name__}, expected what corticle.prepare gives")
        if case is not None and not isinstance(case, Case):
            raise InputError(f"case: got an object of type {type(case).__name__}, expected a corticle.Case")
        self._body = body
        self._case = (case or body._case).copy()
        self._resolved = self._case._resolved()
        self._core = _corticle.Simulation(body._core, self._resolved)
        self._has_functions = False

    # Steps

    def step(self, until: Optional[float] = None) -> None:
        """One step, no farther than growth time `until`; None: than the end of the case.

        Raises:
            InputError: the simulation is there already.
            RunError: the step fails (with step, t and particle).
        """
        end = self._resolved.end if until is None else _number(until, "until")
        if end <= self.t:
            raise InputError(f"until: got t = {end:g}, expected more than the present t = {self.t:g}")
        self._core.step(end)

    def run(self, until: Optional[float] = None, *, week: Optional[float] = None, every: Optional[float] = None,
            on_output: Optional[Callable[["Simulation"], Any]] = None, progress: bool = False) -> "Simulation":
        """Steps to growth time `until`; returns the simulation.

        Steps end at output times; as in `corticle run`, these are a part of what makes the result what it is, bit for bit.

        Args:
            until: growth time [-]; None: the end of the case.
            week: gestational age in place of `until`, in a case with a clock [weeks].
            every: output times are so far apart in t; None: those of the case.
            on_output: called with the simulation at output times, the present one included if no step was taken. It can
                look at the simulation, but not step it. What it raises ends the run.
            progress: show how far it is.

        Raises:
            InputError: the end lies before the present time, or an argument is wrong.
            RunError: a step fails (with step, t and particle).
            KeyboardInterrupt: after the present step.
        """
        if on_output is not None and not callable(on_output):
            raise InputError(f"on_output: got an object of type {type(on_output).__name__}, expected a function or None")
        end = self._end(until, week)
        show = None if on_output is None else (lambda: on_output(self))
        with Progress(progress, self.t, end) as shown:
            self._core.run(self._times(end, every), show, shown.tell)
        return self

    def add_force(self, function: Force, name: str = "python", stable_step: Optional[float] = None) -> None:
        """Adds a force on the particles, from the present state on: a hypothesis in a few lines, at the speed of numpy.

        Args:
            function: called as `function(t, positions, velocities)` for every step that is tried, with (n, 3) arrays of
                its own [mm, mm per unit of time], which are those of the particles in their reference order. It returns
                (n, 3) forces [mu_w mm²], or these and the energy that they derive from [mu_w mm³]; without it the energy
                balance counts the work of the force as an error. What it raises ends the step.
            name: what logs and `energies` call it.
            stable_step: longest step that the force allows, in the unit of time of the simulation; None: any.

        Raises:
            InputError: an argument is wrong, or what the function returns has the wrong shape or is not finite.
        """
        if not callable(function):
            raise InputError(f"function: got an object of type {type(function).__name__}, expected a function")
        if not isinstance(name, str) or not name:
            raise InputError(f"name: got {name!r}, expected text")
        longest = math.inf if stable_step is None else _number(stable_step, "stable_step")
        if longest <= 0.0:
            raise InputError(f"stable_step: got {longest}, expected a number above 0")
        self._core.add_force(name, _checked(function, f'force "{name}"'), longest)
        self._has_functions = True

    def set_growth(self, law: GrowthLaw) -> None:
        """Growth by a law of one's own in place of that of the case, before the first step: a hypothesis about growth in a
        few lines, at the speed of numpy.

        Args:
            law: called as `law(week, fields)` for every step that is tried, with the gestational age at its end [weeks], in
                a case without a clock the growth time [-], and `Fields`, what the step starts from. It returns (n,)
                tangential growth [-], or that and (n,) growth along the normal [-], which is 1 otherwise; both relative
                to the start of the run, where they are 1. For growth at a rate r by what is there:
                `fields.growth * (1.0 + r * (week - fields.week))`. What it raises ends the step.

        Moduli, thickness and size stay those of the case. A checkpoint holds the growth, not the law: set the same one
        before `restore`.

        Raises:
            InputError: there is a law already, or steps were taken; what the law returns has the wrong shape, is not
                above 0, or is not 1 at the start.
        """
        if not callable(law):
            raise InputError(f"law: got an object of type {type(law).__name__}, expected a function")
        self._core.set_growth(checked(law, self._body))
        self._has_functions = True

    # The present state

    @property
    def body(self) -> Body:
        """What grows."""
        return self._body

    @property
    def case(self) -> Case:
        """A copy of the case."""
        return self._case.copy()

    @property
    def t(self) -> float:
        """Growth time, from 0 to 1 in most cases [-]."""
        return self._core.t

    @property
    def steps(self) -> int:
        """Number of steps taken."""
        return self._core.steps

    @property
    def week(self) -> Optional[float]:
        """Gestational age [weeks]; None in a case without a clock."""
        week: float = self._core.week
        return None if math.isnan(week) else week

    @property
    def positions(self) -> FloatArray:
        """(n, 3) positions of the particles in the coordinates of the run [mm].

        A read-only view without a copy. It shows the state at which it was asked for, and goes on to show that: when the
        simulation steps while the array is still there, the simulation leaves it its memory.
        """
        return self._core.positions()

    @property
    def velocities(self) -> FloatArray:
        """(n, 3) velocities of the particles [mm per unit of time]; a copy, as all that follows."""
        return self._core.velocities()

    @property
    def F(self) -> FloatArray:
        """(n, 3, 3) deformation gradients of the particles, rows before columns [-]."""
        return self._core.deformation_gradients()

    @property
    def J(self) -> FloatArray:
        """(n,) volume ratios of the particles, det F [-]."""
        return self._core.volume_ratios()

    @property
    def stress(self) -> FloatArray:
        """(n, 3, 3) Cauchy stress at the particles [mu_w]."""
        return self._core.stress()

    @property
    def theta(self) -> FloatArray:
        """(n,) share of cortex at the particles: 1 cortex, 0 white matter [-]."""
        return self._core.theta()

    @property
    def growth(self) -> FloatArray:
        """(n,) tangential growth g at the particles [-]."""
        return self._core.growth()

    @property
    def radial_growth(self) -> FloatArray:
        """(n,) growth along the normal at the particles [-]."""
        return self._core.radial_growth()

    @property
    def surface(self) -> Surface:
        """The folded surface, in mm at its week as in the files of a run, with arrays J, theta and growth."""
        parts = self._core.surface()
        week = None if math.isnan(parts["week"]) else parts["week"]
        return Surface(parts["vertices"], parts["triangles"], parts["arrays"], t=parts["t"], week=week)

    @property
    def energies(self) -> Dict[str, float]:
        """What is stored, by kind, the kinetic energy included [mu_w mm³]."""
        return self._core.energies()

    def measures(self) -> Dict[str, float]:
        """The measures of the present state, as in a row of measures.csv; ratios are to the body before it grew.

        What is wrong with the state is a CorticleWarning, as `corticle run` warns of it.
        """
        row, lines = self._core.measures()
        warn(lines)
        return row

    # Files

    def save(self, path: PathLike) -> None:
        """Writes a checkpoint, whole or not at all: all that the simulation needs, besides its body, to go on to the
        same bits. Forces of `add_force` are not in it."""
        self._core.save(path_text(path))

    def restore(self, path: PathLike) -> "Simulation":
        """Goes on from a checkpoint of a simulation of the same body; returns the simulation.

        Raises:
            InputError: the file is damaged, or holds another body, or growth by a law (`set_growth`) that the simulation does
                not have.
        """
        self._core.restore(path_text(path))
        return self

    def __getstate__(self) -> Mapping[str, Any]:
        if self._has_functions:
            raise InputError("a simulation with forces or a growth law of its own cannot be pickled: functions stay where they are")
        with tempfile.TemporaryDirectory(prefix="corticle-") as folder:
            path = Path(folder) / "checkpoint.h5"
            self.save(path)
            return {"body": self._body, "case": self._case, "checkpoint": path.read_bytes()}

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        Simulation.__init__(self, state["body"], state["case"])
        with tempfile.TemporaryDirectory(prefix="corticle-") as folder:
            path = Path(folder) / "checkpoint.h5"
            path.write_bytes(state["checkpoint"])
            self.restore(path)

    def __repr__(self) -> str:
        return f"<corticle.Simulation at t = {self.t:.6g}, step {self.steps}: {len(self._body)} particles>"

    def _end(self, until: Optional[float], week: Optional[float]) -> float:
        if until is not None and week is not None:
            raise InputError("run: got until and week, expected one of them")
        end: float = self._resolved.end if until is None else _number(until, "until")
        if week is not None:
            at_week = self._resolved.growth_time(_number(week, "week"))
            if at_week is None:
                raise InputError("week: the case has no clock (time.clock); expected until, a growth time")
            end = at_week
        if end < self.t - _SAME_TIME:
            raise InputError(f"until: got t = {end:g}, expected at least the present t = {self.t:g}")
        return end

    def _times(self, end: float, every: Optional[float]) -> List[float]:
        """Output times from the present one on, or after it if steps were taken; the end is one."""
        if every is None:
            times = self._resolved.output_times()
        else:
            apart = _number(every, "every")
            if apart <= 0.0 or (end - self.t) / apart > 1e6:
                raise InputError(f"every: got {apart}, expected a number above 0, for at most a million outputs")
            times = [self.t + k * apart for k in range(int((end - self.t) / apart) + 1)]
        first = self.t - _SAME_TIME if self.steps == 0 else self.t + _SAME_TIME
        return [t for t in times if first <= t < end - _SAME_TIME] + ([end] if end >= first else [])
