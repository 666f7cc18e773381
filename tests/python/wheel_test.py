# SPDX-License-Identifier: Apache-2.0
"""The wheel: what pip builds from a checkout holds the package, and its list of files is right."""
import base64
import csv
import hashlib
import io
import os
import subprocess
import sys
import time
import zipfile

import pytest

import luxel
from conftest import SOURCES


@pytest.fixture(scope="module")
def build_wheel():
    if "LUXEL_BUILD" not in os.environ:
        pytest.skip("LUXEL_BUILD does not name the build folder")
    sys.path.insert(0, str(SOURCES / "python"))
    try:
        import build_backend
    finally:
        sys.path.pop(0)
    return lambda folder: folder / build_backend.build_wheel(folder)


@pytest.fixture(scope="module")
def wheel(build_wheel, tmp_path_factory):
    return build_wheel(tmp_path_factory.mktemp("wheel"))


def test_every_file_is_in_the_record(wheel):
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        record = next(name for name in names if name.endswith("RECORD"))
        rows = list(csv.reader(io.StringIO(archive.read(record).decode())))
        assert {row[0] for row in rows} == set(names)
        for path, digest, size in rows:
            if path == record:
                continue
            content = archive.read(path)
            assert digest == "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            assert int(size) == len(content)
    assert {"luxel/py.typed", "luxel/__init__.pyi", "luxel/__init__.py"} <= set(names)


def test_the_unpacked_package_runs(wheel, tmp_path):
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    code = "import luxel; print(luxel.__file__, luxel.__version__)"
    done = subprocess.run([sys.executable, "-B", "-c", code], env={"PYTHONPATH": str(tmp_path)}, check=True,
                          capture_output=True, text=True)
    assert done.stdout.split() == [str(tmp_path / "luxel" / "__init__.py"), luxel.__version__]


def test_the_same_build_gives_the_same_bytes(wheel, build_wheel, tmp_path, monkeypatch):
    a_day = 86400.0
    monkeypatch.setattr("time.time", lambda now=time.time(): now + a_day)
    assert build_wheel(tmp_path).read_bytes() == wheel.read_bytes()
