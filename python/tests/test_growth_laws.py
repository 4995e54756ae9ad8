# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth laws from Python: hypotheses about growth in a few lines."""

import gc
import pickle
import weakref

import numpy as np
import pytest
from conftest import small_case

import corticle


@pytest.fixture(scope="module")
def moving():
    """A body whose tissue moves and has a history."""
    return corticle.prepare(small_case(**{"tissue.thickness_rate_mm": 2.0, "relaxation.share": 0.5}))


def by_pressure(t, fields):
    """Growth of what is there, the faster the less it is pressed together."""
    rate = fields.theta * (2.0 + np.trace(fields.stress, axis1=1, axis2=2))
    return fields.growth * (1.0 + rate * (t - fields.t)), fields.radial_growth * (1.0 + 0.2 * rate * (t - fields.t))


def test_the_law_of_the_keys_folds_as_the_keys_do():
    case = small_case(**{"imperfection.amplitude": 0.0})
    body = corticle.prepare(case)
    keys, law = corticle.Simulation(body), corticle.Simulation(body)
    law.set_growth(lambda t, fields: 1.0 + case.tissue.alpha_t * fields.theta * t)
    keys.run(until=0.05)
    law.run(until=0.05)
    assert np.abs(keys.positions - body.positions).max() > 0.02
    assert np.allclose(law.positions, keys.positions, rtol=0.0, atol=1e-10)
    assert np.allclose(law.growth, keys.growth) and (law.radial_growth == 1.0).all()
    assert law.steps == keys.steps
    balance = law.measures()["energy_balance_error"]
    assert balance == pytest.approx(keys.measures()["energy_balance_error"], abs=1e-6)


def test_free_growth_is_exact(body):
    """Uniform growth in all directions leaves the body free of stress: it swells by g, nothing else."""
    simulation = corticle.Simulation(body)
    simulation.set_growth(lambda t, fields: (np.full(len(body), 1.0 + 0.1 * t), np.full(len(body), 1.0 + 0.1 * t)))
    simulation.run(until=0.1)
    assert (simulation.growth == simulation.radial_growth).all() and simulation.growth == pytest.approx(1.01)
    assert simulation.J.mean() == pytest.approx(1.01**3, rel=2e-3)


def test_a_law_sees_the_last_step_and_is_asked_for_its_end(moving):
    simulation = corticle.Simulation(moving)
    plain = corticle.Simulation(moving)
    seen = []

    def law(t, fields):
        assert fields.week is None and fields.body is moving and len(fields.depth) == len(moving)
        assert fields.F.shape == fields.stress.shape == (len(moving), 3, 3)
        assert fields.positions.shape == fields.velocities.shape == (len(moving), 3)
        seen.append((t, fields.t, fields.J, fields.stress, fields.theta))
        return by_pressure(t, fields)

    simulation.set_growth(law)
    assert [entry[0] > entry[1] for entry in seen] == [False, True]
    assert (seen[0][4] == plain.theta).all()
    for _ in range(5):
        before = simulation.t, simulation.J, simulation.stress, simulation.theta
        simulation.step()
        t, *shown = seen[-1]
        assert t == simulation.t
        for value, expected in zip(shown, before):
            assert np.array_equal(value, expected)
    assert (simulation.growth > 1.0).any() and (simulation.radial_growth > 1.0).any()


def test_weeks_are_given_in_a_case_with_a_clock():
    case = small_case()
    del case.time.end
    case.time.clock, case.time.start_week, case.time.end_week = "wang", 24.0, 25.0
    simulation = corticle.Simulation(corticle.prepare(case))
    weeks = []

    def law(week, fields):
        weeks.append((week, fields.week))
        return 1.0 + 0.05 * (week - 24.0) * fields.theta

    simulation.set_growth(law)
    simulation.run()
    assert weeks[0] == pytest.approx((24.0, 24.0)) and weeks[-1][0] == pytest.approx(25.0)
    assert all(now > before for now, before in weeks[1:])
    assert simulation.growth.max() == pytest.approx(1.0 + 0.05 * simulation.theta.max())


def test_a_brain_that_grows_by_week_can_grow_by_a_law(tmp_path):
    corticle.phantom(tmp_path / "labels.nii.gz", voxel_mm=2.0)
    case = corticle.Case.brain(tmp_path / "labels.nii.gz", labels=[2, 3, 5, 7], particles=1000, clock="wang", start_week=23.0,
                               end_week=23.5, pictures="off")
    case.tissue.labels.cortex, case.tissue.labels.white = [2], [3]
    case.tissue.labels.ventricle, case.tissue.labels.deep = [5], [7]
    case.growth.law = "fetal"
    simulation = corticle.Simulation(corticle.prepare(case))
    assert np.linalg.norm(simulation.velocities, axis=1).max() > 0.0
    simulation.set_growth(lambda week, fields: (np.full(len(fields.depth), np.exp(0.1 * (week - 23.0))),) * 2)
    # The body and the medium around it move with the mean growth of the law.
    x = simulation.positions[:, 0]
    rates = simulation.velocities[:, 0] / (x - np.average(x, weights=simulation.body.volumes))
    assert rates == pytest.approx(rates.mean(), rel=1e-6)
    simulation.run()
    assert simulation.J.mean() == pytest.approx(np.exp(0.15), rel=0.02)


