# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies and simulations: arrays, steps, callbacks, checkpoints."""

import gc
import pickle
import signal
import threading
import time
import weakref

import numpy as np
import pytest
from conftest import small_case

import corticle


def test_arrays_of_a_body_are_views_and_read_only(body):
    count = len(body)
    assert body.positions.shape == body.normals.shape == (count, 3)
    assert body.volumes.shape == body.depth.shape == body.growth.shape == (count,)
    assert np.allclose(np.linalg.norm(body.normals, axis=1), 1.0)
    assert body.volumes.sum() == pytest.approx(4.0 / 3.0 * np.pi * body.case.geometry.radius_mm**3, rel=0.02)
    assert body.positions.__array_interface__["data"] == body.positions.__array_interface__["data"]
    assert (body.positions[body.surface_particles] == body.surface.vertices).all()
    assert body.thickness is None
    with pytest.raises(ValueError, match="read-only"):
        body.positions[0, 0] = 0.0


def test_arrays_outlive_what_they_show():
    simulation = corticle.Simulation(corticle.prepare(small_case()))
    reference, positions = simulation.body.positions, simulation.positions
    kept = reference.copy(), positions.copy()
    del simulation
    gc.collect()
    assert (reference == kept[0]).all()
    assert (positions == kept[1]).all()


def test_positions_are_a_view_that_keeps_what_it_shows(simulation):
    first = simulation.positions
    assert first.base is not None and not first.flags.owndata and not first.flags.writeable
    assert simulation.positions.__array_interface__["data"] == first.__array_interface__["data"]
    before = first.copy()
    for _ in range(3):
        simulation.step()
    assert (first == before).all()
    assert (simulation.positions != before).any()
    assert simulation.positions.__array_interface__["data"] != first.__array_interface__["data"]


def test_views_do_not_change_the_result(body):
    plain, watched = corticle.Simulation(body), corticle.Simulation(body)
    views = []
    for _ in range(20):
        plain.step()
        watched.step()
        views.append(watched.positions)
    assert (plain.positions == watched.positions).all()
    assert len({view.__array_interface__["data"] for view in views}) == 20


def test_the_state(simulation):
    for _ in range(5):
        simulation.step()
    count = len(simulation.body)
    assert simulation.steps == 5 and 0.0 < simulation.t < 0.1 and simulation.week is None
    assert simulation.velocities.shape == (count, 3)
    assert simulation.F.shape == simulation.stress.shape == (count, 3, 3)
    assert np.allclose(np.linalg.det(simulation.F), simulation.J, rtol=1e-12)
    assert np.allclose(simulation.stress, np.swapaxes(simulation.stress, 1, 2), atol=1e-12)
    assert ((simulation.theta >= 0.0) & (simulation.theta <= 1.0)).all()
    assert (simulation.growth >= 1.0).all()
    surface = simulation.surface
    assert set(surface.arrays) == {"J", "theta", "growth"} and surface.t == simulation.t
    assert {"tissue", "kinetic"} & set(simulation.energies) and all(np.isfinite(list(simulation.energies.values())))
    measures = simulation.measures()
    assert measures["t"] == simulation.t and measures["steps"] == 5.0
    assert measures["area_mm2"] == pytest.approx(surface.measures()["area_mm2"])


def test_run_ends_where_it_should_and_shows_outputs(simulation):
    seen = []
    assert simulation.run(until=0.01, every=0.004, on_output=lambda s: seen.append(s.t)) is simulation
    assert simulation.t == 0.01
    assert np.allclose(seen, [0.0, 0.004, 0.008, 0.01])
    simulation.run(on_output=lambda s: seen.append(s.t))
    assert np.allclose(seen[4:], [0.05, 0.1])
    with pytest.raises(corticle.InputError, match="until"):
        simulation.run(until=0.01)
    with pytest.raises(corticle.InputError, match="until"):
        simulation.step()


def test_run_is_the_same_as_steps_to_the_same_times(body):
    by_run, by_steps = corticle.Simulation(body), corticle.Simulation(body)
    by_run.run(until=0.01)
    while by_steps.t < 0.01:
        by_steps.step(until=0.01)
    assert (by_run.positions == by_steps.positions).all()


def test_a_callback_can_look_but_not_step(simulation):
    def look(s):
        assert s.measures()["t"] == s.t
        assert len(s.positions) == len(s.J)
        with pytest.raises(RuntimeError, match="in the midst of run"):
            s.step()
        with pytest.raises(RuntimeError, match="in the midst of run"):
            s.run(until=0.02)

    simulation.run(until=0.01, every=0.01, on_output=look)
    simulation.step()


