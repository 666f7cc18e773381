# SPDX-License-Identifier: Apache-2.0
"""The cases of daylight, measured with the program: bake and probe under a sky, and `sky`, as a user types them."""
import json
import math
import os
import subprocess

from validation import daylight_truth as truth
from validation.electric import Row
from validation.scenes import write_gltf

SKY = 10000.0  # lx
# Of the truth, for the size of the patches of the sky; types 14 and 15 are steep at the horizon, and a point that sees a low
# band of them is up to 0.26 % off by the patches alone.
PATCHES, STEEP = 1e-3, {14: 3e-3, 15: 3e-3}
SUN = 1e5  # lx
FAR = 1000.0  # m, half the length of what is continuous


def frame(outer, hole, at):
    """Quads around a hole; both (low, high, low, high)."""
    parts = ((outer[0], outer[1], outer[2], hole[2]), (outer[0], outer[1], hole[3], outer[3]),
             (outer[0], hole[0], hole[2], hole[3]), (hole[1], outer[1], hole[2], hole[3]))
    return [rectangle(*part, at) for part in parts if part[0] < part[1] and part[2] < part[3]]


def rectangle(u0, u1, v0, v1, at):
    return (at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1))


def on_roof(x, y):
    return (x, y, 3.0)


def on_facade(x, z):
    return (x, 0.0, z)


FLOOR = ((0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0))
WALLS = [((4, 0, 0), (4, 0, 3), (4, 4, 3), (4, 4, 0)), ((4, 4, 0), (4, 4, 3), (0, 4, 3), (0, 4, 0)),
         ((0, 4, 0), (0, 4, 3), (0, 0, 3), (0, 0, 0))]


def hole_of(opening):
    return (*opening[2], *opening[3])


def roof_room(opening, glazed):
    faces = [FLOOR, *WALLS, ((0, 0, 0), (0, 0, 3), (4, 0, 3), (4, 0, 0)), *frame((0, 4, 0, 4), hole_of(opening), on_roof)]
    pane = {"glass": (0.0, [rectangle(*hole_of(opening), on_roof)])} if glazed else {}
    return {"black": (0.0, faces), **pane}


def facade_room(opening, glazed, extent=0.0):
    faces = [FLOOR, *WALLS, rectangle(0, 4, 0, 4, on_roof), *frame((-extent, 4 + extent, 0, 3), hole_of(opening), on_facade)]
    pane = {"glass": (0.0, [rectangle(*hole_of(opening), on_facade)])} if glazed else {}
    return {"black": (0.0, faces), **pane}


def strips(low, high, step, at):
    """Quads of a continuous mask: patches in the middle have the light of an endless strip and are not slender."""
    count, ends = round((high - low) / step), (-FAR, -10.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 14.0, 4.0 + FAR)
    return [rectangle(x0, x1, low + i * step, low + (i + 1) * step, at) for i in range(count) for x0, x1 in zip(ends, ends[1:])]


def bake(program, surfaces, *words):
    write_gltf(program.at("room.gltf"), surfaces)
    program.luxel.run("bake", program.at("room.gltf"), "-o", program.at("light.vtkhdf"), "--max-edge", "0", "--mesh-error", "none",
                      "--error", "0.2%", "--error-measure", "power", "--store-transport", "--seed", program.seed,
                      *(["--glass", f"glass={truth.TRANSMITTANCE}"] if "glass" in surfaces else []), *words)


def under_sky(program, kind, azimuth, surfaces, points):
    """Per cent of the sky's illuminance, and the standard error, at points."""
    bake(program, surfaces, "--sky", f"cie:{kind}", "--sun", f"60,{azimuth}", "--sun-illuminance", "0", "--albedo",
         str(truth.ALBEDO), "--sky-illuminance", str(SKY))
    return [(100.0 * lx / SKY, 100.0 * error / SKY) for lx, error in program.probe(points, "0.05%", "1M")]


def rows(program, true, azimuth, surfaces, points):
    """{label: {sky: Row}}."""
    found = {label: {} for label in true}
    for kind in next(iter(true.values())):
        for (label, pair), (value, error) in zip(true.items(), under_sky(program, kind, azimuth, surfaces, points)):
            percent = pair[kind][0]
            found[label][kind] = Row(f"{label}, sky {kind}", value, error, percent, "", STEEP.get(kind, PATCHES) * percent)
    return found


