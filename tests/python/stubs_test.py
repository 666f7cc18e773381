# SPDX-License-Identifier: Apache-2.0
"""The stubs and the package have the same names and parameters, and every name is explained."""
import inspect
import pathlib
import subprocess
import sys

import pytest

import luxel

PACKAGE = pathlib.Path(luxel.__file__).resolve().parent


def test_stubs_are_those_of_the_package(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "mypy.ini").write_text("[mypy]\nignore_missing_imports = True\n", encoding="utf-8")
    (tmp_path / "private.txt").write_text("luxel\\._[a-z]+.*\n", encoding="utf-8")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "luxel", "--mypy-config-file", str(tmp_path / "mypy.ini"),
                           "--allowlist", str(tmp_path / "private.txt"), "--ignore-unused-allowlist"],
                          capture_output=True, text=True, check=False, cwd=tmp_path,
                          env={"PYTHONPATH": str(PACKAGE.parent), "MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"})
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_program_passes_mypy(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text("import luxel\n"
                       "solution = luxel.bake('room.obj', error='2%', max_edge=0.3, eye=(1.0, 2.0, 3.0))\n"
                       "mean: float = solution.mean('floor').value\n"
                       "picture = solution.render(width=320)\n"
                       "solution.plane(0.75).uniformity.low + mean\n", encoding="utf-8")
    run = [sys.executable, "-m", "mypy", "--strict", str(program)]
    env = {"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"}
    done = subprocess.run(run, capture_output=True, text=True, check=False, env=env, cwd=tmp_path)
    assert done.returncode == 0, done.stdout
    program.write_text("import luxel\nluxel.bake('room.obj', errors=1)\n", encoding="utf-8")
    done = subprocess.run(run, capture_output=True, text=True, check=False, env=env, cwd=tmp_path)
    assert 'Unexpected keyword argument "errors"' in done.stdout


def public_things():
    for name in luxel.__all__:
        thing = getattr(luxel, name)
        if not callable(thing):
            continue
        yield name, thing
        if inspect.isclass(thing):
            for inner, member in vars(thing).items():
                if not inner.startswith("_") and (callable(member) or isinstance(member, (property, staticmethod))):
                    yield f"{name}.{inner}", member


@pytest.mark.parametrize("name, thing", list(public_things()), ids=lambda x: x if isinstance(x, str) else "")
def test_every_name_is_explained(name, thing):
    assert inspect.getdoc(thing), f"luxel.{name} has no text"
