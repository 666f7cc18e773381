# SPDX-License-Identifier: Apache-2.0
"""page_test.py LUXEL NODE desk|phone|glb: what Luxel writes for browsers, in a browser.

desk, phone: makes a page, and has a browser click through it and compare it with Luxel's pictures. glb: exports a GLB for
each program and in each form of light, validates them, and compares what three.js shows with Luxel's picture. Ends with 77,
and a line that says why, where there is no browser, no npm package, or no page.
Pictures stay in LUXEL_PAGE_PICTURES where that names a folder.
"""
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tools"))

from figures.scenes import CAMERA, write_two_lamps  # noqa: E402

VIEW = (*CAMERA, "--width", "640", "--height", "480")
PROGRAMS = ("any", "three", "babylon", "godot", "blender", "unity", "unreal")
FORMS = ("vertex", "lightmap", "emissive")
TITLE = "Two lamps </script> & <b>"
# Name: what Luxel does, and what the page is told.
PICTURES = {
    "plain": (["render"], ""),
    "clamp": (["render", "--tone", "clamp", "--exposure", "1"], "op=clamp&exposure=1"),
    "maximum": (["render", "--tone", "maximum", "--exposure", "3"], "op=maximum&exposure=3"),
    "white": (["render", "--tone", "reinhard", "--white", "3", "--exposure", "1"], "op=reinhard&white=3&exposure=1"),
    "relit": (["relight", "--light", "lamp=0.3", "--tint", "side=1,0.3,0.1"], "lamps=0.3,0.3,0.3;1,0.3,0.1"),
}


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def what_is_missing(node):
    browser = os.environ.get("CHROMIUM", "/usr/bin/chromium")
    if not os.path.exists(node):
        return "there is no Node.js"
    if not os.path.exists(browser):
        return f"there is no {browser}: apt-get install chromium"
    if not os.path.isdir(os.path.join(HERE, "node_modules", "playwright-core")):
        return "npm's packages are not there: npm --prefix tests/web install --no-package-lock"
    return None


class Place:
    """A folder with a small solution, box.vtkhdf."""

    def __init__(self, luxel, folder):
        self.luxel, self.folder = luxel, folder
        self.scene = write_two_lamps(folder)
        self.run("bake", self.scene, "--max-edge", "0.08", "--error", "5%", "--store-transport", "-o", "box.vtkhdf")

    def at(self, name):
        return os.path.join(self.folder, name)

    def run(self, *words):
        done = subprocess.run([self.luxel, *words, "--quiet"], cwd=self.folder, capture_output=True, text=True, check=False)
        if "built without its page" in done.stderr:
            skip(done.stderr.strip())
        assert done.returncode == 0, f"luxel {' '.join(words)}: {done.stderr}"


def click_through(place, node, screen, photographs):
    page = ("export", "box.vtkhdf", "--title", TITLE, *CAMERA)
    place.run(*page, "-o", "box.html")
    place.run(*page, "-o", "again.html", "--threads", "1")
    with open(place.at("box.html"), "rb") as a, open(place.at("again.html"), "rb") as b:
        assert a.read() == b.read(), "the page is not the same on one thread"
    pictures = []
    if screen == "desk":
        for name, (words, address) in PICTURES.items():
            place.run(words[0], "box.vtkhdf", *words[1:], *VIEW, "-o", f"{name}.png")
            pictures += [f"{name}={address}"]
    return [node, os.path.join(HERE, "page_clicks.mjs"), screen, place.folder, photographs, TITLE, *pictures]


def show_glb(place, node, photographs):
    """Each program's file, and the light in each of its forms on the scene's own file, is valid; three.js shows the picture."""
    look = ("--tone", "clamp", "--exposure", "1")
    files = {program: ("--for", program) for program in PROGRAMS}
    for form in FORMS:
        files[form] = ("--scene", place.scene, "--as", form)
    for name in FORMS[1:]:
        files[name] += ("--final-gather", "none", "--texels-per-metre", "200")
    for name, words in files.items():
        place.run("export", "box.vtkhdf", *words, *look, "-o", f"{name}.glb")
    subprocess.run([node, os.path.join(HERE, "validate.mjs"), *(place.at(f"{name}.glb") for name in files)], check=True)
    place.run("render", "box.vtkhdf", *look, *VIEW, "-o", "clamp.png")
    status = 0
    for name in ("three", *FORMS):
        words = [node, os.path.join(HERE, "page.mjs"), place.at(f"{name}.glb"), os.path.join(photographs, f"{name}.png"),
                 *CAMERA, "--size", "640x480", "--like", place.at("clamp.png")]
        status |= subprocess.run(words, check=False).returncode
    return status


def main(luxel, node, what):
    missing = what_is_missing(node)
    if missing:
        skip(missing)
    with tempfile.TemporaryDirectory() as folder:
        place = Place(luxel, folder)
        photographs = os.environ.get("LUXEL_PAGE_PICTURES") or place.at("photographs")
        os.makedirs(photographs, exist_ok=True)
        if what == "glb":
            return show_glb(place, node, photographs)
        words = click_through(place, node, what, photographs)
        return subprocess.run(words, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
