# SPDX-License-Identifier: GPL-3.0-or-later
"""Run folders: the same files as by the command, to the same bits; reading them; comparing."""

import json
import os
import shutil
import signal
import subprocess
import threading
import warnings

import numpy as np
import pytest
from conftest import small_case

import corticle


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return corticle.run(small_case(), tmp_path_factory.mktemp("runs") / "a")


def test_command_and_module_give_the_same_bits(run, command, tmp_path):
    case_file = tmp_path / "case.toml"
    small_case().save(case_file)
    subprocess.run([command, "run", str(case_file), "--out", str(tmp_path / "b"), "--quiet"], check=True)
    names = sorted(path.name for path in run.folder.iterdir())
    assert names == sorted(path.name for path in (tmp_path / "b").iterdir())
    compared = [name for name in names if name.endswith((".vtp", ".vtu", ".csv", ".pvd", ".toml"))]
    assert len(compared) >= 10
    for name in compared:
        assert (run.folder / name).read_bytes() == (tmp_path / "b" / name).read_bytes(), name


def test_simulation_and_run_give_the_same_bits(run, body):
    simulation = corticle.Simulation(body).run()
    assert (simulation.surface.vertices == run.frames[-1].surface.vertices).all()
    assert (simulation.positions == run.frames[-1].particles.positions).all()
    row = {key: values[-1] for key, values in run.columns.items()}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        measures = simulation.measures()
    for key in ("t", "steps", "J_min", "energy_elastic", "area_mm2", "gi_hull"):
        assert measures[key] == row[key], key


def test_a_run_is_read(run):
    assert run.status == "completed" and run.summary["status"] == "completed"
    assert run.case == small_case()
    assert len(run.frames) == 3 and run.frames[0].t == 0.0 and run.frames[-1].t == 0.1
    assert run.frames.nearest(0.06).t == pytest.approx(0.05)
    with pytest.raises(corticle.InputError):
        run.frames.nearest(week=30)
    with pytest.raises(corticle.InputError):
        run.frames.nearest()
    pandas = pytest.importorskip("pandas")
    assert isinstance(run.measures, pandas.DataFrame)
    assert list(run.measures.columns) == list(run.columns) and len(run.measures) == 3
    assert run.units["area_mm2"] == "mm2"
    particles = run.frames[-1].particles
    assert particles["F"].shape == (len(particles), 3, 3)
    assert np.allclose(np.linalg.det(particles["F"]), particles["J"], rtol=1e-9)
    surface = run.frames[-1].surface
    assert surface.sulcal_depth.shape == (len(surface.vertices),)
    assert "completed" in repr(run)


def test_the_report_is_shown_where_there_is_one(run, tmp_path):
    shutil.copytree(run.folder, tmp_path / "a")
    copy = corticle.open_run(tmp_path / "a")
    report = copy.folder / "report.html"
    assert "<!DOCTYPE html>" in report.read_text(encoding="utf-8")  # the run wrote it
    report.write_text("<h1>\"Report\"</h1>")
    assert copy._repr_html_().startswith("<iframe srcdoc=") and "&quot;Report&quot;" in copy._repr_html_()
    report.unlink()
    assert "<table>" in copy._repr_html_()
    assert corticle.report(copy.folder) == report and report.stat().st_size > 100_000


def test_what_is_no_run_is_refused(tmp_path):
    for wrong in (tmp_path, tmp_path / "none", 3, None, "a\0b"):
        with pytest.raises(corticle.InputError):
            corticle.open_run(wrong)


def test_an_earlier_run_is_not_overwritten(run):
    before = (run.folder / "measures.csv").read_bytes()
    with pytest.raises(corticle.InputError, match="--overwrite"):
        corticle.run(small_case(), run.folder)
    assert (run.folder / "measures.csv").read_bytes() == before


def test_outputs_are_shown_and_an_exception_interrupts_with_a_checkpoint(run, tmp_path):
    seen = []

    def stop(output):
        seen.append(output)
        if output.number == 1:
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        corticle.run(small_case(), tmp_path / "a", on_output=stop)
    assert [output.number for output in seen] == [0, 1] and seen[1].t == pytest.approx(0.05)
    assert seen[0].surface.vertices.shape == run.frames[0].surface.vertices.shape
    stopped = corticle.open_run(tmp_path / "a")
    assert stopped.status == "interrupted"
    resumed = corticle.run(small_case(), tmp_path / "a", resume=True)
    assert (resumed.folder / "measures.csv").read_bytes() == (run.folder / "measures.csv").read_bytes()
    assert (resumed.frames[-1].surface.vertices == run.frames[-1].surface.vertices).all()


def test_ctrl_c_interrupts_with_a_checkpoint(tmp_path):
    handlers = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)}
    environment = dict(os.environ)
    timer = threading.Timer(1.0, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        corticle.run(small_case(**{"time.end": 1.0, "geometry.particles": 20000}), tmp_path / "a")
    timer.join()
    assert corticle.open_run(tmp_path / "a").status == "interrupted"
    assert (tmp_path / "a" / "checkpoint.h5").exists()
    assert {number: signal.getsignal(number) for number in handlers} == handlers
    assert dict(os.environ) == environment


def test_warnings_are_python_warnings(tmp_path, capfd):
    with pytest.warns(corticle.CorticleWarning, match="thinner than two spacings") as caught:
        corticle.run(small_case(**{"tissue.thickness_mm": 0.5, "time.end": 0.001}), tmp_path / "a")
    assert any(warning.filename == __file__ for warning in caught)
    assert capfd.readouterr() == ("", "")
    with warnings.catch_warnings():
        warnings.simplefilter("error", corticle.CorticleWarning)
        with pytest.raises(corticle.CorticleWarning):
            corticle.run(small_case(**{"tissue.thickness_mm": 0.5, "time.end": 0.001}), tmp_path / "b")


def test_progress_is_shown_when_it_is_wanted(tmp_path, capfd):
    corticle.run(small_case(**{"time.end": 0.001}), tmp_path / "a", progress=True)
    assert capfd.readouterr().out == ""


def test_runs_are_compared(run, tmp_path):
    other = corticle.run(small_case(**{"tissue.alpha_t": 1.2}), tmp_path / "b")
    result = corticle.compare(run, other, tmp_path / "report")
    assert json.loads((tmp_path / "report" / "comparison.json").read_text()) == result
    with pytest.raises(corticle.InputError, match="--overwrite"):
        corticle.compare(run, other, tmp_path / "report")
    with pytest.raises(corticle.InputError):
        corticle.compare(run, [], tmp_path / "c")
