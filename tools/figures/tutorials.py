# SPDX-License-Identifier: Apache-2.0
"""The pictures of the tutorials: what the commands and the programs of a page write, in their order."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from check_docs_commands import commands_of
from figures.scenes import ROOT

# Figure: the file that the commands of docs/tutorial-artist.md write.
ARTIST = {"artist-first.png": "study.png", "artist-bright.png": "bright.png", "artist-desk.png": "desk.png",
          "artist-lightmap.png": "lightmap.png", "artist-page.png": "light.png", "artist-evening.png": "evening.png"}
NAMES = list(ARTIST)

PYTHON_BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def python_desk(luxel, folder):
    """The picture that the Python program of docs/tutorial-python.md writes."""
    with open(os.path.join(ROOT, "docs", "tutorial-python.md"), encoding="utf-8") as file:
        program = "\n".join(PYTHON_BLOCK.findall(file.read()))
    if luxel.small:
        program = program.replace("width=640, height=480", "width=40, height=30")
    environment = dict(os.environ, PYTHONPATH=os.path.join(os.path.dirname(luxel.programs), "python"))
    with tempfile.TemporaryDirectory() as place:
        done = subprocess.run(["/usr/bin/python3", "-c", program], cwd=place, env=environment, capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            sys.exit(f"docs/tutorial-python.md: its program failed\n{done.stderr}")
        shutil.copyfile(os.path.join(place, "desk.png"), os.path.join(folder, "python-desk.png"))
    return {"printed": done.stdout.splitlines()}


def artist(luxel, folder):
    """Runs the page's commands where they find the scenes, and keeps their pictures."""
    with open(os.path.join(ROOT, "docs", "tutorial-artist.md"), encoding="utf-8") as file:
        commands = [command for _, command in commands_of(file.read())]
    environment = dict(os.environ, PATH=luxel.programs + os.pathsep + os.environ["PATH"])
    with tempfile.TemporaryDirectory() as place:
        shutil.copytree(os.path.join(ROOT, "scenes"), os.path.join(place, "scenes"))
        for command in commands:
            if luxel.small:
                command = command.replace("--width 480 --height 360", "--width 40 --height 30").replace("draft", "draft --rays 1k")
            done = subprocess.run(command, shell=True, cwd=place, env=environment, stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, check=False)
            if done.returncode not in (0, 3):  # 3: stopped by --rays
                sys.exit(f"{command}\ngave {done.returncode}\n{done.stderr}")
        for name, written in ARTIST.items():
            shutil.copyfile(os.path.join(place, written), os.path.join(folder, name))
    return {"commands": commands}
