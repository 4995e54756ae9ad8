# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong."""

from typing import Optional


class InputError(ValueError):
    """Bad usage or input. The message is one line: what, where, got, expected."""


class RunError(RuntimeError):
    """A run that failed. The message holds the diagnosis.

    Attributes:
        step: number of the step that was tried, or None where no step failed (a full disk, for instance).
        t: growth time there [-], or None.
        particle: the particle or node that is invalid, or None where it is not one of them.
    """

    def __init__(self, message: str, step: Optional[int] = None, t: Optional[float] = None,
                 particle: Optional[int] = None) -> None:
        super().__init__(message, step, t, particle)
        self.step = step
        self.t = t
        self.particle = particle

    def __str__(self) -> str:
        return str(self.args[0])


class CorticleWarning(UserWarning):
    """What is allowed but probably not meant, or a sign that the folds are not those of soft tissue in equilibrium."""
