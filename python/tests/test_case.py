# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases: the keys, checks and messages of case files."""

import copy
import json
import pickle
import re
import subprocess

import numpy as np
import pytest

import corticle
from corticle import Case, InputError
from corticle.sections import attribute


def test_every_key_is_an_attribute_with_a_docstring():
    case = Case()
    for row in corticle.parameters():
        owner, name = case, attribute(row["key"])
        for section in row["key"].split(".")[:-1]:
            owner = getattr(owner, section)
        assert getattr(owner, name) == case[row["key"]]
        assert row["sentence"] in getattr(type(owner), name).__doc__


def test_what_is_set_is_read_back_and_in_the_toml():
    case = Case.sphere(particles=2000)
    case.tissue.alpha_t = 1.25
    case["time.end"] = np.float64(0.5)
    case.tissue.layer = "binary"
    case.tissue.lambda_ = 0.8
    assert case["tissue.lambda"] == case["lambda"] == 0.8
    assert (case.geometry.particles, case.tissue.alpha_t, case.time.end) == (2000, 1.25, 0.5)
    assert Case.from_toml(case.to_toml()) == case


def test_sections_within_sections():
    case = Case.sphere(particles=2000)
    case.tissue.labels.cortex = [2]
    assert case["tissue.labels.cortex"] == case.tissue.labels.cortex == [2]
    assert "labels" in dir(case.tissue) and "cortex = [2]" in repr(case.tissue.labels)


def test_lists_of_tables():
    case = Case.sphere(particles=2000, end=0.5)  # a key alone is that of a section, not of a list
    case.support[2].kind, case.support[2].plane = "fixed", "x_min"
    case["support.1.kind"] = "roller"
    case.support[1].plane = "z_min"
    assert case["support.2.plane"] == "x_min" and case.support[1].kind == "roller"
    assert case.to_toml().count("[[support]]") == 2 and Case.from_toml(case.to_toml()) == case
    assert len(case.support) == 8 and "[support.2]" in repr(case.support)
    for wrong in (0, 9, -1, "1", True, 1.0):
        with pytest.raises(InputError, match="integer from 1 to 8"):
            case.support[wrong]
    with pytest.raises(InputError, match=r"support\.1\.kind is out of range \(case\.support\.1\.kind\)"):
        case.support[1].kind = "loose"
    with pytest.raises(InputError, match=r"did you mean support\.1\.plane"):
        case.support[1].plan = "x_min"
    del case.support[2].kind
    with pytest.raises(InputError, match=r"support\.2\.kind"):
        case.check()


@pytest.mark.parametrize(("keys", "message"), [
    ({"boundary.shape": "cube"}, "boundary.shape is out of range"),
    ({"fibres.direction": "radial", "fibres.active_stress": 0.0}, "fibres carry nothing"),
    ({"fibres.stiffness": 1.0}, "fibres.direction"),
    ({"relaxation.share": 2.0}, "relaxation.share is out of range"),
    ({"relaxation.time": 1.0}, "relaxation.share"),
    ({"stress_growth.shrinks": True}, "stress_growth.rate"),
    ({"map.growth_times": [0.5, 0.1]}, "map.growth_times"),
    ({"growth.law": "table"}, "growth.table"),
    ({"tissue.labels.cortex": [2]}, "tissue.labels"),
])
def test_sections_of_hypotheses_have_the_checks_of_case_files(keys, message, command, tmp_path):
    with pytest.raises(InputError) as refusal:
        Case.sphere(keys).check()
    assert message in str(refusal.value)
    sets = [f"--set={key}={json.dumps(value)}" for key, value in keys.items()]
    path = tmp_path / "case.toml"
    path.write_text('[geometry]\nshape = "sphere"\n')
    said = subprocess.run([command, "check", path, *sets], capture_output=True, text=True, check=False)
    assert said.returncode != 0

    def plain(text):
        return re.sub(r" \([^()]*\)", "", text)  # where the value was given differs

    assert plain(str(refusal.value)) in plain(said.stderr)


