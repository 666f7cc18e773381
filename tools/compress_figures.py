#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compresses the figures of the documents: compress_figures.py FROM TO.

Writes each figure of make_figures.py from the folder FROM into TO: pictures as WebP, charts as they are. Files of TO that
are no figures are removed. Needs Pillow (Debian: python3-pil).
"""
import os
import shutil
import subprocess
import sys

from PIL import Image

QUALITY = 84  # of 100; no difference is visible beside the PNG
MAX_WIDTH = 1280  # pixels


def published(name):
    """The file name of a figure in the documents."""
    return os.path.splitext(name)[0] + ".webp" if name.endswith(".png") else name


def compress(source, target):
    with Image.open(source) as picture:
        picture = picture.convert("RGB")
        if picture.width > MAX_WIDTH:
            picture = picture.resize((MAX_WIDTH, round(picture.height * MAX_WIDTH / picture.width)), Image.LANCZOS)
        picture.save(target, quality=QUALITY, method=6)


def main(words):
    if len(words) != 2:
        sys.exit(__doc__)
    source, target = words
    tool = os.path.join(os.path.dirname(os.path.abspath(__file__)), "make_figures.py")
    names = subprocess.run([sys.executable, "-B", tool, "--list"], capture_output=True, text=True, check=True).stdout.split()
    os.makedirs(target, exist_ok=True)
    for old in set(os.listdir(target)) - {published(name) for name in names}:
        os.remove(os.path.join(target, old))
    for name in names:
        made, kept = os.path.join(source, name), os.path.join(target, published(name))
        if name.endswith(".png"):
            compress(made, kept)
        else:
            shutil.copyfile(made, kept)
    size = sum(os.path.getsize(os.path.join(target, published(name))) for name in names)
    print(f"    {len(names)} figures, {size / 1e6:.2f} MB")


if __name__ == "__main__":
    main(sys.argv[1:])
