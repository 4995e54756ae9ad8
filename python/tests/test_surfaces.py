# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces: arrays, measures, other libraries, inputs from arrays and images."""

import subprocess

import numpy as np
import pytest

import corticle
from corticle import InputError, Surface


def box(size=(1.0, 2.0, 3.0)):
    """The corners of a box about the origin, and its triangles."""
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * size
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def test_measures_of_a_box():
    measures = corticle.measure(*box())
    assert measures["area_mm2"] == pytest.approx(22.0)
    assert measures["volume_mm3"] == pytest.approx(6.0)
    assert measures == Surface(*box()).measures() == corticle.measure(Surface(*box()))


def test_measures_by_command_and_module_are_the_same(body, command, tmp_path):
    path = tmp_path / "surface.ply"
    body.surface.save(path)
    text = subprocess.run([command, "measure", str(path), "--json"], check=True, capture_output=True, text=True).stdout
    import json

    assert corticle.measure(path) == json.loads(text)


def test_any_real_array_of_the_shape_will_do():
    vertices, triangles = box()
    expected = corticle.measure(vertices, triangles)
    for other in (np.asfortranarray(vertices), vertices.astype(np.float32), vertices.astype(">f8"), vertices[::-1][::-1],
                  np.ascontiguousarray(vertices[:, ::-1])[:, ::-1], vertices.tolist(), np.repeat(vertices, 2, axis=0)[::2]):
        assert corticle.measure(other, triangles) == expected
    for other in (np.asfortranarray(triangles), triangles.astype(np.uint8), triangles.astype(">i8"), triangles[::-1][::-1],
                  triangles.tolist()):
        assert corticle.measure(vertices, other) == expected


@pytest.mark.parametrize("spoil", [
    lambda v, t: (v[:, :2], t), lambda v, t: (v.ravel(), t), lambda v, t: (v[:0], t), lambda v, t: (v[None], t),
    lambda v, t: (v.astype(complex), t), lambda v, t: (v.astype(object), t), lambda v, t: (v.astype(str), t),
    lambda v, t: (v > 0, t), lambda v, t: (np.where(v > 0, np.nan, v), t), lambda v, t: (np.where(v > 0, np.inf, v), t),
    lambda v, t: (v, t[:, :2]), lambda v, t: (v, t[:0]), lambda v, t: (v, t + 1), lambda v, t: (v, t - 1),
    lambda v, t: (v, t.astype(float)), lambda v, t: (v, t.astype(np.int64) + 2**40), lambda v, t: (v, None),
    lambda v, t: (None, t), lambda v, t: ("v", t), lambda v, t: ([[1, 2, 3], [4]], t), lambda v, t: (v, t[1:]),
    lambda v, t: (v, t[:, ::-1]), lambda v, t: (v * 0.0, t), lambda v, t: ({1: 2}, t), lambda v, t: (v, [[0, 1, 2]]),
])
def test_wrong_arrays_are_refused(spoil):
    with pytest.raises(InputError) as refusal:
        corticle.measure(*spoil(*box()))
    assert "\n" not in str(refusal.value)


