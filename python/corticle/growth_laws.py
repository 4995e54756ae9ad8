# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth laws from Python: what they see, and how their answers are checked."""

import math
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np

from corticle import _arrays
from corticle._arrays import FloatArray
from corticle.bodies import Body
from corticle.errors import InputError


class Fields:
    """What a growth law sees: the particles as the last step left them. Arrays are copies in the order of the particles,
    made when they are asked for; when the law has answered there is nothing more to see, and asking is a RuntimeError.
    """

    def __init__(self, core: Any, body: Body) -> None:
        self._core = core
        self._body = body

    @property
    def body(self) -> Body:
        """The body before it grew: reference positions, depth, normals, volumes."""
        return self._body

    @property
    def t(self) -> float:
        """Growth time that the last step ended at [-]."""
        return self._core.t

    @property
    def week(self) -> Optional[float]:
        """Gestational age that the last step ended at [weeks]; None in a case without a clock."""
        week: float = self._core.week
        return None if math.isnan(week) else week

    @property
    def depth(self) -> FloatArray:
        """(n,) reference distance to the surface [mm]."""
        return self._body.depth

    @property
    def positions(self) -> FloatArray:
        """(n, 3) positions [mm]."""
        return self._core.positions

    @property
    def velocities(self) -> FloatArray:
        """(n, 3) velocities [mm per unit of time]."""
        return self._core.velocities

    @property
    def F(self) -> FloatArray:
        """(n, 3, 3) deformation gradients [-]."""
        return self._core.F

    @property
    def J(self) -> FloatArray:
        """(n,) volume ratios, det F [-]."""
        return self._core.J

    @property
    def stress(self) -> FloatArray:
        """(n, 3, 3) Cauchy stress [mu_w]."""
        return self._core.stress

    @property
    def theta(self) -> FloatArray:
        """(n,) share of cortex: 1 cortex, 0 white matter [-]."""
        return self._core.theta

    @property
    def growth(self) -> FloatArray:
        """(n,) tangential growth that the law has said for the last step [-]."""
        return self._core.growth

    @property
    def radial_growth(self) -> FloatArray:
        """(n,) growth along the normal that the law has said for the last step [-]."""
        return self._core.radial_growth

    def __repr__(self) -> str:
        return f"<corticle.Fields of {len(self._body)} particles>"


GrowthLaw = Callable[[float, Fields], Union[FloatArray, Tuple[FloatArray, FloatArray]]]


def checked(law: GrowthLaw, body: Body) -> Callable[[float, Any], Tuple[FloatArray, FloatArray]]:
    """The law, whose growth is checked and in the form that the compiled module takes."""
    count = len(body)

    def growth(week: float, core: Any) -> Tuple[FloatArray, FloatArray]:
        answer = law(week, Fields(core, body))
        if isinstance(answer, tuple):
            if len(answer) != 2:
                raise InputError(f"growth law: got {len(answer)} arrays, expected tangential growth, or that and growth along the normal")
            return (_arrays.numbers(answer[0], count, "growth law"),
                    _arrays.numbers(answer[1], count, "growth law, along the normal"))
        return _arrays.numbers(answer, count, "growth law"), np.ones(count)

    return growth
