# SPDX-License-Identifier: Apache-2.0
"""Exceptions: kinds, file and line, hints as Python arguments."""
import pickle

import pytest

import luxel
from conftest import furnace


def test_missing_file(tmp_path):
    path = tmp_path / "none.obj"
    with pytest.raises(luxel.InputError, match="no such file") as raised:
        luxel.bake(path)
    assert raised.value.file == str(path) and raised.value.line is None
    assert isinstance(raised.value, (luxel.Error, ValueError))


def test_wrong_line_of_a_file(tmp_path):
    path = tmp_path / "wrong.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 zero\nf 1 2 3\n", encoding="utf-8")
    with pytest.raises(luxel.InputError) as raised:
        luxel.load_scene(str(path))
    assert (raised.value.file, raised.value.line) == (str(path), 3)


def test_wrong_values_name_the_argument(box_file):
    with pytest.raises(luxel.InputError, match="^error: expected a fraction below 1"):
        luxel.bake(box_file, error=7)
    with pytest.raises(luxel.InputError, match="^max_edge: expected auto, 0"):
        luxel.bake(box_file, max_edge=-1)
    with pytest.raises(luxel.InputError, match="tolerance needs method .* and has no effect with method sampled"):
        luxel.bake(box_file, tolerance=0.1)
    with pytest.raises(luxel.InputError, match="threads: expected a number"):
        luxel.bake(box_file, threads=-1)


def test_unknown_arguments_are_type_errors_with_the_nearest_name(box_file):
    with pytest.raises(TypeError, match="no argument 'max_edges'; did you mean 'max_edge'"):
        luxel.bake(box_file, max_edges=1)
    with pytest.raises(TypeError, match="no argument 'output'"):
        luxel.bake(box_file, output="a.glb")
    with pytest.raises(TypeError, match="expected a path or a Scene"):
        luxel.bake(3)
    with pytest.raises(TypeError, match="progress: expected a function"):
        luxel.bake(box_file, progress=1)
    with pytest.raises(TypeError, match="^eye: expected text, a number"):
        luxel.bake(box_file, eye=object())


def test_options_of_the_scene_belong_to_the_scene():
    with pytest.raises(luxel.InputError, match="sky: give it to load_scene"):
        luxel.bake(furnace(), sky=1.0)


def test_hints_are_python_arguments(box_file):
    with pytest.raises(luxel.InputError) as raised:
        luxel.bake(box_file, focus="nothing like this")
    assert "--" not in str(raised.value)
    dark = luxel.Scene.from_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]], [[0, 1, 2]], sky="none")
    with pytest.raises(luxel.InputError) as raised:
        luxel.bake(dark)
    assert ("sky", None) in [(name, None) for name, _ in raised.value.hints]
    assert "sky=" in str(raised.value) and "--" not in str(raised.value)


def test_other_files_are_no_solutions(tmp_path, box, box_file):
    with pytest.raises(luxel.FormatError) as raised:
        luxel.load(box_file)
    assert raised.value.file == str(box_file)
    with pytest.raises(luxel.InputError, match="no such file"):
        luxel.load(tmp_path / "none.vtkhdf")
    with pytest.raises(luxel.InputError, match="extension .vtkhdf"):
        box.save(tmp_path / "box.glb")
    with pytest.raises(luxel.DeviceError):
        box.save(tmp_path / "no folder" / "box.vtkhdf")


def test_files_that_cannot_be_written_are_named(box, tmp_path):
    for name, write in (("box.vtkhdf", box.save), ("box.png", box.write), ("box.glb", box.write)):
        path = tmp_path / "no folder: none" / name
        with pytest.raises(luxel.DeviceError, match="does not exist") as raised:
            write(path)
        assert (raised.value.file, raised.value.line) == (str(path), None)


def test_any_name_of_a_file_and_its_line_are_found(tmp_path):
    for name in ("no extension", "colon: inside.obj", "12: 34.obj"):
        path = tmp_path / name
        path.write_text("v 0 0 0\nv 1 0 zero\n", encoding="utf-8")
        with pytest.raises(luxel.InputError) as raised:
            luxel.load_scene(path)
        assert raised.value.file == str(path)
        assert raised.value.line == (2 if name.endswith(".obj") else None)


def test_errors_can_be_pickled():
    for kind in (luxel.InputError, luxel.DeviceError):
        error = kind("a.obj:3: expected a number", [("scale", "0.01")], "a.obj", 3)
        copy = pickle.loads(pickle.dumps(error))
        assert (str(copy), copy.file, copy.line) == (str(error), "a.obj", 3)
        assert copy.hints == error.hints


def test_a_sentence_alone_has_no_file():
    error = luxel.Error("room.obj:3: wrong")
    assert error.file is None and error.line is None
