# SPDX-License-Identifier: Apache-2.0
"""The cases of electric light, measured with the program: bake, probe, ugr-table as a user types them."""
import csv
import json
import math
import os
import re

from figures.scenes import ROOT
from validation import truth
from validation.scenes import (box, cosine, write_gltf, write_ies, write_luminaires, write_obj, write_points)

ISOTROPIC = 10000.0 / (4.0 * math.pi)  # cd of 10,000 lm
STUDENT = 1.96  # standard errors are widened, so that 1.96 of them are a 95 % interval
EFFICACY = 179.0  # lm/W


class Row:
    """One figure: what Luxel measured with its standard error, the truth, and what others published.

    accuracy: absolute, of rounding and of the table of a distribution. bound: of a figure without a standard error."""

    def __init__(self, name, value, error, true, others="", accuracy=0.0, bound=None):
        self.name, self.value, self.error, self.true, self.others = name, value, error, true, others
        self.accuracy, self.bound = accuracy, bound

    def holds(self):
        limit = self.bound if self.bound is not None else 3.0 * self.error + self.accuracy
        return abs(self.value - self.true) <= limit


class Program:
    """Runs Luxel in a folder with one seed."""

    def __init__(self, luxel, seed):
        self.luxel, self.seed = luxel, seed

    def other(self):
        """With random numbers of its own, for the second of two measurements that are compared."""
        return Program(self.luxel, self.seed + 10)

    def at(self, name):
        return self.luxel.at(name)

    def bake(self, scene, *words, error="0.1%"):
        return self.luxel.run("bake", self.at(scene), "-o", self.at("light.vtkhdf"), "--error", error, "--error-measure",
                              "power", "--mesh-error", "none", "--sky", "none", "--store-transport", "--seed", self.seed,
                              *words)

    def probe(self, points, error="0.05%", rays="2M"):
        write_points(self.at("points.csv"), points)
        self.luxel.do("probe", self.at("light.vtkhdf"), "--points", self.at("points.csv"), "--error", error, "--rays", rays,
                      "--floor", "0.001", "--seed", self.seed, "-o", self.at("light.csv"), "--quiet")
        with open(self.at("light.csv"), encoding="utf-8") as file:
            return [(float(row["illuminance_lx"]), float(row["standard_error_lx"])) for row in csv.DictReader(file)]

    def luminaires(self, *rows):
        write_luminaires(self.at("luminaires.csv"), rows)
        return ["--luminaires", self.at("luminaires.csv")]


