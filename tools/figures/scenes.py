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
