# SPDX-License-Identifier: Apache-2.0
"""The gallery: a picture of each scene of luxel-scenes, by the commands that docs/gallery.md has."""
import os
import re
import subprocess
import sys

from figures.scenes import ROOT

PAGE = os.path.join(ROOT, "docs", "gallery.md")
# A scene's command in the page: its name, and what stands between the file of the scene and -o.
COMMAND = re.compile(r"^luxel bake out/([a-z-]+)\.(?:obj|glb) (.*?) ?-o out/\1\.png$", re.MULTILINE)


def commands():
    """(scene, file, options) of each picture, as the page has them."""
    with open(PAGE, encoding="utf-8") as file:
        text = file.read()
    return [(match[1], match[0].split()[2], match[2].split()) for match in COMMAND.finditer(text)]


NAMES = [f"gallery-{name}.png" for name, _, _ in commands()]


def gallery(luxel, folder):
    """Writes the scenes and bakes them; returns the CPU seconds of each."""
    measured = {}
    for name, file, options in commands():
        scene = luxel.at(os.path.basename(file))
        write = [os.path.join(luxel.programs, "luxel-scenes"), name, scene]
        done = subprocess.run(write, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{' '.join(write)}\ngave {done.returncode}\n{done.stderr}")
        small = ("--quality", "draft", "--width", 40, "--height", 30) if luxel.small else ()
        report = luxel.run("bake", scene, *options, *small, "-o", os.path.join(folder, f"gallery-{name}.png"))
        measured[name] = {"cpu_seconds": report["cpu_seconds"], "patches": report["solution"]["patches"]}
    return measured