def test_what_a_callback_raises_ends_the_run_and_nothing_else(body):
    class Stop(Exception):
        pass

    def stop(s):
        if s.t > 0.0:
            raise Stop

    stopped, plain = corticle.Simulation(body), corticle.Simulation(body)
    with pytest.raises(Stop):
        stopped.run(every=0.05, on_output=stop)
    assert stopped.t == pytest.approx(0.05)
    stopped.run(every=0.05)
    plain.run(every=0.05)
    assert (stopped.positions == plain.positions).all()


def test_ctrl_c_leaves_a_usable_simulation(body):
    handler = signal.getsignal(signal.SIGINT)
    simulation, plain = corticle.Simulation(body), corticle.Simulation(body)
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100000):
            simulation = corticle.Simulation(body)
            simulation.run()
    timer.join()
    assert signal.getsignal(signal.SIGINT) is handler
    simulation.run()
    plain.run()
    assert (simulation.positions == plain.positions).all()


def test_two_simulations_at_once(body):
    alone = corticle.Simulation(body).run()
    both = [corticle.Simulation(body) for _ in range(2)]
    threads = [threading.Thread(target=simulation.run) for simulation in both]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for simulation in both:
        assert (simulation.positions == alone.positions).all()


def test_one_simulation_in_two_threads_is_refused(simulation):
    refused = []

    def disturb():
        while simulation.t < 0.1:
            for look in (simulation.step, lambda: simulation.positions, lambda: simulation.J):
                try:
                    look()
                except RuntimeError as error:
                    refused.append(str(error))
                except corticle.InputError:
                    pass
            time.sleep(0.001)

    thread = threading.Thread(target=disturb)
    thread.start()
    while simulation.t < 0.1:
        try:
            simulation.run()
        except RuntimeError as error:
            refused.append(str(error))
    thread.join()
    assert all("stepping" in text for text in refused)


def test_the_interpreter_is_free_while_it_steps(simulation):
    done = threading.Event()
    thread = threading.Thread(target=lambda: (simulation.run(), done.set()))
    thread.start()
    counted = 0
    while not done.is_set():
        counted += 1
        time.sleep(0.0005)
    thread.join()
    assert counted > 3


def test_checkpoints_and_pickles_go_on_to_the_same_bits(body, tmp_path):
    plain, saved = corticle.Simulation(body), corticle.Simulation(body)
    for _ in range(10):
        plain.step()
        saved.step()
    saved.save(tmp_path / "a.h5")
    restored = corticle.Simulation(body).restore(tmp_path / "a.h5")
    pickled = pickle.loads(pickle.dumps(saved))
    for simulation in (plain, restored, pickled):
        for _ in range(10):
            simulation.step()
    assert restored.steps == pickled.steps == 20
    assert (restored.positions == plain.positions).all()
    assert (pickled.positions == plain.positions).all()
    (tmp_path / "b.h5").write_bytes(b"no checkpoint")
    with pytest.raises(corticle.InputError, match="b.h5"):
        plain.restore(tmp_path / "b.h5")
    plain.step()


def test_another_case_of_the_same_body(body):
    other = body.case
    other.tissue.alpha_t = 0.5
    simulation = corticle.Simulation(body, other)
    simulation.run(until=0.01)
    assert (simulation.growth < corticle.Simulation(body).run(until=0.01).growth + 1e-12).all()
    other.geometry.particles = 1200
    with pytest.raises(corticle.InputError, match="geometry.particles"):
        corticle.Simulation(body, other)


def test_forces_from_python(body):
    g = np.array([0.0, 0.0, -0.5])
    calls = []

    def gravity(t, positions, velocities):
        assert positions.shape == velocities.shape == (len(body), 3)
        calls.append(t)
        return body.volumes[:, None] * g, -float(body.volumes @ (positions @ g))

    case = body.case
    case.tissue.alpha_t = 0.0
    case.solver.damping = 0.0
    simulation = corticle.Simulation(body, case)
    simulation.add_force(gravity, "gravity")
    start = body.volumes @ simulation.positions / body.volumes.sum()
    for _ in range(30):
        simulation.step()
    fallen = body.volumes @ simulation.positions / body.volumes.sum() - start
    assert fallen[2] < 0.0 and abs(fallen[0]) < 1e-9 * abs(fallen[2])
    assert len(calls) >= 31 and "gravity" in simulation.energies


@pytest.mark.parametrize(("answer", "error"), [
    (lambda t, x, v: np.zeros((3, 3)), corticle.InputError),
    (lambda t, x, v: np.zeros(len(x)), corticle.InputError),
    (lambda t, x, v: np.full(x.shape, np.nan), corticle.InputError),
    (lambda t, x, v: "forces", corticle.InputError),
    (lambda t, x, v: None, corticle.InputError),
    (lambda t, x, v: x.astype(complex), corticle.InputError),
    (lambda t, x, v: (np.zeros(x.shape), np.inf), corticle.InputError),
    (lambda t, x: np.zeros(x.shape), TypeError),
    (lambda t, x, v: 1 / 0, ZeroDivisionError),
])
def test_bad_forces_are_refused_at_once_and_left_out(simulation, answer, error):
    with pytest.raises(error):
        simulation.add_force(answer)
    simulation.step()
    assert np.isfinite(simulation.J).all()


