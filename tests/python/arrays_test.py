# SPDX-License-Identifier: Apache-2.0
"""Arrays: scenes made of them, views of results, and who keeps what alive."""
import gc
import types
import weakref

import numpy as np
import pytest

import luxel
from conftest import CUBE, INSIDE, furnace

VIEWS = {"irradiance": ("n", 3), "irradiance_back": ("n", 3), "irradiance_error": ("n", 3), "irradiance_error_back": ("n", 3),
         "radiosity": ("n", 3), "radiosity_back": ("n", 3), "areas": ("n",), "normals": ("n", 3), "corners": ("n", 3),
         "triangles": ("n",), "patch_materials": ("n",)}


@pytest.mark.parametrize("name", VIEWS)
def test_views_are_read_only_and_without_a_copy(box, name):
    array = getattr(box, name)
    assert array.shape == tuple(len(box) if d == "n" else d for d in VIEWS[name])
    assert array.base is not None and not array.flags.owndata
    assert np.shares_memory(array, getattr(box, name))
    with pytest.raises(ValueError):
        array[0] = 0
    with pytest.raises(ValueError):
        array.setflags(write=True)


def test_arrays_keep_their_solution_alive():
    solution = luxel.bake(furnace(), error=0.1, max_edge=0.3)
    before = solution.irradiance.copy()
    handle = weakref.ref(solution._handle)
    array = solution.irradiance[1:]
    with solution:
        pass
    assert handle() is not None  # the array's
    np.testing.assert_array_equal(array, before[1:])
    del array
    gc.collect()
    assert handle() is None
    with pytest.raises(ValueError, match="closed"):
        _ = solution.irradiance


def test_arrays_of_a_scene_keep_it_alive():
    scene = furnace()
    vertices, faces = scene.vertices, scene.faces
    del scene
    gc.collect()
    np.testing.assert_array_equal(vertices, CUBE)
    np.testing.assert_array_equal(faces, INSIDE)
    assert not vertices.flags.writeable


def test_geometry_fits_together(box):
    a, b, c = (box.vertices[box.corners[:, k]].astype(float) for k in range(3))
    cross = np.cross(b - a, c - a)
    length = np.linalg.norm(cross, axis=1)
    np.testing.assert_allclose(0.5 * length, box.areas, rtol=1e-4)
    np.testing.assert_allclose(cross / length[:, None], box.normals, atol=1e-4)
    np.testing.assert_allclose(box.centroids, (a + b + c) / 3.0, atol=1e-6)


