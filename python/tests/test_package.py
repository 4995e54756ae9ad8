# SPDX-License-Identifier: GPL-3.0-or-later
"""The package as such: stubs, types, documentation, examples."""

import importlib.util
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import SOURCE

import corticle
from corticle import sections

EXAMPLES = sorted((SOURCE / "examples").rglob("*.py"))
TUTORIALS = sorted((SOURCE / "examples/tutorials").glob("*.py"))


def test_the_stub_of_the_sections_is_that_of_the_table():
    expected = (SOURCE / "python/corticle/sections.pyi").read_text(encoding="utf-8")
    assert sections.stub() == expected, "python -m corticle.sections > python/corticle/sections.pyi"


def test_everything_public_has_a_docstring():
    for name in corticle.__all__:
        thing = getattr(corticle, name)
        if name == "__version__":
            continue
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and not issubclass(thing, BaseException):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert inspect.getdoc(value) or member == "folder", f"{name}.{member}"


def test_version():
    assert re.match(r"\d+\.\d+\.\d+", corticle.__version__)
    assert (Path(corticle.__file__).parent / "py.typed").exists()


def test_types():
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")
    paths = [str(SOURCE / "python/corticle"), *map(str, EXAMPLES)]
    done = subprocess.run([sys.executable, "-m", "mypy", "--config-file", str(SOURCE / "pyproject.toml"), "--cache-dir", os.devnull,
                           *paths], capture_output=True, text=True, check=False, cwd=SOURCE)
    assert done.returncode == 0, done.stdout + done.stderr


def environment():
    """That of a script: bodies are small, for which one thread is enough."""
    return {**os.environ, "MPLBACKEND": "agg", "OMP_NUM_THREADS": "1", "PYTHONPATH": str(Path(corticle.__file__).parents[1])}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_examples(example, tmp_path):
    done = subprocess.run([sys.executable, "-W", "ignore", str(example)], cwd=tmp_path, env=environment(), capture_output=True, text=True,
                          timeout=300, check=False)
    assert done.returncode == 0, done.stderr


def test_every_guide_has_a_tutorial_or_says_why_not():
    """The table of the guide of Python names every guide, and every tutorial is in it."""
    table = (SOURCE / "docs/guide/python.md").read_text(encoding="utf-8").split("| guide |")[1].split("\n\n")[0]
    guides = {path.name for path in (SOURCE / "docs/guide").glob("*.md")} - {"python.md", "parameters.md"}
    assert guides == set(re.findall(r"\]\(([\w-]+\.md)\)", table))
    assert {path.name for path in TUTORIALS} == set(re.findall(r"`(\w+\.py)`", table))
    for path in TUTORIALS:
        text = path.read_text(encoding="utf-8")
        assert text.count("# %% [markdown]\n# ") >= 1 and text.count("# %%\n") >= 2, path.name


def test_the_reference_is_written_without_warnings(tmp_path):
    pytest.importorskip("sphinx")
    done = subprocess.run([sys.executable, "-m", "sphinx", "-W", "-q", "-b", "html", "-d", tmp_path / "trees", SOURCE / "docs/api",
                           tmp_path / "api"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "api/index.html").read_text(encoding="utf-8")
    for name in corticle.__all__:
        assert f'id="corticle.{name}"' in page or name == "__version__", name


def test_the_script_of_the_readme(tmp_path):
    pytest.importorskip("matplotlib")
    text = (SOURCE / "README.md").read_text(encoding="utf-8")
    script = re.search(r"```python\n(.*?)```", text, re.S)[1]
    corticle.phantom(tmp_path / "labels.nii.gz", voxel_mm=2.0)
    (tmp_path / "cases").symlink_to(SOURCE / "cases")
    quick = script.replace('"end_week": 30', '"end_week": 23.2, "particles": 1500')
    assert quick != script
    quick = re.sub(r'"output.weeks": [^,}]*(\[[^]]*\]|\)),?', '"output.weeks": [23.1],', quick)
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", quick], cwd=tmp_path, env=environment(), capture_output=True, text=True,
                          timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "week30.surf.gii").exists() and (tmp_path / "folding.png").exists()