def test_checkpoints_hold_the_growth_and_go_on_to_the_same_bits(moving, tmp_path):
    plain, saved = corticle.Simulation(moving), corticle.Simulation(moving)
    for simulation in (plain, saved):
        simulation.set_growth(by_pressure)
        for _ in range(8):
            simulation.step()
    saved.save(tmp_path / "a.h5")
    restored = corticle.Simulation(moving)
    with pytest.raises(corticle.InputError, match="growth law"):
        restored.restore(tmp_path / "a.h5")
    restored.set_growth(by_pressure)
    restored.restore(tmp_path / "a.h5")
    for _ in range(8):
        plain.step()
        restored.step()
    assert (restored.positions == plain.positions).all() and (restored.growth == plain.growth).all()
    corticle.Simulation(moving).run(until=0.01).save(tmp_path / "b.h5")
    with pytest.raises(corticle.InputError, match="growth law"):
        restored.restore(tmp_path / "b.h5")
    restored.step()
    with pytest.raises(corticle.InputError, match="pickled"):
        pickle.dumps(restored)


@pytest.mark.parametrize(("answer", "error"), [
    (lambda t, f: np.ones(3), corticle.InputError),
    (lambda t, f: np.ones((len(f.depth), 1)), corticle.InputError),
    (lambda t, f: np.array([]), corticle.InputError),
    (lambda t, f: np.full(f.depth.shape, np.nan), corticle.InputError),
    (lambda t, f: np.zeros(f.depth.shape), corticle.InputError),
    (lambda t, f: np.full(f.depth.shape, 1.5), corticle.InputError),
    (lambda t, f: -np.ones(f.depth.shape), corticle.InputError),
    (lambda t, f: np.ones(f.depth.shape, dtype=complex), corticle.InputError),
    (lambda t, f: "growth", corticle.InputError),
    (lambda t, f: None, corticle.InputError),
    (lambda t, f: (np.ones(f.depth.shape),) * 3, corticle.InputError),
    (lambda t, f: (np.ones(f.depth.shape), np.ones(4)), corticle.InputError),
    (lambda t, f: (np.ones(f.depth.shape), None), corticle.InputError),
    (lambda t: 1.0, TypeError),
    (lambda t, f: 1 / 0, ZeroDivisionError),
    (lambda t, f: f.nothing, AttributeError),
])
def test_bad_laws_are_refused_at_once_and_left_out(body, answer, error):
    simulation, plain = corticle.Simulation(body), corticle.Simulation(body)
    with pytest.raises(error):
        simulation.set_growth(answer)
    simulation.step()
    plain.step()
    assert (simulation.positions == plain.positions).all() and (simulation.growth == plain.growth).all()


def test_any_real_array_of_the_shape_will_do(body):
    def run(form):
        simulation = corticle.Simulation(body)
        simulation.set_growth(lambda t, fields: form(1.0 + np.round(fields.theta * t, 4)))
        return simulation.run(until=0.01).positions

    expected = run(lambda growth: growth)
    for form in (lambda g: g.astype(">f8"), lambda g: g[::-1].copy()[::-1], lambda g: np.repeat(g, 2)[::2], lambda g: g.tolist()):
        assert (run(form) == expected).all()


def test_a_law_that_fails_later_leaves_a_usable_simulation(moving):
    failing = [False]

    def law(t, fields):
        if failing[0]:
            raise KeyError("later")
        return by_pressure(t, fields)

    simulation, plain = corticle.Simulation(moving), corticle.Simulation(moving)
    simulation.set_growth(law)
    plain.set_growth(by_pressure)
    for _ in range(5):
        simulation.step()
        plain.step()
    failing[0] = True
    with pytest.raises(KeyError):
        simulation.step()
    failing[0] = False
    for name in ("J", "stress", "theta", "growth", "radial_growth"):
        assert (getattr(simulation, name) == getattr(plain, name)).all(), name
    simulation.step()
    plain.step()
    assert (simulation.positions == plain.positions).all()


def test_a_law_can_only_look(body):
    simulation = corticle.Simulation(body)
    kept = []

    def law(t, fields):
        kept.append(fields)
        for use in (simulation.step, lambda: simulation.positions, lambda: simulation.J, simulation.run,
                    lambda: simulation.set_growth(law), lambda: simulation.add_force(law)):
            with pytest.raises(RuntimeError, match="stepping"):
                use()
        with pytest.raises(ValueError, match="read-only"):
            fields.growth[0] = 2.0
        return np.ones(len(fields.depth))

    simulation.set_growth(law)
    simulation.step()
    for name in ("t", "week", "positions", "velocities", "F", "J", "stress", "theta", "growth", "radial_growth"):
        with pytest.raises(RuntimeError, match="has answered"):
            getattr(kept[-1], name)


def test_one_law_before_the_first_step(body):
    simulation = corticle.Simulation(body)
    for wrong in (None, 3, "law"):
        with pytest.raises(corticle.InputError):
            simulation.set_growth(wrong)
    simulation.set_growth(lambda t, fields: np.ones(len(fields.depth)))
    with pytest.raises(corticle.InputError, match="has a law"):
        simulation.set_growth(by_pressure)
    late = corticle.Simulation(body)
    late.step()
    with pytest.raises(corticle.InputError, match="before the first step"):
        late.set_growth(by_pressure)


def test_laws_that_refer_to_their_simulation_are_collected(body):
    simulation = corticle.Simulation(body)
    simulation.set_growth(lambda t, fields: np.full(len(body), 1.0 + 0.0 * simulation.body.spacing))
    gone = weakref.ref(simulation)
    del simulation
    gc.collect()
    assert gone() is None
