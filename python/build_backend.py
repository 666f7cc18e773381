# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel of the Python package with CMake: the backend that pyproject.toml names (PEP 517).

LUXEL_BUILD names a build folder that is configured with LUXEL_PYTHON already; else build/wheel is used, and kept.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
OPTIONS = {"CMAKE_BUILD_TYPE": "Release", "LUXEL_PYTHON": "ON", "LUXEL_UNITY": "ON", "LUXEL_PROGRAM": "OFF",
           "LUXEL_VIEWER": "OFF", "LUXEL_EXAMPLES": "OFF", "LUXEL_TESTS": "OFF", "LUXEL_BENCH": "OFF", "LUXEL_INSTALL": "OFF",
           "LUXEL_WERROR": "OFF", "LUXEL_MPI": "OFF"}


def version():
    """The version of the sources."""
    text = (ROOT / "include/luxel/version.h").read_text(encoding="utf-8")
    return ".".join(re.search(rf"LUXEL_VERSION_{part} (\d+)", text)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def _built():
    """A build folder with the extension."""
    given = os.environ.get("LUXEL_BUILD")
    folder = pathlib.Path(given) if given else ROOT / "build" / "wheel"
    if not given:
        options = [f"-D{name}={value}" for name, value in OPTIONS.items()] + [f"-DPython_EXECUTABLE={sys.executable}"]
        if shutil.which("ninja"):
            options += ["-G", "Ninja"]
        if shutil.which("ccache"):
            options += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), *options], check=True)
    subprocess.run(["cmake", "--build", str(folder), "--target", "luxel_python", "--parallel"], check=True)
    return folder


def _metadata():
    return (f"Metadata-Version: 2.1\nName: luxel\nVersion: {version()}\n"
            "Summary: Global illumination of diffuse scenes by the radiosity method\nLicense: Apache-2.0\n"
            "Requires-Python: >=3.11\nRequires-Dist: numpy>=1.24\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes the metadata, which needs no build, and returns the name of its folder."""
    info = pathlib.Path(metadata_directory) / f"luxel-{version()}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(_metadata(), encoding="utf-8")
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel and returns its name."""
    folder = _built()
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    name = f"luxel-{version()}-{tag}-{tag}-{platform}.whl"
    info = f"luxel-{version()}.dist-info"
    files = {f"luxel/{path.name}": path.read_bytes() for path in sorted((folder / "python" / "luxel").iterdir())
             if path.is_file()}
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: luxel\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}-{tag}-{platform}\n").encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = ""
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w") as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path)  # dated 1980, so that the same build gives the same bytes
            entry.external_attr = 0o644 << 16
            wheel.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Writes the sources that git tracks, and returns the name of the archive."""
    base = f"luxel-{version()}"
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-z"], check=True, capture_output=True).stdout.decode()
    with tempfile.TemporaryDirectory() as temporary, \
            tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        for path in filter(None, listed.split("\0")):
            archive.add(ROOT / path, f"{base}/{path}")
        info = pathlib.Path(temporary) / "PKG-INFO"
        info.write_text(_metadata(), encoding="utf-8")
        archive.add(info, f"{base}/PKG-INFO")
    return f"{base}.tar.gz"
