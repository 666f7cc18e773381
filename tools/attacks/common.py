# SPDX-License-Identifier: Apache-2.0
"""Parts common to the attacks of ../soak.py."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
STATE = ROOT / "build" / "soak"
CORES = len(os.sched_getaffinity(0))


class Finding(Exception):
    """A finding of an attack, as a sentence."""


def run(command, folder, **options):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", **options)


def folder_of_box(prefix):
    """A new folder with the Cornell box in it."""
    folder = Path(tempfile.mkdtemp(prefix=prefix, dir=STATE))
    for name in ("cornell-box.obj", "cornell-box.mtl"):
        shutil.copy(ROOT / "scenes" / name, folder)
    return folder