def test_a_surface_is_constant():
    vertices, triangles = box()
    surface = Surface(vertices, triangles, {"a": np.arange(8.0)})
    vertices[0] = 9.0
    assert surface.vertices[0, 0] == -0.5
    for array in (surface.vertices, surface.triangles, surface["a"]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    with pytest.raises(KeyError):
        surface["b"]
    with pytest.raises(InputError, match="b: got an array of shape"):
        Surface(vertices, triangles, {"b": np.arange(7.0)})


def test_fold_arrays_are_computed_when_they_are_asked_for(body):
    surface = body.surface
    assert "sulcal_depth" not in surface.arrays
    assert surface.sulcal_depth.shape == (len(surface.vertices),)
    assert np.median(surface.mean_curvature) == pytest.approx(1.0 / body.case.geometry.radius_mm, rel=0.1)
    assert "sulcal_depth" in surface.arrays
    with pytest.raises(InputError):
        surface.measures(outer="nothing")


def test_other_libraries(body, tmp_path):
    surface = body.surface
    depth = surface.sulcal_depth
    nibabel = pytest.importorskip("nibabel")
    surface.save(tmp_path / "a.surf.gii")
    points, triangles = nibabel.load(str(tmp_path / "a.surf.gii")).agg_data()
    assert np.allclose(points, surface.vertices, atol=1e-5) and (triangles == surface.triangles).all()
    surface.save_shape("sulcal_depth", tmp_path / "a.shape.gii")
    assert np.allclose(nibabel.load(str(tmp_path / "a.shape.gii")).agg_data(), depth, atol=1e-6)
    assert np.allclose(corticle.read_surface(tmp_path / "a.surf.gii").vertices.mean(axis=0), points.mean(axis=0), atol=1e-4)

    pytest.importorskip("meshio")
    assert (surface.to_meshio().points == surface.vertices).all()
    assert (surface.to_meshio().point_data["sulcal_depth"] == depth).all()
    pytest.importorskip("vtkmodules")
    data = surface.to_vtk()
    assert data.GetNumberOfPoints() == len(surface.vertices) and data.GetNumberOfPolys() == len(surface.triangles)
    assert data.GetPointData().GetArray("sulcal_depth").GetNumberOfTuples() == len(surface.vertices)


def test_pictures_for_notebooks(body):
    pytest.importorskip("matplotlib")
    assert body.surface._repr_png_().startswith(b"\x89PNG")
    assert "<img" in body.surface._repr_html_()


def test_a_body_from_arrays_with_maps(body):
    surface = body.surface
    right = surface.vertices[:, 0] > 0.0
    made = corticle.prepare(surface.vertices, surface.triangles, growth=np.where(right, 2.0, 1.0), thickness=np.full(len(right), 3.0),
                            particles=1000)
    assert made.source == "surface" and np.allclose(made.thickness, 3.0)
    assert made.growth.min() == pytest.approx(1.0) and made.growth.max() == pytest.approx(2.0)
    assert np.allclose(made.growth[made.positions[:, 0] > 4.0], 2.0)
    regions = corticle.prepare(surface, regions=np.where(right, 5, 7), region_growth={5: 0.0, 7: 1.5}, particles=1000)
    assert set(np.unique(regions.growth)) == {0.0, 1.5}
    with pytest.raises(InputError, match="growth"):
        corticle.prepare(surface, growth=np.ones(3), particles=1000)
    with pytest.raises(InputError, match="growth"):
        corticle.prepare(surface, growth=-np.ones(len(right)), particles=1000)
    with pytest.raises(InputError):
        corticle.prepare(body.case, growth=np.ones(len(right)))
    with pytest.raises(InputError):
        corticle.prepare(surface, labels=[1])
    for wrong in (None, 3, object()):
        with pytest.raises(InputError):
            corticle.prepare(wrong)


def test_a_body_from_labels(tmp_path):
    nibabel = pytest.importorskip("nibabel")
    corticle.phantom(tmp_path / "brain.nii.gz", voxel_mm=2.0)
    with pytest.raises(InputError, match="never overwrites"):
        corticle.phantom(tmp_path / "brain.nii.gz")
    by_path = corticle.prepare(tmp_path / "brain.nii.gz", labels=[2, 3, 5, 7], particles=1500)
    by_image = corticle.prepare(nibabel.load(str(tmp_path / "brain.nii.gz")), labels=[2, 3, 5, 7], particles=1500)
    assert by_path.source == "labels"
    assert (by_path.positions == by_image.positions).all()
    with pytest.raises(InputError, match="99"):
        corticle.prepare(tmp_path / "brain.nii.gz", labels=[99], particles=1500)
    measured = corticle.measure(tmp_path / "brain.nii.gz", labels=[2, 3, 5, 7])
    assert 50e3 < measured["volume_mm3"] < 80e3
