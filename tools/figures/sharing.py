# SPDX-License-Identifier: Apache-2.0
"""The pictures of the page to share, as a headless browser takes them."""
import os
import shutil
import subprocess
import sys

from figures.scenes import CAMERA, ROOT, write_two_lamps

NAMES = [f"sharing-{name}.png" for name in ("light", "illuminance", "lamps", "walk", "phone", "phone-sheet", "phone-probe")]


def page(luxel, folder):
    """The box with two lamps."""
    solution, html = luxel.at("sharing.vtkhdf"), luxel.at("sharing.html")
    luxel.run("bake", write_two_lamps(luxel.place), "--store-transport", "--max-edge", luxel.choose(0.03, 0.2), "--error",
              luxel.choose("1.5%", "15%"), "-o", solution)
    luxel.run("export", solution, "--title", "Cornell box, two lamps", *CAMERA, "-o", html)
    node = shutil.which("node")
    if node is None:
        sys.exit("the page's pictures need Node.js: ./dev web installs it, with a browser")
    subprocess.run([node, os.path.join(ROOT, "tests", "web", "photographs.mjs"), html, folder], check=True)
    return {"bytes": os.path.getsize(html)}
