#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes scenes that are hard to make clean pictures of: noise_scenes.py FOLDER [NAME...]

  cornell-sphere    the demo's Cornell box with a sphere in place of its blocks
  window-hole       a bare room of 5 x 4 x 3 m with a hole of 1 m² in one wall; bake with --sky 1
  window-glass      the same, closed by a pane of glass (d 0.1 in the MTL); bake with --sky 1
  window-emitter    the same, a pane in the hole that shines as the sky would
  window-sun        the hole again, and a sun that makes one patch of light on the floor (glTF); bake with --sky 1
  white-room        a white room with white chairs, reflectance 0.98
  bar               40 shaded lamps close to walls, 40,000 emissive triangles, 5 textures, about 500,000 patches

Without a NAME all of them. Needs numpy. For bench/picture_noise.py.
"""
import os
import sys

import numpy as np

from pictures import write_png
from shapes import Mesh, write_gltf, write_obj

WHITE, RED, GREEN = (0.73, 0.73, 0.73), (0.61, 0.06, 0.05), (0.12, 0.44, 0.10)


def room(mesh, size, material, floor=None, repeat=1.0, walls="fbrl"):
    """A closed room from the origin to `size`, seen from within. walls: of front (z high), back, right and left."""
    x, y, z = size
    mesh.quad(floor or material, (0, 0, z), (x, 0, z), (x, 0, 0), (0, 0, 0), repeat)
    mesh.quad(material, (0, y, 0), (x, y, 0), (x, y, z), (0, y, z), repeat)
    sides = {"b": ((0, 0, 0), (x, 0, 0), (x, y, 0), (0, y, 0)), "f": ((x, 0, z), (0, 0, z), (0, y, z), (x, y, z)),
             "l": ((0, 0, z), (0, 0, 0), (0, y, 0), (0, y, z)), "r": ((x, 0, 0), (x, 0, z), (x, y, z), (x, y, 0))}
    for side in walls:
        mesh.quad(material, *sides[side], repeat=repeat)


def cornell_sphere(path):
    """The sizes and paints of scenes/cornell-box.obj."""
    mesh = Mesh({"white": {"Kd": WHITE}, "red": {"Kd": RED}, "green": {"Kd": GREEN},
                 "lamp": {"Kd": (0.78, 0.78, 0.78), "Ke": (16.5, 12.0, 5.5)}})
    x, y, z = 0.5528, 0.5488, 0.5592
    room(mesh, (x, y, z), "white", walls="b")
    mesh.quad("red", (0, 0, z), (0, 0, 0), (0, y, 0), (0, y, z))
    mesh.quad("green", (x, 0, 0), (x, 0, z), (x, y, z), (x, y, 0))
    low, high, below = (0.2114, 0.2272), (0.3414, 0.3322), y - 0.0005
    mesh.quad("lamp", (low[0], below, low[1]), (high[0], below, low[1]), (high[0], below, high[1]), (low[0], below, high[1]))
    mesh.sphere("white", (0.30, 0.13, 0.26), 0.13, 48, 96)
    write_obj(path, mesh, ["camera, the whole box: --eye 0.2764,0.2744,1.64 --target 0.2764,0.2744,0.28 --fov 30"])


def window_room(pane):
    """The wall at z = 0 has a hole of 1 m x 1 m, 1 m above the floor."""
    mesh = Mesh({"plaster": {"Kd": (0.6, 0.6, 0.6)}, **({"pane": pane} if pane else {})})
    room(mesh, (5, 3, 4), "plaster", walls="frl")
    columns, rows = (0, 2, 3, 5), (0, 1, 2, 3)
    for i in range(3):
        for j in range(3):
            left, right, low, high = columns[i], columns[i + 1], rows[j], rows[j + 1]
            material = "pane" if (i, j) == (1, 1) else "plaster"
            if material in mesh.materials:
                mesh.quad(material, (left, low, 0), (right, low, 0), (right, high, 0), (left, high, 0))
    return mesh


WINDOW_CAMERA = "camera, inside: --eye 4.6,1.6,3.6 --target 1.8,1.1,0.4 --fov 65"


def window_hole(path):
    write_obj(path, window_room(None), ["Bake with --sky 1.", WINDOW_CAMERA])


def window_glass(path):
    write_obj(path, window_room({"Kd": (0.9, 0.9, 0.9), "d": 0.1}), ["Bake with --sky 1.", WINDOW_CAMERA])


def window_emitter(path):
    write_obj(path, window_room({"Kd": (0.0, 0.0, 0.0), "Ke": (1.0, 1.0, 1.0)}), [WINDOW_CAMERA])


def window_sun(path):
    # Through the hole to the floor between 1.2 and 2.4 m from the wall; 5 times the light of the sky on a roof.
    write_gltf(path, window_room(None), ((0.25, -1.0, 1.2), 5 * np.pi))


def chair(mesh, material, x, z, turn):
    """A round seat on four round legs, with a bent back of thin rods."""
    mesh.turned(material, (x, 0.43, z), [(0, 0), (0.20, 0), (0.22, 0.02), (0.20, 0.04), (0, 0.04)], 48)
    for k in range(4):
        angle = turn + (k + 0.5) * np.pi / 2
        mesh.turned(material, (x + 0.15 * np.cos(angle), 0, z + 0.15 * np.sin(angle)), [(0.02, 0), (0.02, 0.42)], 16)
    for k in range(7):
        angle = turn + (k - 3) * 0.22
        at = (x + 0.19 * np.cos(angle), 0.48, z + 0.19 * np.sin(angle))
        mesh.turned(material, at, [(0, 0), (0.012, 0), (0.012, 0.42), (0, 0.42)], 12)


def white_room(path):
    white = {"Kd": (0.98, 0.98, 0.98)}
    mesh = Mesh({"white": white, "chair": white, "lamp": {"Kd": (0.0, 0.0, 0.0), "Ke": (10.0, 10.0, 10.0)}})
    room(mesh, (5, 2.8, 4), "white")
    mesh.quad("lamp", (2.2, 2.79, 1.7), (2.8, 2.79, 1.7), (2.8, 2.79, 2.3), (2.2, 2.79, 2.3))
    for i in range(4):
        for j in range(3):
            chair(mesh, "chair", 0.8 + 1.1 * i, 0.7 + 1.2 * j, 0.7 * i + 1.9 * j)
    write_obj(path, mesh, ["camera: --eye 4.7,1.7,3.7 --target 1.8,0.6,1.2 --fov 60"])


def grain(rng, tint, across, along, pixels=2048):
    """A picture of streaks about `tint`, that repeats."""
    coarse = rng.random((pixels // across, pixels // along))
    fine = 0.75 * np.kron(coarse, np.ones((across, along))) + 0.25 * rng.random((pixels, pixels))
    return np.asarray(tint) * (0.4 + 0.6 * fine)[..., None]


def bar_textures(folder, rng):
    tints = {"parquet": ((190, 130, 80), 64, 512), "wallpaper": ((200, 190, 150), 128, 32), "wood": ((120, 70, 40), 16, 1024),
             "leather": ((150, 40, 30), 4, 4), "label": ((220, 220, 180), 32, 64)}
    for name, (tint, across, along) in tints.items():
        write_png(os.path.join(folder, f"bar-{name}.png"), grain(rng, tint, across, along))
    return {name: {"Kd": (1.0, 1.0, 1.0), "map_Kd": f"bar-{name}.png"} for name in tints}


def wall_lamp(mesh, x, z):
    """A bulb of 1,000 triangles in a shade open above and below."""
    mesh.sphere("bulb", (x, 1.9, z), 0.035, 26, 20)
    mesh.turned("shade", (x, 1.8, z), [(0.11, 0), (0.07, 0.2)], 40)


def bottle(mesh, x, y, z):
    mesh.turned("label", (x, y, z), [(0.035, 0), (0.037, 0.06), (0.036, 0.12), (0.035, 0.17)], 40, 0.25)
    mesh.turned("glass", (x, y, z), [(0.035, 0.17), (0.028, 0.20), (0.014, 0.23), (0.012, 0.29), (0.014, 0.295), (0, 0.30)], 40)


def stool(mesh, x, z):
    mesh.turned("leather", (x, 0.70, z), [(0, 0), (0.15, 0), (0.17, 0.02), (0.17, 0.05), (0.15, 0.07), (0.08, 0.08), (0, 0.08)],
                80, 0.5)
    mesh.turned("steel", (x, 0, z), [(0.20, 0), (0.20, 0.015), (0.03, 0.03), (0.025, 0.3), (0.025, 0.6), (0.05, 0.70)], 48)


def table(mesh, x, z):
    mesh.turned("wood", (x, 0.72, z), [(0, 0), (0.40, 0), (0.41, 0.015), (0.40, 0.03), (0.2, 0.03), (0, 0.03)], 128, 0.8)
    mesh.turned("steel", (x, 0, z), [(0.25, 0), (0.24, 0.02), (0.04, 0.04), (0.03, 0.4), (0.04, 0.72)], 48)
    for k in range(5):
        at = (x + 0.28 * np.cos(1.3 * k), 0.75, z + 0.28 * np.sin(1.3 * k))
        mesh.turned("glass", at, [(0.03, 0), (0.005, 0.005), (0.004, 0.07), (0.03, 0.10), (0.035, 0.15)], 48)


def bar(path):
    rng = np.random.default_rng(1)
    mesh = Mesh({**bar_textures(os.path.dirname(path), rng), "ceiling": {"Kd": (0.7, 0.68, 0.62)},
                 "bulb": {"Kd": (0.0, 0.0, 0.0), "Ke": (900.0, 700.0, 400.0)}, "shade": {"Kd": (0.75, 0.7, 0.6)},
                 "glass": {"Kd": (0.25, 0.35, 0.25)}, "steel": {"Kd": (0.5, 0.5, 0.5)}})
    x, y, z = 14.0, 3.2, 8.0
    room(mesh, (x, y, z), "wallpaper", "parquet", 1.5)
    away = 0.13  # lamps from walls, m: 2 cm between shade and wall
    for k in range(13):
        wall_lamp(mesh, 0.75 + 1.04 * k, away)
        wall_lamp(mesh, 0.75 + 1.04 * k, z - away)
    for k in range(7):
        wall_lamp(mesh, away, 0.7 + 1.1 * k)
        wall_lamp(mesh, x - away, 0.7 + 1.1 * k)
    mesh.box("wood", (3.0, 0, 1.2), (11.0, 1.1, 1.8), 1.2)
    for shelf in range(3):
        mesh.box("wood", (3.0, 0.9 + 0.4 * shelf, 0.3), (11.0, 0.93 + 0.4 * shelf, 0.55), 1.2)
        for k in range(64):
            bottle(mesh, 3.1 + 0.123 * k, 0.931 + 0.4 * shelf, 0.42 + 0.05 * rng.random())
    for k in range(12):
        stool(mesh, 3.3 + 0.67 * k, 2.2)
    for i in range(6):
        for j in range(3):
            table(mesh, 1.6 + 2.1 * i, 3.6 + 1.5 * j)
            for k in range(3):
                stool(mesh, 1.6 + 2.1 * i + 0.62 * np.cos(2.1 * k + j), 3.6 + 1.5 * j + 0.62 * np.sin(2.1 * k + j))
    write_obj(path, mesh, ["camera: --eye 12.6,1.6,6.9 --target 5,1.1,2.2 --fov 60"])


SCENES = {"cornell-sphere": (cornell_sphere, "obj"), "window-hole": (window_hole, "obj"), "window-glass": (window_glass, "obj"),
          "window-emitter": (window_emitter, "obj"), "window-sun": (window_sun, "gltf"), "white-room": (white_room, "obj"),
          "bar": (bar, "obj")}


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-") or set(sys.argv[2:]) - set(SCENES):
        sys.exit(__doc__)
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name in sys.argv[2:] or SCENES:
        make, ending = SCENES[name]
        path = os.path.join(folder, f"{name}.{ending}")
        make(path)
        print(path)


if __name__ == "__main__":
    main()
