# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the compiled module, whose OpenMP reads its environment only then.

Threads that wait for each other should sleep after a short spin: on a machine that others use too, spinning makes runs
ten times slower. OpenMP is told so while it is loaded, unless the environment says something else; afterwards the
environment is as it was.
"""

import os

_SPIN = "GOMP_SPINCOUNT"
_is_free = not {_SPIN, "OMP_WAIT_POLICY"} & os.environ.keys()
if _is_free:
    os.environ[_SPIN] = "20000"
try:
    from corticle import _corticle

    _corticle.require_main_interpreter()  # loaded by another one the module is not initialised again
finally:
    if _is_free:
        del os.environ[_SPIN]
