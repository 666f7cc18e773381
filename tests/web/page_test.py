# SPDX-License-Identifier: Apache-2.0
"""page_test.py LUXEL NODE desk|phone|luminaires|report|glb|babylon|blender: what Luxel writes for other programs, in these.

desk, phone: makes a page, and has a browser click through it and compare it with Luxel's pictures. luminaires: the same of a
room with luminaires. report: opens the report of a lighting design on a phone, on a desk and on paper. glb: exports a GLB for
each program and in each form of light, validates them, and compares what three.js shows with Luxel's picture; babylon and
blender compare what these programs show. Ends with 77, and a line that says why, where there is no browser, no npm
package, no Blender, or no page.
Pictures stay in LUXEL_PAGE_PICTURES where that names a folder.
"""
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

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


# A room with a chequered floor, a screen with holes before a lamp, and a window to the sky.
TEXTURED = """mtllib textured.mtl
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 2 -1
v 1 2 -1
v 1 2 1
v -1 2 1
v -0.8 0.2 -0.4
v 0.4 0.2 -0.4
v 0.4 1.6 -0.4
v -0.8 1.6 -0.4
vt 0 0
vt 3 0
vt 3 2
vt 0 2
usemtl floor
f 1/1 4/4 3/3 2/2
usemtl wall
f 1 2 6 5
f 1 5 8 4
f 5 6 7 8
usemtl screen
f 9/1 10/2 11/3 12/4
"""
TEXTURED_MATERIALS = """newmtl floor
Kd 0.9 0.9 0.9
map_Kd chequer.png
newmtl wall
Kd 0.6 0.6 0.6
newmtl screen
Kd 0.7 0.5 0.3
map_d holes.png
"""


def write_png(path, width, height, colour):
    """colour(x, y): red, green, blue, alpha."""
    rows = b"".join(b"\0" + b"".join(bytes(colour(x, y)) for x in range(width)) for y in range(height))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