def test_radiosity_is_emittance_and_reflected_light(box):
    materials = box.patch_materials
    expected = box.emittance[materials] + box.reflectance[materials] * box.irradiance
    np.testing.assert_allclose(box.radiosity, expected, rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(box.radiosity_error, box.reflectance[materials] * box.irradiance_error, rtol=1e-6)


def test_illuminance_is_179_lumens_per_watt_of_white(box):
    assert box.lux.sum() == pytest.approx(179.0, rel=1e-3)
    np.testing.assert_allclose(box.illuminance, box.irradiance @ box.lux)


def test_replicates_average_to_the_light(box):
    replicates = box.replicates()
    assert replicates.shape[1:] == (len(box), 2)
    lit = box.illuminance > 0.05 * box.illuminance.mean()
    # Smoothing changes single patches, not the whole.
    mean = replicates.mean(axis=0)[:, 0]
    weights = box.areas * lit
    assert (mean @ weights) / (box.illuminance @ weights) == pytest.approx(1.0, abs=0.02)


def test_mean_of_a_surface_is_that_of_its_patches(box):
    for measure in box.measure(side="front"):
        patches = box.patches_of(measure.name)
        values, areas = box.illuminance[patches], box.areas[patches]
        lit = values >= 1e-4 * np.average(values, weights=areas)
        if lit.any():
            assert measure.mean.value == pytest.approx(np.average(values[lit], weights=areas[lit]), rel=1e-4)
        assert measure.mean.low <= measure.mean.value <= measure.mean.high
        assert measure.min.value <= measure.mean.value <= measure.max.value


def test_intervals_of_means_cover_a_finer_answer(box_file):
    def baked(seed, error):
        return luxel.bake(box_file, error=error, max_edge=0.3, seed=seed, mesh_error="none", store_transport=True)

    fine = baked(99, 0.01)
    names = [m.name for m in fine.measure() if m.mean.value > 0.0]
    seeds = range(1, 25)
    covered = 0
    for seed in seeds:
        rough = baked(seed, 0.1)
        covered += sum(rough.mean(name).low <= fine.mean(name).value <= rough.mean(name).high for name in names)
    # Of 95 % intervals. If all surfaces of a seed missed together, chance would give less once in a thousand times.
    assert covered >= 0.75 * len(names) * len(seeds)


def test_mean_takes_indices_and_masks(box):
    name = box.materials[0]
    patches = box.patches_of(name)
    mask = np.zeros(len(box), dtype=bool)
    mask[patches] = True
    assert box.mean(patches) == box.mean(mask) == box.mean(name)
    with pytest.raises(luxel.InputError, match="there is no surface 'nothing'"):
        box.mean("nothing")
    with pytest.raises(luxel.InputError, match="indices"):
        box.mean([len(box)])


def test_objects_and_groups_need_the_scene(box, box_file):
    scene = luxel.load_scene(box_file)
    for name in scene.groups:
        if name not in box.materials:
            assert len(box.patches_of(name, scene)) > 0
    with pytest.raises(luxel.MismatchError):
        box.patches_of("wall", furnace())


def test_duck_typed_meshes_are_scenes():
    mesh = types.SimpleNamespace(vertices=CUBE.tolist(), faces=INSIDE.tolist())
    scene = luxel.Scene.from_arrays(mesh, materials=luxel.Material("wall", 0.5, 1.0))
    assert scene.fingerprint == furnace().fingerprint
    assert luxel.bake(mesh, method="shooting", max_edge=0.0, sky=1.0).irradiance.shape == (12, 3)


def test_materials_by_name_and_by_index():
    rows = {"wall": {"reflectance": (0.2, 0.4, 0.6)}, "lamp": {"emission": 10.0}}
    names = np.array(["wall"] * 10 + ["lamp"] * 2)
    scene = luxel.Scene.from_arrays(CUBE, INSIDE, rows, names)
    assert scene.materials == ("wall", "lamp")
    np.testing.assert_array_equal(scene.face_materials, [0] * 10 + [1] * 2)
    solution = luxel.bake(scene, error=0.2, max_edge=0.5)
    np.testing.assert_allclose(solution.reflectance, [[0.2, 0.4, 0.6], [0.5] * 3])
    np.testing.assert_allclose(solution.emittance, [[0.0] * 3, [10.0 * np.pi] * 3], rtol=1e-6)


def test_scene_far_from_zero_keeps_its_precision():
    far = CUBE + [4e6, 5e6, 0.0]
    scene = luxel.Scene.from_arrays(far, INSIDE, luxel.Material("wall", 0.5, 1.0))
    np.testing.assert_allclose(scene.vertices + np.array(scene.origin), far, atol=1e-6)


@pytest.mark.parametrize("vertices, faces, words", [
    (CUBE[:, :2], INSIDE, r"vertices: expected an array of shape \(n, 3\), found \(8, 2\)"),
    (CUBE, INSIDE.astype(float), "faces: expected an array of integers"),
    (CUBE, INSIDE + 1, r"faces\[2\] is \[8, 7, 5\]"),
    (CUBE, -INSIDE, r"faces\[0\] is"),
    (CUBE, INSIDE[:0], "at least one triangle"),
    (np.where(CUBE == 1.0, np.nan, CUBE), INSIDE, r"vertices\[1\] is"),
])
def test_wrong_arrays_name_the_first_wrong_element(vertices, faces, words):
    with pytest.raises(luxel.InputError, match=words):
        luxel.Scene.from_arrays(vertices, faces)


@pytest.mark.parametrize("arguments, words", [
    ({"face_materials": [0] * 11}, "expected 12 indices or names"),
    ({"face_materials": [0] * 11 + [1]}, r"face_materials\[11\] is 1"),
    ({"face_materials": ["glass"] * 12}, "there is no material 'glass', but default"),
    ({"materials": []}, "at least one material"),
])
def test_wrong_materials_are_refused(arguments, words):
    with pytest.raises(luxel.InputError, match=words):
        luxel.Scene.from_arrays(CUBE, INSIDE, **arguments)
    with pytest.raises(luxel.InputError, match="reflectance: expected one number or three from 0 to 1, not 2"):
        luxel.Material("m", reflectance=2)


def test_a_million_patches_are_views_at_once():
    side = 708
    x, y = np.meshgrid(np.arange(side + 1.0), np.arange(side + 1.0))
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    corner = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    faces = np.concatenate([np.stack([corner, corner + 1, corner + side + 2], axis=1),
                            np.stack([corner, corner + side + 2, corner + side + 1], axis=1)])
    scene = luxel.Scene.from_arrays(vertices, faces)
    assert scene.faces.shape == (2 * side * side, 3)
    assert scene.faces.base is not None and np.shares_memory(scene.faces, scene.faces)
