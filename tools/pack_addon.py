#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Packs the add-on for Blender: pack_addon.py [FOLDER], by default out/.

Writes luxel_bake-VERSION.zip, an extension for Blender 4.2 and later, whose files are at its root, and
luxel_bake-VERSION-legacy.zip, an add-on for earlier versions, whose files are in a folder. The same sources give the same
bytes. Exit status 1 if the versions of the manifest, of bl_info and of CMakeLists.txt differ.
"""
import ast
import os
import re
import sys
import tomllib
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SOURCES = os.path.join(ROOT, "integrations", "blender")
MODULE = "luxel_bake"  # one file, which is the package in both archives
MANIFEST = "blender_manifest.toml"


def text_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def versions():
    """The places of the version, and its value in each."""
    module = ast.parse(text_of(SOURCES, MODULE + ".py"))
    info = next(ast.literal_eval(item.value) for item in module.body
                if isinstance(item, ast.Assign) and item.targets[0].id == "bl_info")
    return {MANIFEST: tomllib.loads(text_of(SOURCES, MANIFEST))["version"],
            "bl_info": ".".join(map(str, info["version"])),
            "CMakeLists.txt": re.search(r"project\(luxel VERSION ([\d.]+)", text_of(ROOT, "CMakeLists.txt"))[1]}


def write_archive(path, files):
    """files: content by name."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name)  # of 1980: no time of its making
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return path


def pack(folder):
    """The paths of the extension and of the add-on for earlier versions."""
    found = versions()
    if len(set(found.values())) > 1:
        raise ValueError("the versions differ: " + ", ".join(f"{place} has {version}" for place, version in found.items()))
    name = os.path.join(folder, f"{MODULE}-{found[MANIFEST]}")
    module, licence = text_of(SOURCES, MODULE + ".py"), text_of(ROOT, "LICENSE")
    os.makedirs(folder, exist_ok=True)
    return (write_archive(name + ".zip", {"__init__.py": module, MANIFEST: text_of(SOURCES, MANIFEST), "LICENSE": licence}),
            write_archive(name + "-legacy.zip", {f"{MODULE}/__init__.py": module, f"{MODULE}/LICENSE": licence}))


if __name__ == "__main__":
    try:
        print("\n".join(pack(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "out"))))
    except ValueError as error:
        sys.exit(f"pack_addon.py: {error}")
