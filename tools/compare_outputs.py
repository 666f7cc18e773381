#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the output files of two builds of luxel, byte for byte: compare_outputs.py OLD NEW [SCENE...].

OLD and NEW are programs. Both run the same commands on the scenes (default: those of scenes/). Pictures and PLY files
must have the same bytes; GLB files the same buffers; solution files the same numeric data sets, after the renames in
RENAMED. Text (provenance, JSON, names) may differ. Prints each difference; exit status: 1 if there is one.
Needs Debian's python3-h5py.
"""
import json
import os
import struct
import subprocess
import sys
import tempfile

import h5py
import numpy

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
SCENES = [os.path.join(ROOT, "scenes", name) for name in ("cornell-box.obj",)]
# Data sets of format version 1 and their names in version 2, without their paths.
RENAMED = {"sharing_bias_front": "smoothing_bias_front", "sharing_bias_back": "smoothing_bias_back",
           "reflectance_share": "reflectance_ratio", "emittance_share": "emittance_ratio", "slot": "receiver"}
# Options of the old program and their names in the new one.
OPTIONS = {"--share": "--smoothing", "--keep-transport": "--store-transport", "--page": "--page-size"}

# Name of a case, and its commands; SCENE and OUT are replaced.
CASES = [
    ("bake", ["bake SCENE --error 5% -o OUT.vtkhdf -o OUT.png -o OUT.exr -o OUT.hdr -o OUT.ply -o OUT.glb"]),
    ("one way", ["bake SCENE --error 10% --both-ways off --share off -o OUT.vtkhdf"]),
    ("power, sky", ["bake SCENE --error 5% --error-measure power --sky 0.5 -o OUT.vtkhdf"]),
    ("refined", ["bake SCENE --error 10% --mesh-error 5% -o OUT.vtkhdf"]),
    ("transport", ["bake SCENE --error 10% --keep-transport -o OUT.vtkhdf",
                   "relight OUT.vtkhdf --reflectance *=0.5 -o OUT-relit.vtkhdf",
                   "resume OUT.vtkhdf --error 5% -o OUT-resumed.vtkhdf"]),
    ("merged", ["bake SCENE --error 10% -o OUT-1.vtkhdf", "bake SCENE --error 10% --seed 2 -o OUT-2.vtkhdf",
                "merge OUT-1.vtkhdf OUT-2.vtkhdf -o OUT.vtkhdf"]),
    ("pages", ["bake SCENE --error 10% -o OUT.vtkhdf", "lightmap OUT.vtkhdf --page 256 -o OUT.exr",
               "render OUT.vtkhdf -o OUT-picture.png", "export OUT.vtkhdf --as lightmap -o OUT.glb"]),
    ("shooting", ["bake SCENE --method shooting --rays 500k -o OUT.vtkhdf"]),
    ("hemicube", ["bake SCENE --method hemicube --max-edge 1 -o OUT.vtkhdf"]),
    ("dense", ["bake SCENE --method dense --max-edge 1.5 -o OUT.vtkhdf"]),
    ("lines", ["bake SCENE --method lines --max-edge 1 -o OUT.vtkhdf"]),
    ("view factors", ["viewfactors SCENE --between materials -o OUT.h5"]),
    ("reference", ["reference SCENE --max-edge 1 --error 20% -o OUT.vtkhdf"]),
]


def run(program, commands, scene, folder, is_new):
    """The files that commands write, by name."""
    os.makedirs(folder)
    for command in commands:
        words = [word.replace("SCENE", scene).replace("OUT", os.path.join(folder, "out")) for word in command.split()]
        if is_new:
            words = [OPTIONS.get(word, word) for word in words]
        result = subprocess.run([program, *words], capture_output=True, text=True)
        if result.returncode != 0:
            return {"error": (result.stderr or result.stdout).strip().splitlines()[-1:]}
    return {name: os.path.join(folder, name) for name in sorted(os.listdir(folder))}


def glb_buffers(path):
    """The binary part of a GLB, and the shape of its accessors."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    shapes = [{key: accessor[key] for key in ("componentType", "count", "type")} for accessor in document["accessors"]]
    return data[20 + length:], shapes


def numeric(path):
    """The numeric data sets of a solution file."""
    sets = {}
    with h5py.File(path) as file:
        def add(name, item):
            if isinstance(item, h5py.Dataset) and numpy.issubdtype(item.dtype, numpy.number):
                sets[name] = item[()]
        file.visititems(add)
    return sets


def renamed(name):
    path, _, last = name.rpartition("/")
    return f"{path}/{RENAMED.get(last, last)}" if path else last


def difference_of_solutions(old, new):
    old = {renamed(name): value for name, value in numeric(old).items()}
    new = numeric(new)
    for name in sorted(set(old) | set(new)):
        if name not in old or name not in new:
            yield f"data set {name} is only in the {'new' if name in new else 'old'} file"
        elif old[name].dtype != new[name].dtype or old[name].tobytes() != new[name].tobytes():
            yield f"data set {name} differs"


def differences(old, new):
    if set(old) != set(new) or "error" in old:
        yield f"old: {old if 'error' in old else sorted(old)}, new: {new if 'error' in new else sorted(new)}"
        return
    for name in old:
        if name.endswith((".vtkhdf", ".h5")):
            yield from (f"{name}: {text}" for text in difference_of_solutions(old[name], new[name]))
        elif name.endswith(".glb"):
            if glb_buffers(old[name]) != glb_buffers(new[name]):
                yield f"{name}: accessors differ"
        elif not name.endswith((".json", ".html")):
            with open(old[name], "rb") as a, open(new[name], "rb") as b:
                if a.read() != b.read():
                    yield f"{name}: bytes differ"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    old, new = sys.argv[1:3]
    found = compared = 0
    for scene in sys.argv[3:] or SCENES:
        for case, commands in CASES:
            with tempfile.TemporaryDirectory() as folder:
                files = [run(program, commands, scene, os.path.join(folder, side), side == "new")
                         for program, side in ((old, "old"), (new, "new"))]
                compared += len(files[0])
                for text in differences(*files):
                    print(f"{os.path.basename(scene)}, {case}: {text}")
                    found += 1
    print(f"{compared} files compared, {found} differences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
