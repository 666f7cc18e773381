# SPDX-License-Identifier: Apache-2.0
"""The pictures of the page about other programs: the box in three.js, its light in each form."""
import os
import shutil
import subprocess
import sys

from figures.scenes import BOX, CAMERA, ROOT

# Name: the words that ask for it.
FORMS = {"vertex": (), "own-triangles": ("--preserve-topology",), "lightmap": ("--as", "lightmap"), "emissive": ("--as", "emissive")}
NAMES = [f"baking-{name}.png" for name in FORMS]


def forms(luxel, folder):
    """Each form on the scene's own file, as three.js shows it."""
    node = shutil.which("node")
    if node is None:
        sys.exit("the pictures of three.js need Node.js: ./dev web installs it, with a browser")
    solution = luxel.at("baking.vtkhdf")
    luxel.run("bake", BOX, "--max-edge", luxel.choose(0.02, 0.2), "--error", luxel.choose("2%", "15%"), "-o", solution)
    bytes_of = {}
    for name, words in FORMS.items():
        glb = luxel.at(f"baking-{name}.glb")
        if luxel.small and "--as" in words:
            words = (*words, "--final-gather", "none", "--texels-per-metre", "40")
        luxel.run("export", solution, "--scene", BOX, *words, "--tone", "clamp", "--exposure", "1", "-o", glb)
        subprocess.run([node, os.path.join(ROOT, "tests", "web", "page.mjs"), glb, os.path.join(folder, f"baking-{name}.png"),
                        *CAMERA, "--size", "480x480"], check=True)
        bytes_of[name] = os.path.getsize(glb)
    return bytes_of
