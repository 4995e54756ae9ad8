# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions of fibres, given by array."""

import pickle

import numpy as np
import pytest
from conftest import small_case

import corticle


@pytest.fixture(scope="module")
def fibred():
    return corticle.prepare(small_case(**{"fibres.direction": "radial", "fibres.stiffness": 0.5, "fibres.active_stress": 0.5}))


def folded(body, case=None):
    return corticle.Simulation(body, case).run(until=0.02).positions


def test_given_directions_are_those_that_are_used(fibred):
    assert np.allclose(np.linalg.norm(fibred.fibres, axis=1), 1.0)
    same = fibred.with_fields(fibres=-3.0 * fibred.fibres)  # neither length nor sign matters
    assert np.allclose(folded(same), folded(fibred), rtol=0.0, atol=1e-10)
    along_z = fibred.with_fields(fibres=np.broadcast_to([0.0, 0.0, 1.0], (len(fibred), 3)))
    assert (along_z.fibres == [0.0, 0.0, 1.0]).all()
    x, y, z = (np.ptp(folded(along_z), axis=0) - np.ptp(folded(fibred), axis=0))
    assert z < min(x, y)  # tension along z makes the body shorter there than radial tension does


def test_where_a_direction_is_0_there_are_no_fibres(fibred):
    inner = np.argmin(np.linalg.norm(fibred.positions, axis=1))
    none = np.zeros((len(fibred), 3))
    none[inner] = [1.0, 0.0, 0.0]
    case = fibred.case
    case.fibres.stiffness, case.fibres.active_stress, case.fibres.growth_rate = 0.0, 1e-9, 0.0
    without = folded(corticle.prepare(case))
    assert np.abs(folded(fibred.with_fields(fibres=none)) - without).max() < np.abs(folded(fibred) - without).max()
    assert np.allclose(folded(fibred.with_fields(fibres=none))[fibred.surface_particles], without[fibred.surface_particles], atol=0.01)


def test_they_stay_with_another_case_and_in_pickles(fibred):
    along_z = fibred.with_fields(fibres=np.broadcast_to([0.0, 0.0, 1.0], (len(fibred), 3)))
    other = along_z.case
    other.tissue.alpha_t = 1.0
    assert (folded(along_z, other) != folded(fibred, other)).any()
    assert (folded(pickle.loads(pickle.dumps(along_z))) == folded(along_z)).all()
    assert (along_z.with_fields(growth=along_z.growth).fibres == along_z.fibres).all()


def test_those_of_an_earlier_case_do_not_stay(fibred):
    other = fibred.case
    other.fibres.direction = "depth"
    assert (folded(fibred, other) == folded(corticle.prepare(other))).all()
    del other.fibres.direction, other.fibres.stiffness, other.fibres.active_stress
    assert (folded(fibred, other) == folded(corticle.prepare(other))).all()


def test_directions_at_the_vertices_of_a_surface(body):
    ball = body.surface
    keys = {"fibres.direction": "depth", "fibres.active_stress": 0.5, "geometry.particles": 1000, "time.end": 0.1}
    made = corticle.prepare(ball.vertices, ball.triangles, fibres=ball.vertices, **keys)
    outer = np.linalg.norm(made.positions, axis=1) > 5.0
    radial = made.positions[outer] / np.linalg.norm(made.positions[outer], axis=1)[:, None]
    assert np.einsum("ij,ij->i", made.fibres[outer], radial).min() > 0.9
    moved = corticle.prepare(corticle.Surface(ball.vertices + [1000.0, 0.0, 0.0], ball.triangles), fibres=ball.vertices, **keys)
    assert np.einsum("ij,ij->i", moved.fibres, moved.positions - [1000.0, 0.0, 0.0])[outer[:len(moved)]].min() > 0.0


@pytest.mark.parametrize("wrong", [np.ones(3), np.ones((4, 3)), np.ones((1000, 2)), np.full((1000, 3), np.nan), np.zeros((1000, 3)),
                                   np.empty((0, 3)), "radial", np.ones((1000, 3), dtype=complex)])
def test_wrong_directions_are_refused(fibred, wrong):
    with pytest.raises(corticle.InputError, match="fibres"):
        fibred.with_fields(fibres=wrong)


def test_a_case_without_fibres_takes_none(body):
    assert body.fibres is None
    with pytest.raises(corticle.InputError, match="fibres.direction"):
        body.with_fields(fibres=np.ones((len(body), 3)))
    with pytest.raises(corticle.InputError, match="without a surface"):
        corticle.prepare(body.case, fibres=np.ones((len(body), 3)))