def write_textured(folder):
    with open(os.path.join(folder, "textured.obj"), "w", encoding="ascii") as file:
        file.write(TEXTURED)
    with open(os.path.join(folder, "textured.mtl"), "w", encoding="ascii") as file:
        file.write(TEXTURED_MATERIALS)
    write_png(os.path.join(folder, "chequer.png"), 64, 64,
              lambda x, y: (230, 90, 40, 255) if (x // 32 + y // 32) % 2 else (240, 240, 250, 255))
    write_png(os.path.join(folder, "holes.png"), 64, 64,
              lambda x, y: (255, 255, 255, 0 if (x - 32) ** 2 + (y - 32) ** 2 < 400 else 255))
    return os.path.join(folder, "textured.obj")


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

    def can(self, *words):
        """Whether this build can: it may lack an optional library."""
        return subprocess.run([self.luxel, *words, "--quiet"], cwd=self.folder, capture_output=True, check=False).returncode == 0


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
        view = ("--eye", "0.5,1.2,3.4", "--target", "-0.1,0.8,0", "--fov", "42")
        place.run("bake", write_textured(place.folder), "--sky", "1", "--max-edge", "0.25", "--error", "8%", "-o", "textured.vtkhdf")
        place.run("export", "textured.vtkhdf", *view, "-o", "textured.html")
        place.run("render", "textured.vtkhdf", *view, "--width", "640", "--height", "480", "-o", "textured.png")
    return [node, os.path.join(HERE, "page_clicks.mjs"), screen, place.folder, photographs, TITLE, *pictures]


LUMINAIRES = """file,x,y,z,group
led-panel.ies,1.5,2,2.795,panel
linear-pendant.ies,4,2,2,pendant
"""


def bake_luminaires(place):
    for name in ("led-panel.ies", "linear-pendant.ies"):
        shutil.copy(os.path.join(ROOT, "scenes", "luminaires", name), place.at(name))
    with open(place.at("list.csv"), "w", encoding="ascii") as file:
        file.write(LUMINAIRES)
    subprocess.run([place.luxel, "room", "6x4x2.8", "-o", "room.obj"], cwd=place.folder, capture_output=True, check=True)
    place.run("bake", "room.obj", "--luminaires", "list.csv", "--max-edge", "0.4", "--mesh-error", "none", "--error", "8%",
              "--store-transport", "-o", "room.vtkhdf")


def show_report(place, node, photographs):
    bake_luminaires(place)
    place.run("report", "room.vtkhdf", "--require-mean", "300", "--require-uniformity", "0.6", "--require-ugr", "19", "-o", "report.html")
    return subprocess.run([node, os.path.join(HERE, "report.mjs"), place.folder, photographs], check=False).returncode


def show_luminaires(place, node, photographs):
    bake_luminaires(place)
    view = ("--eye", "3,0.3,1.2", "--target", "3,2.5,2.3", "--fov", "80")
    place.run("export", "room.vtkhdf", *view, "-o", "luminaires.html")
    size = ("--width", "640", "--height", "480")
    dark = ("--tone", "clamp", "--exposure", "-6")
    place.run("render", "room.vtkhdf", *view, *size, "-o", "luminaires-plain.png")
    place.run("render", "room.vtkhdf", *view, *size, *dark, "-o", "luminaires-dark.png")
    place.run("relight", "room.vtkhdf", "--light", "panel=0.5", "--off", "pendant", *view, *size, *dark, "-o", "luminaires-relit.png")
    words = [node, os.path.join(HERE, "page_luminaires.mjs"), place.folder, photographs]
    return subprocess.run(words, check=False).returncode


def show_glb(place, node, photographs):
    """Each program's file, and the light in each of its forms on the scene's own file, is valid; three.js shows the picture.
    So are the plain and the compressed ones."""
    look = ("--tone", "clamp", "--exposure", "1")
    files = {program: ("--for", program) for program in PROGRAMS}
    for form in FORMS:
        files[form] = ("--scene", place.scene, "--as", form)
    for name in FORMS[1:]:
        files[name] += ("--final-gather", "none", "--texels-per-metre", "200")
    for name in ("three", *FORMS):
        files[f"{name}-plain"] = (*files[name], "--compress", "none")
        if place.can("export", "box.vtkhdf", "--compress", "meshopt", "-o", "compressed.glb"):
            files[f"{name}-meshopt"] = (*files[name], "--compress", "meshopt")
    for name, words in files.items():
        place.run("export", "box.vtkhdf", *words, *look, "-o", f"{name}.glb")
    subprocess.run([node, os.path.join(HERE, "validate.mjs"), *(place.at(f"{name}.glb") for name in files)], check=True)
    place.run("render", "box.vtkhdf", *look, *VIEW, "-o", "clamp.png")
    status = 0
    for name in (n for n in files if n.startswith(("three", *FORMS))):
        words = [node, os.path.join(HERE, "page.mjs"), place.at(f"{name}.glb"), os.path.join(photographs, f"{name}.png"),
                 *CAMERA, "--size", "640x480", "--like", place.at("clamp.png")]
        status |= subprocess.run(words, check=False).returncode
    return status


def view_words():
    """The values of --eye, --target and --fov."""
    return [CAMERA[CAMERA.index(f"--{name}") + 1] for name in ("eye", "target", "fov")]


def show_in_babylon(place, node, photographs):
    """Babylon.js shows the file for it, and the one for any program, as Luxel's default picture does; and lightmaps and
    emissive textures, whose light has no tone curve, as one without it."""
    look = ("--tone", "clamp", "--exposure", "1")
    place.run("render", "box.vtkhdf", *VIEW, "-o", "default.png")
    place.run("render", "box.vtkhdf", *look, *VIEW, "-o", "clamp.png")
    files = {program: (("--for", program, *CAMERA), "default.png") for program in ("babylon", "any")}
    for form in FORMS[1:]:
        words = ("--scene", place.scene, "--as", form, "--final-gather", "none", "--texels-per-metre", "200", *look)
        files[form] = (words, "clamp.png")
    status = 0
    for name, (words, like) in files.items():
        place.run("export", "box.vtkhdf", *words, "-o", f"{name}.glb")
        words = [node, os.path.join(HERE, "page.mjs"), place.at(f"{name}.glb"),
                 os.path.join(photographs, f"{name}-babylon.png"), "--with", "babylon",
                 *(f"--{option}={value}" for option, value in zip(("eye", "target", "fov"), view_words())),
                 "--size", "640x480", "--like", place.at(like)]
        status |= subprocess.run(words, check=False).returncode
    return status


def show_in_blender(place, photographs):
    blender = shutil.which("blender", path="/usr/bin")
    if blender is None:
        skip("there is no Blender: apt-get install blender")
    place.run("render", "box.vtkhdf", *VIEW, "-o", "default.png")
    jobs = []
    for program in ("blender", "any"):
        place.run("export", "box.vtkhdf", "--for", program, *CAMERA, "-o", f"{program}.glb")
        jobs.append(f"{os.path.join(photographs, program + '-blender.png')}={place.at(program + '.glb')}")
    # Blender looks for its Python's libraries by the PATH: another python3 on it would lead it astray.
    done = subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                           os.path.join(HERE, "in_blender.py"), "--", place.at("default.png"), "640", "480",
                           *view_words(), *jobs],
                          env={**os.environ, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"},
                          capture_output=True, text=True, check=False)
    found = re.findall(r"^.*/(\w+).glb: ([\d.]+) % from .*, ([\d.]+) covered$", done.stdout, re.MULTILINE)
    # Sheets may be shown from behind, unless the file is for Blender.
    limits = {"blender": 0.5, "any": 3.0}
    print("\n".join(line for line in done.stdout.splitlines() if " % from " in line))
    if len(found) != len(jobs):
        print(done.stdout, done.stderr)
    return 0 if len(found) == len(jobs) and all(float(d) < limits[name] and float(c) > 0.3 for name, d, c in found) else 1


def main(luxel, node, what):
    missing = what_is_missing(node) if what != "blender" else None
    if what == "babylon" and not missing and not os.path.isdir(os.path.join(HERE, "node_modules", "babylonjs")):
        missing = "npm's packages of Babylon.js are not there: ./dev matrix programs"
    if missing:
        skip(missing)
    with tempfile.TemporaryDirectory() as folder:
        place = Place(luxel, folder)
        photographs = os.environ.get("LUXEL_PAGE_PICTURES") or place.at("photographs")
        os.makedirs(photographs, exist_ok=True)
        if what == "luminaires":
            return show_luminaires(place, node, photographs)
        if what == "report":
            return show_report(place, node, photographs)
        if what == "glb":
            return show_glb(place, node, photographs)
        if what == "babylon":
            return show_in_babylon(place, node, photographs)
        if what == "blender":
            return show_in_blender(place, photographs)
        words = click_through(place, node, what, photographs)
        return subprocess.run(words, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
