# SPDX-License-Identifier: GPL-3.0-or-later
"""What nobody should do: an exception each, never a crash, and nothing leaks."""

import gc
import multiprocessing
import os
import subprocess
import sys
import threading

import numpy as np
import pytest
from conftest import small_case

import corticle


def resident_mb():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def test_objects_of_the_wrong_type(body, simulation):
    for wrong in (None, 3, "body", body):
        with pytest.raises((TypeError, ValueError)):
            corticle.Simulation(wrong if wrong is not body else body, wrong)
    for wrong in ("x", [], float("nan"), float("inf"), object()):
        with pytest.raises(corticle.InputError):
            simulation.step(until=wrong)
        with pytest.raises(corticle.InputError):
            simulation.run(until=wrong)
        with pytest.raises(corticle.InputError):
            simulation.run(every=wrong)
    for wrong in (0.0, -1.0, 1e-300):
        with pytest.raises(corticle.InputError):
            simulation.run(every=wrong)
    with pytest.raises(corticle.InputError):
        simulation.run(on_output=3)
    with pytest.raises(corticle.InputError):
        simulation.add_force(3)
    with pytest.raises(corticle.InputError):
        simulation.run(until=0.01, week=30.0)
    with pytest.raises(corticle.InputError, match="clock"):
        simulation.run(week=30.0)
    with pytest.raises(corticle.InputError):
        corticle.run(None, "x")
    with pytest.raises(corticle.InputError):
        corticle.run(small_case(), None)
    simulation.step()


def test_objects_that_were_never_made():
    bare = corticle.Simulation.__new__(corticle.Simulation)
    with pytest.raises(AttributeError):
        bare.step()
    with pytest.raises(AttributeError):
        len(corticle.Body.__new__(corticle.Body))


def test_many_simulations_leak_nothing(body):
    def cycle(count):
        for _ in range(count):
            simulation = corticle.Simulation(body)
            simulation.positions
        gc.collect()

    cycle(50)
    before = resident_mb()
    cycle(300)
    assert resident_mb() - before < 20.0  # one simulation takes about 1 MB


def test_many_cases_and_errors_leak_nothing():
    def cycle(count):
        for _ in range(count):
            case = corticle.Case.sphere(particles=2000)
            case.to_toml()
            with pytest.raises(corticle.InputError):
                case.geometry.particles = 3
        gc.collect()

    cycle(50)
    before = resident_mb()
    cycle(500)
    assert resident_mb() - before < 20.0