def test_what_is_deleted_is_the_default_again():
    case = Case.sphere(radius_mm=10.0)
    del case.geometry.radius_mm
    assert case.geometry.radius_mm == Case().geometry.radius_mm


def test_what_is_set_replaces_what_a_file_says():
    case = Case.from_toml("[geometry]\nparticles = 3000\n", keys={"spacing_mm": 1.0})
    assert case.geometry.spacing_mm == 1.0
    assert "particles = " not in case.to_toml()


@pytest.mark.parametrize(("set_key", "message"), [
    (lambda c: c.geometry.__setattr__("particles", 3), "geometry.particles is out of range (case.geometry.particles): got the integer 3"),
    (lambda c: c.geometry.__setattr__("particles", "many"), "geometry.particles has the wrong type"),
    (lambda c: c.geometry.__setattr__("particles", True), "geometry.particles has the wrong type"),
    (lambda c: c.geometry.__setattr__("particles", 10**30), "an integer of more than 64 bits"),
    (lambda c: c.tissue.__setattr__("alpha_t", float("nan")), "tissue.alpha_t is out of range"),
    (lambda c: c.tissue.__setattr__("alpha_t", None), "got None"),
    (lambda c: c.tissue.__setattr__("alpha_t", object()), "an object of type object"),
    (lambda c: c.output.__setattr__("times", [0.1, "b"]), "output.times has the wrong type"),
    (lambda c: c.output.__setattr__("times", [0.2, 0.1]), "output.times is out of range"),
    (lambda c: c.geometry.__setattr__("particels", 3000), "did you mean geometry.particles?"),
    (lambda c: c.update(particels=3000), "unknown key"),
    (lambda c: c.__setattr__("geometry", 3), "is no key"),
    (lambda c: c.geometry.__setattr__("file", "a\0b"), "geometry.file"),
])
def test_bad_values_are_refused_with_the_message_of_case_files(set_key, message):
    case = Case.sphere()
    before = case.to_toml()
    with pytest.raises(InputError) as refusal:
        set_key(case)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)
    assert case.to_toml() == before


def test_unknown_attributes_are_attribute_errors():
    assert not hasattr(Case().geometry, "particels")
    with pytest.raises(AttributeError, match="did you mean geometry.particles"):
        Case().geometry.particels


def test_keys_that_do_not_go_together_are_refused_on_use():
    case = Case.sphere(particles=2000, spacing_mm=1.0)
    with pytest.raises(InputError, match="geometry.spacing_mm"):
        case.check()
    assert case.geometry.particles == 2000
    del case.geometry.spacing_mm
    case.check()


def test_errors_of_files_name_the_line(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text("[geometry]\nparticles = 1\n")
    with pytest.raises(InputError, match=r"case\.toml:2"):
        Case.load(path)
    with pytest.raises(InputError, match="no such file"):
        Case.load(tmp_path / "none.toml")
    for wrong in (3, None, b"x"):
        with pytest.raises(InputError):
            Case.load(wrong)
        with pytest.raises(InputError):
            Case.from_toml(wrong)


def test_copies_and_pickles_are_equal_and_apart():
    case = Case.sphere(particles=2000)
    for other in (case.copy(), copy.copy(case), copy.deepcopy(case), pickle.loads(pickle.dumps(case))):
        assert other == case
        other.geometry.particles = 3000
        assert case.geometry.particles == 2000


def test_a_case_with_arrays_can_be_pickled(body):
    case = Case.surface(body.surface, growth=np.ones(len(body.surface.vertices)), particles=1000)
    other = pickle.loads(pickle.dumps(case))
    assert other.geometry.file != case.geometry.file
    other.check()


def test_representations():
    case = Case.sphere(particles=2000)
    assert "particles" in repr(case)
    assert "[geometry]" in repr(case.geometry)
    assert "particles" in dir(case.geometry)
    assert "particles = 2000" in case._repr_html_()
