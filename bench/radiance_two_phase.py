#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A year of daylight by Luxel and by Radiance's two-phase method: radiance_two_phase.py [--large] [--small] [--folder DIR]

Both compute the illuminance of each hour of a year at the points of a plane in a classroom with two windows and 24 desks
(with --large in the one of luxel-scenes, of 86,336 triangles, which takes an hour), several times with more and more rays,
and print the CPU seconds of the whole process and the error against a converged run of the same program: the RMS of the
relative difference over all points and hours with 50 lx or more. Each program is held to itself, since they differ in what
they model (Radiance spreads the sun over patches of the sky, Luxel traces rays to its place), so the error is that of the
rays alone. Error squared times CPU seconds is a constant of each program; the last line has the ratio.

Radiance is not in Debian: rfluxmtx, oconv, gendaymtx, dctimestep and rmtxop are looked for on the PATH. Without them the
rows of Luxel are printed alone. Needs NumPy and h5py.
"""
import argparse
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ["rfluxmtx", "oconv", "gendaymtx", "dctimestep", "rmtxop"]
EFFICACY = 179.0  # lm/W of Radiance
LUMINANCE = [0.265, 0.670, 0.065]  # of Radiance's red, green and blue
ENOUGH = 50.0  # lx
ROOM = ["8x7x2.9", "--window", "south:0.6,0.9,3.1,1.6", "--window", "south:4.3,0.9,3.1,1.6", "--reflectance", "80,55,25"]
DESK = (1.2, 0.55, 0.7)  # m: width, depth, height
SKY = """#@rfluxmtx u=+Y h=u
void glow ground_glow
0
0
4 1 1 1 0
ground_glow source ground
0
0
4 0 0 -1 180
#@rfluxmtx u=+Y h=r{division}
void glow sky_glow
0
0
4 1 1 1 0
sky_glow source sky
0
0
4 0 0 1 180
"""


def run(command, folder, **more):
    """Runs a program; returns its CPU seconds."""
    more.setdefault("stdout", subprocess.DEVNULL)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        subprocess.run([str(word) for word in command], cwd=folder, check=True, stderr=subprocess.PIPE, **more)
    except subprocess.CalledProcessError as error:
        sys.exit(f"radiance_two_phase.py: {' '.join(map(str, command))}: {error.stderr.decode(errors='replace').strip()}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def box(low, high):
    """Corners and quads of a box, which face outwards."""
    corners = [[(low, high)[bit >> axis & 1][axis] for axis in range(3)] for bit in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, quads


def write_classroom(program, folder):
    """Z up: a room with four rows of six desks, whose tops are boards of 4 cm."""
    run([program, "room", *ROOM, "--quiet", "-o", "classroom.obj"], folder)
    obj = folder / "classroom.obj"
    lines = obj.read_text(encoding="utf-8").splitlines()
    count = sum(line.startswith("v ") for line in lines)
    lines.append("usemtl desk")
    width, depth, height = DESK
    for row in range(4):
        for column in range(6):
            x, y = 0.3 + 1.25 * column, 1.0 + 1.4 * row
            corners, quads = box((x, y, height - 0.04), (x + width, y + depth, height))
            lines += [f"v {a:.4f} {b:.4f} {c:.4f}" for a, b, c in corners]
            lines += ["f " + " ".join(str(count + 1 + i) for i in quad) for quad in quads]
            count += len(corners)
    obj.write_text("\n".join(lines) + "\n", encoding="utf-8")
    with open(folder / "classroom.mtl", "a", encoding="utf-8") as mtl:
        mtl.write("\nnewmtl desk\nKd 0.5 0.5 0.5\n")


def by_luxel(program, folder, is_large, rays, error):
    """CPU seconds, and lx, [hour, point], of the hours with light."""
    spacing, sky = (0.6, 577) if is_large else (0.75, 145)
    cpu = run([program, "daylight", "classroom.obj", "--weather", "town.wea", "--plane", "0.8", "--spacing", spacing,
               "--sky-patches", sky, "--rays", rays, "--error", f"{error}%", "--quiet", "-o", "year.h5"], folder)
    with h5py.File(folder / "year.h5") as file:
        return cpu, file["illuminance"][:], file["points/position"][:], file["points/normal"][:]


def z_up(vectors, is_y_up):
    """Y up and -Z north, where the scene has that, to Z up and Y north."""
    v = np.atleast_2d(vectors)
    return np.stack([v[:, 0], -v[:, 2], v[:, 1]], axis=1) if is_y_up else v


def colours_of(path):
    colours, name = {}, None
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["newmtl"]:
            name = words[1]
        elif words[:1] == ["Kd"] and name:
            colours[name] = [float(w) for w in words[1:4]]
    return colours


def write_radiance_scene(obj, mtl, to, is_y_up):
    """The polygons of an OBJ file as Radiance reads them. Glass lets all light pass, as in the scene."""
    colours = colours_of(mtl)
    corners, material, lines = [], "default", []
    for name, (r, g, b) in colours.items():
        lines.append(f"void plastic {name}\n0\n0\n5 {r} {g} {b} 0 0\n")
    for line in obj.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            corners.append(z_up([float(w) for w in words[1:4]], is_y_up)[0])
        elif words[:1] == ["usemtl"]:
            material = words[1]
        elif words[:1] == ["f"] and "glass" not in material:
            face = [corners[int(w.split("/")[0]) - 1] for w in words[1:]]
            numbers = " ".join(f"{x:.7g}" for corner in face for x in corner)
            lines.append(f"{material} polygon f{len(lines)}\n0\n0\n{3 * len(face)} {numbers}\n")
    to.write_text("".join(lines), encoding="utf-8")


def prepare_radiance(folder, position, normal, is_large):
    write_radiance_scene(folder / "classroom.obj", folder / "classroom.mtl", folder / "scene.rad", is_large)
    division = 2 if is_large else 1  # of the sky: 577 or 145 patches
    (folder / "sky.rad").write_text(SKY.format(division=division), encoding="utf-8")
    np.savetxt(folder / "points.txt", np.hstack([z_up(position, is_large), z_up(normal, is_large)]), fmt="%.6g")
    with open(folder / "skies.mtx", "wb") as out:
        return run(["gendaymtx", "-m", division, "-u", "town.wea"], folder, stdout=out)


def by_radiance(folder, points, divisions):
    """CPU seconds, and lx, [hour, point], of the hours with the sun up."""
    with open(folder / "points.txt", "rb") as sensors, open(folder / "coefficients.mtx", "wb") as out:
        cpu = run(["rfluxmtx", "-I+", "-n", os.cpu_count(), "-y", points, "-ab", "8", "-ad", divisions, "-lw",
                   f"{1.0 / divisions:.3g}", "-", "sky.rad", "scene.rad"], folder, stdin=sensors, stdout=out)
    with open(folder / "light.mtx", "wb") as out:
        cpu += run(["dctimestep", "coefficients.mtx", "skies.mtx"], folder, stdout=out)
    with open(folder / "light.txt", "wb") as out:
        weights = [f"{EFFICACY * w}" for w in LUMINANCE]
        cpu += run(["rmtxop", "-fa", "-t", "-c", *weights, "light.mtx"], folder, stdout=out)
    text = (folder / "light.txt").read_text(encoding="utf-8").split("\n\n", 1)[-1]
    return cpu, np.array(text.split(), dtype=float).reshape(-1, points)


def error_against(light, converged):
    counts = converged >= ENOUGH
    return float(np.sqrt(np.mean(((light - converged)[counts] / converged[counts]) ** 2)))


def table(name, runs):
    """Prints one program's rows, the last of which is the converged run; returns the median of error² times seconds."""
    *others, (_, _, converged) = runs
    products = []
    for setting, cpu, light in others:
        error = error_against(light, converged)
        products.append(error * error * cpu)
        print(f"{name:<10} {setting:>12} {cpu:>9.1f} {100 * error:>9.2f}")
    return float(np.median(products))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--program", default=ROOT / "build/release/bin/luxel", help="luxel, with luxel-scenes beside it")
    arguments.add_argument("--folder", type=pathlib.Path, help="keep all files here")
    arguments.add_argument("--large", action="store_true", help="the classroom of luxel-scenes, of 86,336 triangles")
    arguments.add_argument("--small", action="store_true", help="few rays, to see that it works: the numbers mean nothing")
    options = arguments.parse_args()
    program = pathlib.Path(options.program).resolve()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.folder or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        scenes = program.parent / "luxel-scenes"
        if options.large:
            run([scenes, "classroom", "classroom.obj"], folder)
        else:
            write_classroom(program, folder)
        run([scenes, "temperate-year", "town.wea"], folder)
        print(f"{'program':<10} {'setting':>12} {'CPU s':>9} {'error %':>9}")
        settings = [(256, 20), (1024, 10), (4096, 5), (16384, 2.5)]
        if options.large:
            settings = [(4 * rays, error / 2) for rays, error in settings]
        if options.small:
            settings = [(64, 50), (256, 40)]
        runs = []
        for rays, error in settings:
            cpu, light, position, normal = by_luxel(program, folder, options.large, rays, error)
            runs.append((f"{rays} rays", cpu, light))
        luxel = table("Luxel", runs)
        missing = [name for name in PROGRAMS if not shutil.which(name)]
        if missing:
            print(f"Radiance     not found on the PATH: {', '.join(missing)}")
            return
        print(f"gendaymtx: {prepare_radiance(folder, position, normal, options.large):.1f} CPU s, which both leave out below")
        runs = []
        for divisions in [64, 256] if options.small else [1024, 4096, 16384, 131072]:
            cpu, light = by_radiance(folder, len(position), divisions)
            runs.append((f"-ad {divisions}", cpu, light))
        radiance = table("Radiance", runs)
        print(f"error² times CPU seconds: Radiance over Luxel {radiance / luxel:.2g}")


if __name__ == "__main__":
    main()
