#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes scenes as a newcomer would, with no option: first_try.py FOLDER SCENE|FOLDER...

Each scene (.obj, .gltf, .glb, .ply, .stl, .fbx, .dae, .3ds; all of a folder and its subfolders) becomes a picture, a GLB
and an HTML page in FOLDER. Where Node.js and the packages of tests/web are there, three.js shows the GLB from the picture's camera with
its default settings, and the two pictures are compared. FOLDER/index.html is the contact sheet: look at every picture.
Prints a table in Markdown, one row per scene: CPU seconds of the whole process, triangles of the scene and of the GLB,
sizes, and the mean difference from three.js in per cent of the display's range; or the one sentence that refused it.

  first_try.py out/first_try scenes
  first_try.py out/first_try --width 480 --timeout 600 scenes/cornell-box.obj
"""
import argparse
import html
import json
import os
import re
import resource
import shutil
import struct
import subprocess
import sys
import time

ENDINGS = (".obj", ".gltf", ".glb", ".ply", ".stl", ".fbx", ".dae", ".3ds")
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WEB = os.path.join(ROOT, "tests", "web")


def scenes_in(paths):
    for path in paths:
        if os.path.isfile(path):
            yield path
        for folder, _, files in sorted(os.walk(path)):
            yield from (os.path.join(folder, f) for f in sorted(files) if f.lower().endswith(ENDINGS))


def name_of(scene, taken):
    """A file name for a scene's outputs, different from those of the others."""
    name = base = re.sub(r"[^A-Za-z0-9-]+", "-", os.path.splitext(os.path.basename(scene))[0]).strip("-") or "scene"
    number = 1
    while name in taken:
        number += 1
        name = f"{base}-{number}"
    taken.add(name)
    return name


def glb_triangles(path):
    """The number of triangles that a GLB draws."""
    with open(path, "rb") as file:
        _, _, _, length, _ = struct.unpack("<5I", file.read(20))
        document = json.loads(file.read(length))
    return sum(document["accessors"][p["indices"]]["count"] // 3 for m in document.get("meshes", ())
               for p in m["primitives"] if "indices" in p)


def bake(program, scene, folder, name, chosen):
    """The row of a scene."""
    outputs = [os.path.join(folder, name + ending) for ending in (".png", ".glb", ".html")]
    size = ["--width", str(chosen.width), "--height", str(chosen.width * 3 // 4)]
    command = [program, "bake", scene, *size, "--json", *(word for output in outputs for word in ("-o", output))]
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          encoding="utf-8", errors="replace") as child:
        try:
            text, messages = child.communicate(timeout=chosen.timeout)
        except subprocess.TimeoutExpired:
            child.terminate()
            text, messages = child.communicate()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    row = {"scene": scene, "name": name, "code": child.returncode, "messages": messages.strip(),
           "seconds": time.monotonic() - begin,
           "cpu_seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}
    if os.path.isfile(outputs[1]):
        report = json.loads(text) if text.startswith("{") else {}
        row |= {"report": report, "glb_triangles": glb_triangles(outputs[1]),
                "glb_bytes": os.path.getsize(outputs[1]), "page_bytes": os.path.getsize(outputs[2])}
    return row


def count_triangles(program, row):
    """Adds the number of triangles of the scene."""
    run = subprocess.run([program, "info", row["scene"], "--json"], stdin=subprocess.DEVNULL, capture_output=True,
                         text=True, check=False)
    if run.returncode == 0:
        row["triangles"] = json.loads(run.stdout)["triangles"]


def camera_words(row):
    """The camera of the picture as options of page.mjs, in glTF's axes: Y up."""
    camera = row["report"].get("camera")
    if not camera:
        return None
    turned = (lambda p: (p[0], p[2], -p[1])) if camera["up"][2] > 0.5 else tuple
    words = ["--fov", f"{camera['fov_degrees']:.6g}"]
    for key in ("eye", "target"):
        words.append(f"--{key}=" + ",".join(f"{x:.7g}" for x in turned(camera[key])))  # a minus may come first
    return words


def compare_in_browser(row, folder, width):
    """Adds the difference between three.js and the picture."""
    node, words = shutil.which("node"), camera_words(row)
    if not (node and words and os.path.isdir(os.path.join(WEB, "node_modules"))):
        return
    at = os.path.join(folder, row["name"])
    run = subprocess.run([node, os.path.join(WEB, "page.mjs"), at + ".glb", at + "-three.png", *words,
                          "--size", f"{width}x{width * 3 // 4}", "--like", at + ".png"],
                         capture_output=True, text=True, check=False)
    found = re.search(r"([\d.]+) %", run.stdout + run.stderr)
    row["difference"] = float(found[1]) if found else None


def print_row(row):
    def size(key):
        return f"{row[key] / 1e6:.2f}" if key in row else ""

    difference = f"{row['difference']:.2f} %" if row.get("difference") is not None else ""
    result = "baked" if row["code"] in (0, 3) else row["messages"].splitlines()[-1] if row["messages"] else row["code"]
    print(f"| {row['name']} | {row['cpu_seconds']:.1f} | {row.get('triangles', '')} | {row.get('glb_triangles', '')} | {size('glb_bytes')} | "
          f"{size('page_bytes')} | {difference} | {result} |", flush=True)


def write_sheet(rows, folder):
    figures = []
    for row in rows:
        pictures = "".join(f'<img src="{row["name"]}{end}" alt="">' for end in (".png", "-three.png")
                           if os.path.isfile(os.path.join(folder, row["name"] + end)))
        figures.append(f"<figure>{pictures}<figcaption><b>{html.escape(row['name'])}</b> "
                       f"<pre>{html.escape(row['messages'])}</pre></figcaption></figure>")
    with open(os.path.join(folder, "index.html"), "w", encoding="utf-8") as file:
        file.write("<!doctype html><meta charset=utf-8><title>First tries</title><style>body{font:13px sans-serif}"
                   "figure{display:inline-block;vertical-align:top;margin:6px;max-width:820px}img{width:400px}"
                   "pre{white-space:pre-wrap;font-size:11px}</style>" + "\n".join(figures))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="where the results are written")
    parser.add_argument("scenes", nargs="+", help="scene files, or folders of them")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bin/luxel"))
    parser.add_argument("--width", type=int, default=640, help="of the pictures, pixels; default: %(default)s")
    parser.add_argument("--timeout", type=float, default=1800, help="seconds per scene; default: %(default)s")
    chosen = parser.parse_args()
    os.makedirs(chosen.folder, exist_ok=True)
    print("| scene | CPU s | triangles | of the GLB | GLB, MB | page, MB | three.js differs by | result |")
    print("|---" * 8 + "|", flush=True)
    rows, taken = [], set()
    for scene in scenes_in(chosen.scenes):
        row = bake(chosen.program, scene, chosen.folder, name_of(scene, taken), chosen)
        if "report" in row:
            count_triangles(chosen.program, row)
            compare_in_browser(row, chosen.folder, chosen.width)
        print_row(row)
        rows.append(row)
        write_sheet(rows, chosen.folder)


if __name__ == "__main__":
    sys.exit(main())
