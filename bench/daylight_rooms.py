#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Spatial daylight autonomy of rooms of a published study: daylight_rooms.py [--weather FILE] [--rooms N] [--folder DIR]

The "Parametric Daylight Room Study 2026" (github.com/Curiosit/parametric-daylight-room-study-2026, CC BY 4.0) has 4,320
rooms with one window of an eighth of the floor, in Warsaw and Berlin, computed with Radiance's two-phase method: width 3 to
7 m, depth 3 to 7 m, height 2.7 m, window clear height 1.4, 1.7 or 2.0 m, four orientations, open or in a street of 15 m
whose other side has 0.5, 1 or 1.5 times this height. In its corrected version sDA300,50% without blinds is in the mean
42.58 % of the floor in the open, 26.07, 13.47 and 7.65 % in the streets.

This script computes N rooms of each of the four kinds (default 12, spread evenly over the other parameters) and prints the
means with their 95 % intervals, by the rays and by the choice of rooms. It checks the order of magnitude: the weather is our own
year at 50 degrees north unless a file is given.
"""
import argparse
import itertools
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STREETS = {0.0: 42.58, 0.5: 26.07, 1.0: 13.47, 1.5: 7.65}  # height over width: sDA of the study, % of the floor
STREET_WIDTH = 15.0  # m
HEIGHT, RECESS = 2.7, 0.15  # m
FAR = 60.0  # m: half the length of the street
NORTH = {"south": 0, "east": 90, "north": 180, "west": 270}  # --north, for a window that faces there
REFLECTANCES = {"ceiling": 0.8, "wall": 0.5, "floor": 0.2, "facade": 0.2, "ground": 0.1, "glass": 0.0}


def rooms(count):
    """(width, depth, clear height, orientation), `count` of all, each value of a parameter about equally often."""
    widths, depths = [3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 6.5, 7.0], [3.0, 4.0, 5.0, 6.0, 7.0]
    every = list(itertools.product(widths, depths, [1.4, 1.7, 2.0], NORTH))
    # A step that has no factor in common with their number visits all; that near the golden section evenly.
    step = round(len(every) * (math.sqrt(5.0) - 1.0) / 2.0)
    while math.gcd(step, len(every)) > 1:
        step += 1
    return [every[i * step % len(every)] for i in range(count)]


class Mesh:
    """Rectangles with materials, as OBJ."""

    def __init__(self):
        self.lines, self.count = ["mtllib room.mtl"], 0

    def quad(self, material, corner, along, up):
        """A rectangle whose front is towards along x up."""
        corners = [corner, *(tuple(c + a for c, a in zip(corner, edge)) for edge in (along, map(sum, zip(along, up)), up))]
        self.lines += ["v %g %g %g" % tuple(c) for c in corners]
        self.lines += [f"usemtl {material}", "f " + " ".join(str(self.count + i) for i in (1, 2, 3, 4))]
        self.count += 4

    def wall_with_window(self, material, y, low, high, window, towards):
        """A wall in the plane y from low to high (x, z) around a window (x, z, width, height); towards: -1 or 1, its front."""
        x, z, width, height = window
        strips = [(low[0], low[1], x, high[1]), (x + width, low[1], high[0], high[1]),
                  (x, low[1], x + width, z), (x, z + height, x + width, high[1])]
        for x0, z0, x1, z1 in strips:
            if x1 > x0 and z1 > z0:
                start = x0 if towards < 0 else x1
                self.quad(material, (start, y, z0), ((x1 - x0) * -towards, 0, 0), (0, 0, z1 - z0))


def write_room(folder, width, depth, clear_height, street):
    """Window in y = 0, outside towards -y."""
    sill = 0.67 if clear_height == 2.0 else 0.8
    area = width * depth / 8.0
    window = ((width - area / clear_height) / 2.0, sill, area / clear_height, clear_height)
    mesh = Mesh()
    mesh.quad("floor", (0, 0, 0), (width, 0, 0), (0, depth, 0))
    mesh.quad("ceiling", (0, depth, HEIGHT), (width, 0, 0), (0, -depth, 0))
    mesh.quad("wall", (0, 0, 0), (0, depth, 0), (0, 0, HEIGHT))
    mesh.quad("wall", (width, depth, 0), (0, -depth, 0), (0, 0, HEIGHT))
    mesh.quad("wall", (0, depth, 0), (width, 0, 0), (0, 0, HEIGHT))
    mesh.wall_with_window("wall", 0.0, (0, 0), (width, HEIGHT), window, 1)
    other = STREET_WIDTH * street
    mesh.wall_with_window("facade", -RECESS, (-FAR, 0), (width + FAR, max(other, HEIGHT)), window, -1)
    x, z, w, h = window
    mesh.quad("facade", (x, -RECESS, z), (w, 0, 0), (0, RECESS, 0))
    mesh.quad("facade", (x, 0, z + h), (w, 0, 0), (0, -RECESS, 0))
    mesh.quad("facade", (x, 0, z), (0, -RECESS, 0), (0, 0, h))
    mesh.quad("facade", (x + w, -RECESS, z), (0, RECESS, 0), (0, 0, h))
    mesh.quad("glass", (x, 0, z), (w, 0, 0), (0, 0, h))
    if street > 0.0:
        length = width + 2 * FAR
        mesh.quad("ground", (-FAR, -RECESS - STREET_WIDTH, 0), (length, 0, 0), (0, STREET_WIDTH, 0))
        mesh.quad("facade", (width + FAR, -RECESS - STREET_WIDTH, 0), (-length, 0, 0), (0, 0, other))
    (folder / "room.obj").write_text("\n".join(mesh.lines) + "\n", encoding="utf-8")
    (folder / "room.mtl").write_text(
        "".join(f"newmtl {name}\nKd {r} {r} {r}\n" for name, r in REFLECTANCES.items()), encoding="utf-8")


def sda(program, folder, weather, room, street):
    """sDA300,50% without blinds, in %: value, low and high."""
    width, depth, clear_height, faces = room
    write_room(folder, width, depth, clear_height, street)
    grid = f"0,0,0.8:{width},0,0.8:0,{depth},0.8:{round(width / 0.25)}x{round(depth / 0.25)}"
    command = [program, "daylight", "room.obj", "--weather", weather, "--glass", "glass=0.64", "--albedo", "0.1",
               "--north", NORTH[faces], "--grid", grid, "--sky-patches", "145", "--up", "z", "--json", "--quiet"]
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, encoding="utf-8", check=False)
    if done.returncode != 0:
        sys.exit(f"daylight_rooms.py: {' '.join(map(str, command))}: {done.stderr.strip()}")
    figure = json.loads(done.stdout)["year"]["sda_300_50"]
    return [100.0 * figure[key] for key in ("value", "low", "high")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--weather", help="EPW or WEA file (default: a year of our own, by luxel-scenes)")
    parser.add_argument("--rooms", type=int, default=12, help="rooms per street (default 12)")
    parser.add_argument("--folder", help="where to work (default: a temporary folder)")
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=pathlib.Path, help="folder of the programs")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(options.folder or temporary).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        weather = pathlib.Path(options.weather).resolve() if options.weather else folder / "year.wea"
        if not options.weather:
            subprocess.run([options.bin / "luxel-scenes", "temperate-year", weather], check=True, capture_output=True)
        program = options.bin.resolve() / "luxel"
        print("| height over width of the street | sDA300,50%, % of the floor | by the rays | by the choice of rooms | study |")
        print("|---|---|---|---|---|")
        for street, known in STREETS.items():
            figures = [sda(program, folder, weather, room, street) for room in rooms(options.rooms)]
            values = [value for value, _, _ in figures]
            # Rooms have rays of their own, so their errors add up as squares.
            by_rays = math.sqrt(sum((high - low) ** 2 / 4.0 for _, low, high in figures)) / len(figures)
            by_choice = 1.96 * statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.inf
            print(f"| {street:.1f} | {statistics.mean(values):.1f} | ± {by_rays:.1f} | ± {by_choice:.1f} | {known} |", flush=True)


if __name__ == "__main__":
    main()