def test_a_force_that_fails_later_leaves_a_usable_simulation(body):
    failing = [False]

    def force(t, x, v):
        if failing[0]:
            raise KeyError("later")
        return np.zeros(x.shape)

    simulation, plain = corticle.Simulation(body), corticle.Simulation(body)
    simulation.add_force(force)
    for _ in range(5):
        simulation.step()
        plain.step()
    failing[0] = True
    shown = simulation.positions
    before = shown.copy()
    with pytest.raises(KeyError):
        simulation.step()
    failing[0] = False
    assert (shown == before).all() and simulation.steps == 5
    assert (simulation.J == plain.J).all() and (simulation.stress == plain.stress).all()
    simulation.step()
    plain.step()
    assert (simulation.positions == plain.positions).all()


def test_a_force_cannot_drive_its_own_simulation(simulation):
    def force(t, x, v):
        with pytest.raises(RuntimeError, match="stepping"):
            simulation.step()
        with pytest.raises(RuntimeError, match="stepping"):
            simulation.positions
        return np.zeros(x.shape)

    simulation.add_force(force)
    simulation.step()


def test_forces_that_refer_to_their_simulation_are_collected(body):
    simulation = corticle.Simulation(body)
    simulation.add_force(lambda t, x, v: np.zeros(x.shape) * simulation.body.spacing)
    gone = weakref.ref(simulation)
    del simulation
    gc.collect()
    assert gone() is None


def test_growth_at_particles(body):
    half = np.where(body.positions[:, 0] > 0.0, 2.0, 0.0)
    grown = corticle.Simulation(body.with_fields(growth=half)).run(until=0.01).growth
    deep = body.depth > 3.0
    assert grown[(half == 0.0) | deep].max() < grown.max()
    assert (grown[half == 0.0] == 1.0).all()
    thick = body.with_fields(thickness=np.full(len(body), 4.0))
    assert (thick.thickness == 4.0).all()
    assert corticle.Simulation(thick).theta.sum() > corticle.Simulation(body).theta.sum()
    again = pickle.loads(pickle.dumps(thick))
    assert (again.thickness == 4.0).all() and (again.positions == body.positions).all()


def test_a_failing_run_says_where(body):
    case = body.case
    case.solver.max_halvings = 0
    simulation = corticle.Simulation(body, case)
    struck = int(body.surface_particles[0])
    strength = [0.0]

    def blow(t, x, v):
        forces = np.zeros_like(x)
        forces[struck] = -strength[0] * x[struck]
        return forces

    simulation.add_force(blow)
    simulation.step()
    strength[0] = 1e9
    with pytest.raises(corticle.RunError) as failure:
        simulation.run()
    assert failure.value.step == simulation.steps + 1
    assert failure.value.t >= simulation.t
    assert 0 <= failure.value.particle < len(body)
    assert f"step {failure.value.step}" in str(failure.value)
    assert np.isfinite(simulation.positions).all()
    assert pickle.loads(pickle.dumps(failure.value)).particle == failure.value.particle


def test_threads_change_no_bit(body):
    corticle.set_threads(1)
    assert corticle.threads() == 1
    one = corticle.Simulation(body).run(until=0.01).positions
    corticle.set_threads(3)
    three = corticle.Simulation(body).run(until=0.01).positions
    corticle.set_threads(None)
    assert corticle.threads() >= 1
    corticle.set_threads(1)
    assert (one == three).all()
    for wrong in (0, -1, 2.0, "2", True, 10**6):
        with pytest.raises(corticle.InputError):
            corticle.set_threads(wrong)


def test_a_force_that_fails_after_a_look_leaves_the_state_as_it_was(body):
    """A callback looks at the simulation in the midst of a run, and a later step of the same run fails."""
    case = body.case
    case.tissue.thickness_rate_mm = 3.0  # theta follows t, that of a step that is tried too
    watched, plain = corticle.Simulation(body, case), corticle.Simulation(body, case)

    def force(t, x, v):
        if t > 0.03:
            raise KeyError("later")
        return np.zeros(x.shape)

    watched.add_force(force)
    with pytest.raises(KeyError):
        watched.run(every=0.01, on_output=lambda s: s.J)
    plain.run(until=watched.t, every=0.01)
    assert watched.t > 0.02 and watched.steps == plain.steps
    assert (watched.theta == plain.theta).all() and (watched.stress == plain.stress).all()
