# SPDX-License-Identifier: Apache-2.0
"""What the figures show, and from where."""
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BOX = os.path.join(ROOT, "scenes", "cornell-box.obj")
CAMERA = ("--eye", "0,0.2744,1.08", "--target", "0,0.2744,-0.2796", "--fov", "30")

# Every wall emits and reflects alike, another reflectance in each band.
FURNACE_REFLECTANCES = (0.1, 0.5, 0.9)
FURNACE_RADIANCE = 1.0  # W/(m² sr): emittance is pi times that
FURNACE = """mtllib furnace.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
usemtl wall
f 1 2 3 4
f 8 7 6 5
f 5 6 2 1
f 4 3 7 8
f 1 4 8 5
f 6 7 3 2
"""


def view(pixels):
    return (*CAMERA, "--width", pixels, "--height", pixels)


def write_furnace(folder):
    """A closed cube whose faces look inwards; the path of its OBJ."""
    with open(os.path.join(folder, "furnace.mtl"), "w", encoding="ascii") as file:
        reflectances = " ".join(map(str, FURNACE_REFLECTANCES))
        file.write(f"newmtl wall\nKd {reflectances}\nKe {' '.join([str(FURNACE_RADIANCE)] * 3)}\n")
    path = os.path.join(folder, "furnace.obj")
    with open(path, "w", encoding="ascii") as file:
        file.write(FURNACE)
    return path


# A second lamp on the left wall of the box, bluish.
SIDE_LAMP = ("v -0.275 0.30 -0.35", "v -0.275 0.42 -0.35", "v -0.275 0.42 -0.20", "v -0.275 0.30 -0.20", "g side",
             "usemtl side")
SIDE_MATERIAL = "\nnewmtl side\nKd 0.5 0.5 0.5\nKe 4 7 12\n"


def write_two_lamps(folder):
    """The Cornell box with two lamps, `lamp` and `side`; the path of its OBJ."""
    with open(BOX, encoding="utf-8") as file:
        box = file.read()
    first = box.count("\nv ") + 1
    path = os.path.join(folder, "two-lamps.obj")
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(box.replace("cornell-box.mtl", "two-lamps.mtl"))
        file.write("\n".join(["", *SIDE_LAMP, f"f {first} {first + 1} {first + 2} {first + 3}", ""]))
    with open(BOX.replace(".obj", ".mtl"), encoding="utf-8") as file:
        materials = file.read()
    with open(os.path.join(folder, "two-lamps.mtl"), "w", encoding="utf-8", newline="\n") as file:
        file.write(materials + SIDE_MATERIAL)
    return path
