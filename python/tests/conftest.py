# SPDX-License-Identifier: GPL-3.0-or-later
"""Small bodies for all tests."""

import os
import signal
from pathlib import Path

import pytest

import corticle

SOURCE = Path(__file__).resolve().parents[2]

corticle.set_threads(1)  # bodies of tests are small


def small_case(**keys):
    return corticle.Case.sphere({"geometry.particles": 1000, "time.end": 0.1, "output.count": 2, "output.pictures": "off", **keys})


@pytest.fixture(scope="session", autouse=True)
def ctrl_c():
    """A shell starts what runs in its background with interrupts ignored: the tests of Ctrl-C are to see them."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def body():
    return corticle.prepare(small_case())


@pytest.fixture()
def simulation(body):
    return corticle.Simulation(body)


@pytest.fixture(scope="session")
def command():
    """The command of the same build."""
    path = Path(os.environ.get("CORTICLE_COMMAND", SOURCE / "build/release/bin/corticle"))
    if not path.exists():
        pytest.skip(f"no command at {path}: make command, or CORTICLE_COMMAND=PATH")
    return str(path.resolve())


@pytest.fixture(scope="session")
def source():
    return SOURCE
