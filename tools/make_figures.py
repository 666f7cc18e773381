#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the figures of the documents: make_figures.py PROGRAMS FOLDER OUT [--small] [SECTION...], or --list.

Runs the luxel and luxel-bench in PROGRAMS, writes pictures and charts into FOLDER, and keeps what was measured in
OUT/figures.json and OUT/bench.json. A section whose figures were made with the same program, scene and tools is left as
it is. --small makes tiny ones that show only that it works; --list prints the names of the figures.
"""
import hashlib
import json
import os
import sys
import time

from figures import baking, blender, gallery, lightmap, measured, pictures, sharing, tutorials, viewer
from figures.runs import Luxel, keep_json
from figures.scenes import ROOT

# Section: who makes it, and the files it makes.
SECTIONS = {
    "steps": (pictures.jacobi_steps, [f"jacobi-step-{n}.png" for n in pictures.STEPS]),
    "patches": (pictures.too_few_patches, [f"patches-{mesh}-{look}.png" for mesh in pictures.MESHES
                                           for look in ("flat", "smooth")] + ["patches-none.png"]),
    "colour": (pictures.colour_noise, ["noise-shared.png", "noise-separate.png", "noise-separate-thrice.png",
                                        "noise.svg"]),
    "methods": (pictures.beside_path_tracing,
                ["method-path-traced.png", "method-gathered.png", "method-gathered-difference.png"] +
                [f"method-{method}{what}.png" for method in pictures.METHODS
                 for what in ("", "-difference", "-patches")]),
    "lightmap": (lightmap.lightmap, lightmap.NAMES),
    "viewer": (viewer.viewer, viewer.NAMES),
    "blender": (blender.office, blender.NAMES),
    "baking": (baking.forms, baking.NAMES),
    "sharing": (sharing.page, sharing.NAMES),
    "gallery": (gallery.gallery, gallery.NAMES),
    "artist": (tutorials.artist, tutorials.NAMES),
    "python": (tutorials.python_desk, ["python-desk.png"]),
    "error": (measured.error_against_time, ["error-of-methods.svg"]),
    "furnace": (measured.furnace, ["furnace.svg"]),
    "bench": (measured.bench, ["time-against-polygons.svg", "time-against-lamps.svg"]),
}


def stamp(programs, small):
    """Changes with the program, the scene and these tools."""
    tools = os.path.join(ROOT, "tools")
    files = [os.path.join(programs, "luxel"), os.path.join(programs, "luxel-scenes"), os.path.join(tools, "make_figures.py"),
             os.path.join(tools, "draw_charts.py")]
    files += [os.path.join(ROOT, "scenes", f"cornell-box.{ending}") for ending in ("obj", "mtl")]
    files += sorted(os.path.join(tools, "figures", name) for name in os.listdir(os.path.join(tools, "figures"))
                    if name.endswith(".py"))
    digest = hashlib.sha256(str(small).encode())
    for path in files:
        with open(path, "rb") as file:
            digest.update(file.read())
    return digest.hexdigest()


def read_kept(path):
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def main(words):
    if words == ["--list"]:
        print("\n".join(name for _, names in SECTIONS.values() for name in names))
        return
    small = "--small" in words
    words = [w for w in words if w != "--small"]
    asked = words[3:] or list(SECTIONS)
    if len(words) < 3 or not set(asked) <= set(SECTIONS):
        sys.exit(f"{__doc__}\nsections: {' '.join(SECTIONS)}")
    programs, folder, out = (os.path.abspath(w) for w in words[:3])
    luxel = Luxel(programs, os.path.join(out, "figures"), small)
    os.makedirs(folder, exist_ok=True)
    kept_in = os.path.join(out, "figures.json")
    kept, now = read_kept(kept_in), stamp(programs, small)
    for section in asked:
        make, names = SECTIONS[section]
        there = all(os.path.exists(os.path.join(folder, name)) for name in names)
        if there and kept.get(section, {}).get("stamp") == now:
            continue
        begin = time.monotonic()
        kept[section] = {"measured": make(luxel, folder), "stamp": now}
        keep_json(kept_in, kept)
        print(f"    {section}: {len(names)} figures, {time.monotonic() - begin:.0f} s", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