def published(name):
    """{label: value} that others published; see the sources on the page."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "published.json"), encoding="utf-8") as file:
        return json.load(file)[name]


def others(case, label):
    found = []
    for who, values in published(case).items():
        if label in values:
            found.append(f"{who} {values[label]}")
    return ", ".join(found)


def room(height=3.0, reflectance=0.0):
    return {"room": (reflectance, box((0, 0, 0), (4, 4, height), outside=False))}


def case_5_2(program):
    write_gltf(program.at("surface.gltf"), {"surface": (0.0, [((-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0))])})
    write_ies(program.at("cosine.ies"), *cosine(1000.0))
    program.bake("surface.gltf", "--max-edge", "0", *program.luminaires({"file": "cosine.ies", "place": (0, 0, 3)}))
    light = program.probe([(place, truth.UP) for place in truth.CASE_5_2.values()])
    return [Row(f"{label}, lx", *measured, true[0], others("5.2", label), 2e-5 * true[0])
            for (label, true), measured in zip(truth.case_5_2().items(), light)]


def case_5_3(program):
    write_gltf(program.at("room.gltf"), room())
    write_ies(program.at("area.ies"), *cosine(1000.0), size=(1.0, 1.0))
    program.bake("room.gltf", "--max-edge", "0", *program.luminaires({"file": "area.ies", "place": (2, 2, 3)}))
    points = [(place, truth.NORTH) for place in truth.WALL.values()] + [(place, truth.UP) for place in truth.FLOOR.values()]
    light = program.probe(points)
    return [Row(f"{label}, lx", *measured, true[0], others("5.3", label), 2e-5 * true[0])
            for (label, true), measured in zip(truth.case_5_3().items(), light)]


def disk(program):
    write_gltf(program.at("room.gltf"), room())
    # A width below 0 is a disk in LM-63-2002.
    write_ies(program.at("disk.ies"), *cosine(1000.0), size=(-0.8, -0.8))
    program.bake("room.gltf", "--max-edge", "0", *program.luminaires({"file": "disk.ies", "place": (2, 2, 2.5)}))
    found = truth.disk_on_axis()
    light = program.probe([((2, 2, 2.5 - float(label.split()[0])), truth.UP) for label in found])
    return [Row(f"{label} below, lx", *measured, true[0], "", 5e-5 * true[0])
            for (label, true), measured in zip(found.items(), light)]


def received(report, *names):
    """lm that materials receive, and the standard error, from the report of a bake."""
    flux = variance = 0.0
    for surface in report["solve"]["surfaces"]:
        if not names or surface["material"] in names:
            flux += EFFICACY * surface["area_m2"] * surface["irradiance_W_per_m2"][1]
            variance += (EFFICACY * surface["area_m2"] * surface["standard_error_W_per_m2"][1]) ** 2
    return flux, math.sqrt(variance)


def received_by_all(report):
    whole = report["solve"]["received_W"]
    return EFFICACY * whole["power"][1], EFFICACY * whole["standard_error"][1]


def case_5_4(program):
    faces = box((0, 0, 0), (4, 4, 3), outside=False)
    surfaces = {name: (0.0, [face]) for name, face in zip(("floor", "ceiling", "south", "east", "north", "west"), faces)}
    write_ies(program.at("even.ies"), [0, 180], [0], [[ISOTROPIC, ISOTROPIC]])
    write_gltf(program.at("room.gltf"), surfaces)
    lamp = program.luminaires({"file": "even.ies", "place": truth.LAMP_5_4})
    report = program.bake("room.gltf", "--max-edge", "0.5", *lamp)
    true = truth.case_5_4()
    rows = [Row("all surfaces, lm", *received_by_all(report), true["room"][0], others("5.4", "room"), 0.05)]
    for name, like in (("floor", "floor"), ("ceiling", "floor"), ("south", "wall"), ("east", "wall"), ("north", "wall"),
                       ("west", "wall")):
        rows.append(Row(f"{name}, lm", *received(report, name), true[like][0], others("5.4", name), 0.02))
    low, high = truth.OPENING_5_4[2], truth.OPENING_5_4[3]
    surfaces["south"] = (0.0, [((x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0)) for x0, x1, z0, z1 in (
        (0, low[0], 0, 3), (low[1], 4, 0, 3), (low[0], low[1], 0, high[0]), (low[0], low[1], high[1], 3))])
    write_gltf(program.at("open.gltf"), surfaces)
    lamp = program.luminaires({"file": "even.ies", "place": truth.ASIDE_5_4})
    report = program.bake("open.gltf", "--max-edge", "0.5", *lamp)
    rows.append(Row("with an opening of 2 × 1 m, lm", *received_by_all(report), true["room with an opening"][0], "", 0.05))
    return rows


def reflected(case, program, points, exitance, true, error):
    rays = "262144" if error == "exhaust" else "2M"
    light = program.probe(points, "1e-14" if error == "exhaust" else error, rays)
    return [Row(f"{label}, %", 100.0 * lx / exitance, 100.0 * se / exitance, pair[0], others(case, label), 1e-5 * pair[0])
            for (label, pair), (lx, se) in zip(true.items(), light)]


def case_5_6(program, side, error):
    l, h = 2.0 - 0.5 * side, 2.0 + 0.5 * side
    surfaces = {"S2": (0.3, [((l, l, 0), (h, l, 0), (h, h, 0), (l, h, 0))])}
    if side < 100.0:
        surfaces["S1"] = (0.0, [((0, 0, 0.5), (0, 0, 3), (4, 0, 3), (4, 0, 0.5)), ((0, 4, 3), (4, 4, 3), (4, 0, 3), (0, 0, 3))])
    altitude = math.radians(35.0)
    write_gltf(program.at("ground.gltf"), surfaces,
               ((-math.cos(altitude), 0.0, -math.sin(altitude)), 1e5 / math.sin(altitude)))
    program.bake("ground.gltf", "--max-edge", "0")
    points = [(place, truth.NORTH) for place in truth.WALL_5_6.values()]
    points += [(place, truth.DOWN) for place in truth.CEILING_5_6.values()]
    return reflected(f"5.6, {side:g} m", program, points, 0.3 * 1e5, truth.case_5_6(side), error)


def case_5_7(program):
    surfaces = {"S2": (0.6, [((4, 4, 0), (4, 4, 3), (0, 4, 3), (0, 4, 0))]),
                "S1": (0.0, [((0, 0, 0), (0, 0, 3), (4, 0, 3), (4, 0, 0)), ((0, 0, 0), (4, 0, 0), (4, 2.5, 0), (0, 2.5, 0))]),
                "obstruction": (0.0, box((0, 2.5, 0), (4, 2.7, 1)))}
    across = 0.26 / math.hypot(0.97, 0.26)
    write_gltf(program.at("wall.gltf"), surfaces, ((-0.97, 0.26, 0.0), 1e5 / across))
    program.bake("wall.gltf", "--max-edge", "0")
    points = [(place, truth.NORTH) for place in truth.WALL.values()]
    points += [(place, truth.UP) for place in truth.FLOOR_5_7.values()]
    return reflected("5.7", program, points, 0.6 * 1e5, truth.case_5_7(), "0.1%")


def case_5_8(program):
    write_ies(program.at("even.ies"), [0, 180], [0], [[ISOTROPIC, ISOTROPIC]])
    lamp = program.luminaires({"file": "even.ies", "place": (2, 2, 2)})
    rows = []
    for label, true in truth.case_5_8().items():
        write_gltf(program.at("cube.gltf"), room(4.0, float(label)))
        report = program.bake("cube.gltf", "--max-edge", "1", *lamp)
        lumens, error = received_by_all(report)
        direct = EFFICACY * report["solve"]["power_W"]["emitted"][1]
        rows.append(Row(f"reflectance {label}, lx", (lumens - direct) / 96.0, error / 96.0, true[0], others("5.8", label),
                        1e-5 * (true[0] + 10000.0 / 96.0)))
    return rows


def table_of(path):
    """Vertical angles and candela [plane][angle] of an IES file whose numbers follow TILT=NONE."""
    with open(path, encoding="utf-8") as file:
        words = file.read().split("TILT=NONE", 1)[1].split()
    multiplier, vertical, horizontal = float(words[2]), int(words[3]), int(words[4])
    factor = multiplier * float(words[10])
    numbers = [float(word) for word in words[13:]]
    angles, numbers = numbers[:vertical], numbers[vertical + horizontal:]
    return angles, [[factor * c for c in numbers[vertical * j:vertical * (j + 1)]] for j in range(horizontal)]


def closed_room(program):
    rows = []
    for name in ("led-panel", "linear-pendant", "spotlight", "wall-washer"):
        path = os.path.join(ROOT, "scenes", "luminaires", name + ".ies")
        flux = truth.linear_flux(*table_of(path))[0]
        write_gltf(program.at("cube.gltf"), room(4.0, 0.5))
        lamp = program.luminaires({"file": os.path.relpath(path, program.at("")), "place": (1.8, 2.1, 3.2)})
        lumens, error = received_by_all(program.bake("cube.gltf", "--max-edge", "0.5", *lamp))
        true = flux / (96.0 * 0.5)
        rows.append(Row(f"{name}, lx", lumens / 96.0, error / 96.0, true, f"{flux:.2f} lm", 1e-5 * true))
    return rows


NEAR = [((2.1, 2.2, 1.4), truth.UP), ((3.0, 1.5, 1.0), truth.UP), ((1.4, 2.3, 2.0), (1.0, 0.0, 0.0)),
        ((2.5, 3.2, 2.7), (0.0, -1.0, 0.0))]


def difference(name, first, second):
    """Rows of the ratio of two measurements at the same points; true: 1."""
    return [Row(f"{name}, point {i + 1}", a / b, math.hypot(ea / a, eb / b) * a / b, 1.0, "", 1e-5)
            for i, ((a, ea), (b, eb)) in enumerate(zip(first, second))]


def same_light(program):
    """Luminaires turned about the vertical, read from both formats, and divided."""
    write_gltf(program.at("room.gltf"), room())
    folder = os.path.relpath(os.path.join(ROOT, "scenes", "luminaires"), program.at(""))

    def light(*rows, points=None, by=program):
        by.bake("room.gltf", "--max-edge", "0", *by.luminaires(*rows))
        return by.probe(points or NEAR)

    washer = {"file": os.path.join(folder, "wall-washer.ies"), "place": (2, 2, 2.9)}
    straight = light(washer, by=program.other())
    angle = math.radians(53.0)

    def turned(v, middle=(2.0, 2.0)):
        x, y = v[0] - middle[0], v[1] - middle[1]
        return (middle[0] + x * math.cos(angle) - y * math.sin(angle), middle[1] + x * math.sin(angle) + y * math.cos(angle), v[2])

    points = [(turned(at), turned(normal, (0.0, 0.0))) for at, normal in NEAR]
    rows = difference("turned by 53 degrees", light({**washer, "rotation": 53.0}, points=points), straight)
    ldt = {"file": os.path.join(folder, "wall-washer.ldt"), "place": (2, 2, 2.9), "rotation": 90.0}
    rows += difference("EULUMDAT over IES", light(ldt), straight)
    angles, planes = [5.0 * i for i in range(37)], [15.0 * j for j in range(25)]
    candela = [[100.0 + 3.0 * a + 80.0 * math.cos(math.radians(c)) for a in angles] for c in planes]
    write_ies(program.at("whole.ies"), angles, planes, candela, size=(1.2, 0.6))
    write_ies(program.at("quarter.ies"), angles, planes, [[0.25 * x for x in row] for row in candela], size=(0.6, 0.3))
    quarters = [{"file": "quarter.ies", "place": (2 + 0.3 * i, 2 + 0.15 * j, 2.6)} for i in (-1, 1) for j in (-1, 1)]
    return rows + difference("four quarters over the whole", light(*quarters),
                             light({"file": "whole.ies", "place": (2, 2, 2.6)}, by=program.other()))


SETS = ("70/50/20", "70/30/20", "50/50/20", "50/30/20", "30/30/20")
ROOMS = {2: 0, 4: 8, 8: 14}  # sides of the square rooms in H, and their places in the table


def cie_190(program):
    """Dense radiosity of the square rooms against the printed factors F_T, which have three digits."""
    test = os.path.join(ROOT, "tests", "unit", "lighting", "room_transfer_test.cpp")
    with open(test, encoding="utf-8") as file:
        printed = re.search(r"published = \{\{(.*?)\}\}\};", file.read(), re.S).group(1)
    printed = [[int(n) for n in re.findall(r"\d+", line)] for line in printed.strip().splitlines()]
    rows = []
    for side, place in ROOMS.items():
        for index, name in enumerate(SETS):
            measured = []
            for source in ("floor", "wall", "ceiling"):
                ceiling, wall, floor = (float(r) / 100.0 for r in name.split("/"))
                faces = box((0, 0, 0), (side, side, 1), outside=False)
                areas = {"floor": side * side, "ceiling": side * side, "wall": 4.0 * side}
                kinds = {"floor": (floor, faces[:1]), "ceiling": (ceiling, faces[1:2]), "wall": (wall, faces[2:])}
                write_obj(program.at("box.obj"), {kind: (rho, rho / areas[kind] if kind == source else 0.0, quads)
                                                  for kind, (rho, quads) in kinds.items()})
                program.luxel.do("bake", program.at("box.obj"), "-o", program.at("box.vtkhdf"), "--method", "dense",
                                 "--elements", "faces", "--max-edge", "0", "--mesh-error", "none", "--sky", "none", "--quiet")
                surfaces = program.luxel.run("measure", program.at("box.vtkhdf"))["surfaces"]
                lux = next(s for s in surfaces if s["name"] == "wall")["mean_lx"]["value"]
                measured.append(lux / EFFICACY * areas["wall"])
            for source, value, true in zip(("floor", "wall", "ceiling"), measured, printed[index][3 * place:3 * place + 3]):
                rows.append(Row(f"{side} H × {side} H, {name}, from {source}", value, 0.0, 0.001 * true, "", bound=0.0005))
    return rows


def csv_numbers(path):
    with open(path, encoding="utf-8") as file:
        return [[float("nan") if word.startswith("<") else float(word) for word in line.strip().split(",")]
                for line in file if line.strip()]


def ugr(program, shared):
    """[name, of what, figures, largest difference, mean difference] of UGR tables; the last is Relux against DIALux."""
    folder = os.path.join(shared, "scenes", "ies", "eulumdat-ugr")

    def compare(a, b):
        apart = [x - y for line, other in zip(a, b) for x, y in zip(line, other) if x == x and y == y]
        return len(apart), max(abs(d) for d in apart), sum(apart) / len(apart)

    found = []
    for sample in ("01", "02", "04", "05", "11"):
        file = os.path.join(folder, f"sample_{sample}.ldt")
        references = [(who, 0.25, f"ugr_table_{sample}_{who}.csv") for who in ("Relux", "Dialux")]
        if sample == "11":
            references.append(("CIE 190", 1.0, "ugr_table_11_cie190.csv"))
        for who, spacing, name in references:
            program.luxel.do("ugr-table", file, "--spacing", spacing, "-o", program.at("ugr.json"), "--quiet")
            with open(program.at("ugr.json"), encoding="utf-8") as json_file:
                table = json.load(json_file)
            lines = [a + b for a, b in zip(table["crosswise"], table["endwise"])]
            lines = [[float("nan") if x is None else x for x in line] for line in lines]
            found.append((sample, who.replace("Dialux", "DIALux"), *compare(lines, csv_numbers(os.path.join(folder, name)))))
        both = [csv_numbers(os.path.join(folder, f"ugr_table_{sample}_{who}.csv")) for who in ("Relux", "Dialux")]
        found.append((sample, "Relux against DIALux", *compare(*both)))
    return found
