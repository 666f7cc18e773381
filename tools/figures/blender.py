# SPDX-License-Identifier: Apache-2.0
"""An office as Cycles renders it, and with Luxel's light in its vertex colours: the add-on at work in Blender."""
import os
import shutil
import subprocess
import sys

from figures.scenes import ROOT

NAMES = ["blender-cycles.png", "blender-luxel.png"]


def office(luxel, folder):
    blender = shutil.which("blender", path="/usr/bin")
    if blender is None:
        sys.exit("the add-on's pictures need Blender: apt-get install blender")
    # Blender looks for its Python's libraries by the PATH: another python3 on it would lead it astray.
    subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                    os.path.join(ROOT, "tests", "blender", "photographs.py"), "--",
                    os.path.abspath(os.path.join(luxel.programs, "luxel")), os.path.abspath(folder),
                    luxel.choose("full", "small")],
                   env={**os.environ, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"},
                   stdout=subprocess.DEVNULL, check=True)
    return {}