def case_5_5(program):
    """A sun at angles of incidence; points face it."""
    found = []
    for name, (true, _) in truth.case_5_5().items():
        angle = math.radians(float(name))
        direction = (math.sin(angle), 0.0, -math.cos(angle))
        write_gltf(program.at("room.gltf"), {"glass": (0.0, [((-9, -9, 1), (9, -9, 1), (9, 9, 1), (-9, 9, 1))]),
                                             "floor": (0.0, [((-9, -9, -9), (9, -9, -9), (9, 9, -9), (-9, 9, -9))])},
                   (direction, SUN))
        program.bake("room.gltf", "--max-edge", "0", "--glass", f"glass={truth.TRANSMITTANCE}")
        lx, error = program.probe([((0.0, 0.0, 0.0), tuple(-c for c in direction))])[0]
        scale = 100.0 / (SUN * truth.TRANSMITTANCE)
        found.append(Row(f"{name} degrees", scale * lx, scale * error, 100.0 * true, "", 2e-3))
    return found


def roof(program, size, glazed, skies):
    points = list(truth.points_of_roof().values())
    return rows(program, truth.roof(size, glazed, skies), 0, roof_room(truth.ROOF[size], glazed), points)


def facade(program, size, glazed, skies):
    points = list(truth.points_of_facade().values())
    return rows(program, truth.facade(size, glazed, skies), 180, facade_room(truth.FACADE[size], glazed), points)


MASK_POINTS = [(at, truth.UP) for at in truth.MASK_FLOOR.values()]


def overhang(program, depth, skies):
    surfaces = facade_room(truth.FACADE["2 × 1 m"], False, FAR)
    surfaces["overhang"] = (truth.MASK, strips(-depth, 0.0, 0.1, on_roof))
    return rows(program, truth.overhang(depth, skies), 180, surfaces, MASK_POINTS)


def screen(program, height, skies):
    surfaces = facade_room(truth.FACADE["2 × 1 m"], False, FAR)
    surfaces["black"][1].append(rectangle(-FAR, 4 + FAR, 0, truth.DEPTH, lambda x, y: (x, y, 3.0001)))
    surfaces["screen"] = (truth.MASK, strips(0.0, height, 0.25, lambda x, z: (x, -6.0, z)))
    return rows(program, truth.screen(height, skies), 180, surfaces, MASK_POINTS)


def sky(program, *words):
    """The output of `luxel sky`."""
    command = [os.path.join(program.luxel.programs, "luxel"), "sky", *map(str, words), "--json"]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def over_zenith(program, kind, elevation):
    """E_h / L_z of a sky with the sun at an elevation, degrees."""
    return sky(program, f"cie:{kind}", "--sun", f"{elevation},180")["horizontal_over_zenith"]


def orbit_factor(day):
    """(mean distance of the sun / its distance)^2 of a day of the year; Spencer 1971."""
    angle = (day - 1) * 2.0 * math.pi / 365.0
    return (1.00011 + 0.034221 * math.cos(angle) + 0.00128 * math.sin(angle) + 0.000719 * math.cos(2.0 * angle) +
            0.000077 * math.sin(2.0 * angle))


def perez(program, day, sun, direct, diffuse, dew_point):
    """Clearness, brightness, illuminances by sun and sky, and the parameters. The program has the sun of `--sun` at its mean
    distance: both irradiances are divided by the factor of the orbit, and the illuminances multiplied by it."""
    factor = orbit_factor(day)
    found = sky(program, "perez", "--sun", sun, "--direct-normal", direct / factor, "--diffuse-horizontal", diffuse / factor,
                "--dew-point", dew_point)
    model = found["perez"]
    return (model["clearness"], model["brightness"], factor * found["direct_normal_illuminance"],
            factor * found["horizontal_illuminance"], *model["parameters"])


def sun_position(program):
    """Zenith angle and azimuth of the example of the solar position algorithm, degrees. The program has the refraction of
    1010 hPa and 10 degrees; that of 820 hPa and 11 degrees replaces it."""
    sun = sky(program, "cie:12", "--date", "2003-10-17T12:30:30-07:00", "--place", "39.742476,-105.1786")["sun"]
    elevation = sun["elevation"]
    refraction = 1.02 / 60.0 / math.tan(math.radians(elevation + 10.3 / (elevation + 5.11)))
    return 90.0 - elevation + refraction * (1.0 - 820.0 / 1010.0 * 283.0 / 284.0), sun["azimuth"]