def test_many_threads_on_one_simulation(body):
    simulation = corticle.Simulation(body)
    unexpected = []

    def hammer():
        for _ in range(10):
            for use in (simulation.step, lambda: simulation.positions, lambda: simulation.J, lambda: simulation.stress,
                        lambda: simulation.surface, lambda: simulation.run(every=0.005, on_output=lambda s: s.positions)):
                try:
                    use()
                except (RuntimeError, corticle.InputError):
                    pass
                except BaseException as error:  # noqa: BLE001
                    unexpected.append(error)

    threads = [threading.Thread(target=hammer) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not unexpected


def _work_in_child(queue):
    try:
        corticle.Simulation(corticle.prepare(small_case()))
        queue.put("worked")
    except RuntimeError as error:
        queue.put(str(error))


def test_a_forked_child_is_refused_and_a_spawned_one_works(body):
    answers = {}
    for method in ("fork", "spawn"):
        context = multiprocessing.get_context(method)
        queue = context.Queue()
        child = context.Process(target=_work_in_child, args=(queue,))
        child.start()
        answers[method] = queue.get(timeout=120)
        child.join(timeout=60)
        assert child.exitcode == 0
    assert "spawn" in answers["fork"]
    assert answers["spawn"] == "worked"


def assert_ends_well(script):
    assert subprocess.run([sys.executable, "-W", "ignore", "-c", script], timeout=120, check=False).returncode == 0


def test_fork_before_any_work_is_fine():
    script = ("import os, corticle\n"
              "child = os.fork()\n"
              "case = corticle.Case.sphere({'geometry.particles': 600, 'time.end': 0.001})\n"
              "corticle.Simulation(corticle.prepare(case)).step()\n"
              "if child: assert os.waitpid(child, 0)[1] == 0\n")
    assert_ends_well(script)


def test_the_end_of_the_interpreter_in_the_midst_of_a_run():
    script = ("import threading, corticle\n"
              "case = corticle.Case.sphere({'geometry.particles': 1000})\n"
              "simulation = corticle.Simulation(corticle.prepare(case))\n"
              "threading.Thread(target=simulation.run, daemon=True).start()\n"
              "threading.Event().wait(0.3)\n")
    assert_ends_well(script)


@pytest.mark.parametrize("is_loaded", [False, True], ids=["first", "loaded"])
def test_sub_interpreters_are_refused(is_loaded):
    """In threads of their own; the main interpreter goes on."""
    pytest.importorskip("_xxsubinterpreters")
    script = ("import threading, _xxsubinterpreters as interpreters\n"
              + ("import corticle\n" if is_loaded else "")
              + "said = []\n"
              "def other():\n"
              "    one = interpreters.create()\n"
              "    try:\n"
              "        interpreters.run_string(one, 'import corticle')\n"
              "    except interpreters.RunFailedError as error:\n"
              "        said.append(str(error))\n"
              "    interpreters.destroy(one)\n"
              "threads = [threading.Thread(target=other) for _ in range(2)]\n"
              "for thread in threads: thread.start()\n"
              "for thread in threads: thread.join()\n"
              "assert len(said) == 2 and all('main interpreter' in text for text in said), said\n"
              "import corticle\n"
              "case = corticle.Case.sphere({'geometry.particles': 600, 'time.end': 0.001})\n"
              "corticle.Simulation(corticle.prepare(case)).step()\n")
    assert_ends_well(script)


FORMS = {"fortran": np.asfortranarray, "float32": lambda a: a.astype(np.float32), "big_endian": lambda a: a.astype(">f8"),
         "negative_strides": lambda a: a[::-1].copy()[::-1], "gaps": lambda a: np.repeat(a, 2, axis=0)[::2], "list": lambda a: a.tolist(),
         "half": lambda a: a.astype(np.float16), "integers": lambda a: a.astype(np.int64)}


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS.keys())
def test_arrays_of_any_form(body, form):
    """Numbers that all these types hold exactly."""
    growth = np.round(body.depth)
    forces = np.round(body.positions)
    expected = body.with_fields(growth=growth).growth
    assert (body.with_fields(growth=form(growth)).growth == expected).all()
    assert (body.with_fields(thickness=form(growth % 2 + 1.0)).thickness == growth % 2 + 1.0).all()
    with_form, plain = corticle.Simulation(body), corticle.Simulation(body)
    with_form.add_force(lambda t, x, v: form(forces))
    plain.add_force(lambda t, x, v: forces)
    for _ in range(3):
        with_form.step()
        plain.step()
    assert (with_form.positions == plain.positions).all()


@pytest.mark.parametrize("wrong", [np.empty(0), np.empty((0, 3)), np.float64(1.0), np.array(None), np.array(["a"]), np.ones(3),
                                   np.full(1000, np.nan), np.full(1000, np.inf), -np.ones(1000), np.ones((1000, 1)), np.ones(1001),
                                   np.ones(1000, dtype=complex), np.ones(1000, dtype=bool), np.ones(1000, dtype="M8[s]"), object(), "x"],
                         ids=str)
def test_wrong_fields_are_refused(body, wrong):
    for name in ("growth", "thickness"):
        with pytest.raises(corticle.InputError, match=name):
            body.with_fields(**{name: wrong})


def test_cycles_leave_no_objects(body):
    def cycle(count):
        for _ in range(count):
            simulation = corticle.Simulation(body)
            simulation.add_force(lambda t, x, v, s=simulation: 0.0 * x)
            simulation.run(until=1e-4, on_output=lambda s: s.positions)
        gc.collect()

    cycle(5)
    before = len(gc.get_objects())
    cycle(50)
    assert len(gc.get_objects()) - before < 25


def test_deep_recursion_in_a_callback(simulation):
    def deep(s):
        deep(s)

    with pytest.raises(RecursionError):
        simulation.run(on_output=deep)
    simulation.step()


def test_import_leaves_the_environment_alone():
    script = ("import os\nbefore = dict(os.environ)\nimport signal\nhandler = signal.getsignal(signal.SIGINT)\n"
              "import corticle, logging\nassert dict(os.environ) == before\nassert signal.getsignal(signal.SIGINT) is handler\n"
              "assert not logging.root.handlers\n")
    assert subprocess.run([sys.executable, "-c", script], timeout=60, check=False).returncode == 0
