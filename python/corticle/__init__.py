# SPDX-License-Identifier: GPL-3.0-or-later
"""Corticle: meshless simulation of how a growing cortex folds.

    import corticle

    case = corticle.Case.sphere(particles=8000)
    simulation = corticle.Simulation(corticle.prepare(case))
    simulation.run(until=0.5)
    print(simulation.measures()["gi_hull"])

Lengths are in mm, growth time t is a pure number from 0 to 1, stresses are in units of the shear modulus of white
matter, mu_w. What is wrong with an argument or a file is an `InputError`, a run that fails a `RunError`, what is allowed
but probably not meant a `CorticleWarning`.
"""

from corticle import _loading  # noqa: F401  (before anything that loads the compiled module)
from corticle._core import __version__, parameters, set_threads, threads
from corticle.bodies import Body, prepare
from corticle.cases import Case
from corticle.errors import CorticleWarning, InputError, RunError
from corticle.growth_laws import Fields
from corticle.runs import Frame, Particles, Run, RunOutput, compare, open_run, render, report, run
from corticle.simulations import Simulation
from corticle.surfaces import Surface, measure, phantom, read_surface

__all__ = ["Body", "Case", "CorticleWarning", "Fields", "Frame", "InputError", "Particles", "Run", "RunError", "RunOutput", "Simulation",
           "Surface", "__version__", "compare", "measure", "open_run", "parameters", "phantom", "prepare", "read_surface",
           "render", "report", "run", "set_threads", "threads"]
