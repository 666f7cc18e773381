# SPDX-License-Identifier: Apache-2.0
"""The true values of the electric cases of CIE 171:2006, each derived twice. Printed by `tools/make_validation.py truth`.

x, y, z in metres, z is up. The printed document is not public. Geometry as validation reports describe it; where they do
not, it is stated here. Each function returns {label: (closed form, second derivation)}.
"""
import math

from validation.quadrature import area_factor, dot, integral, length, minus, polygon_factor, rectangle

UP, DOWN, NORTH = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0)

# 5.2: a point of 1000 cd straight down whose intensity falls as the cosine, 3 m above a surface.
CASE_5_2 = {label: (x, y, 0.0) for label, x, y in (
    ("A", 0.0, 0.0), ("B", 0.5, 0.0), ("C", 1.0, 0.0), ("D", 1.5, 0.0), ("E", 0.5, 0.5), ("F", 1.0, 0.5), ("G", 1.5, 0.5),
    ("H", 1.0, 1.0), ("I", 1.5, 1.0), ("J", 1.5, 1.5))}

# 5.3: wall points A to F and floor points G to J on the mid-line of a room of 4 x 4 x 3 m.
WALL = {label: (2.0, 0.0, 2.75 - 0.5 * i) for i, label in enumerate("ABCDEF")}
FLOOR = {label: (2.0, 0.25 + 0.5 * i, 0.0) for i, label in enumerate("GHIJ")}

# 5.6: S2 lies on the ground around (2, 2), the points are on a wall at y = 0 and, G to J, on a ceiling at z = 3. Sides of
# S2, m: the second is that of the reports, the first and the third are chosen here.
SIDES_5_6 = (0.5, 4.0, 500.0)
WALL_5_6 = {label: (2.0, 0.0, 0.75 + 0.5 * i) for i, label in enumerate("BCDEF")}
CEILING_5_6 = {label: (2.0, 0.25 + 0.5 * i, 3.0) for i, label in enumerate("GHIJ")}

# 5.7: S2 is the wall y = 4, 4 m wide and 3 m high; a black obstruction of the same width stands from y = 2.5 to 2.7, 1 m
# high. Points on the wall y = 0 and on the floor.
FLOOR_5_7 = {label: (2.0, 0.25 + 0.5 * i, 0.0) for i, label in enumerate("GHIJK")}

# 5.8
REFLECTANCES_5_8 = (0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.95)


def case_5_2():
    """Inverse square; and a disk of 1 mm radius, by its configuration factor (Howell B-15)."""
    found = {}
    for label, point in CASE_5_2.items():
        aside, height, radius = math.hypot(point[0], point[1]), 3.0, 1e-3
        distance = math.hypot(aside, height)
        closed = 1000.0 * height ** 2 / distance ** 4
        if aside == 0.0:
            factor = radius ** 2 / (radius ** 2 + height ** 2)
        else:
            h, r = height / aside, radius / aside
            z = 1.0 + h * h + r * r
            root = math.sqrt(z * z - 4.0 * r * r)
            # (1 - (z - 2 r^2) / root) / 2 without cancellation
            factor = 0.5 * (4.0 * r * r * (z - 1.0 - r * r)) / (root * (root + z - 2.0 * r * r))
        found[label] = (closed, 1000.0 / radius ** 2 * factor)
    return found


def case_5_3():
    source = (2, 3.0, (1.5, 2.5), (1.5, 2.5))
    found = {}
    for points, normal in ((WALL, NORTH), (FLOOR, UP)):
        for label, point in points.items():
            found[label] = tuple(1000.0 * math.pi * f for f in (
                polygon_factor(point, normal, rectangle(*source)), area_factor(point, normal, *source)))
    return found


def disk_on_axis():
    """A disk of 0.8 m and 1000 cd, on its axis: closed form; and the integral over rings."""
    found = {}
    for d in (0.2, 0.5, 1.0, 2.0):
        rings = integral(lambda r, d=d: 2.0 * r * d * d / (r * r + d * d) ** 2, (0.0, 0.1, 0.2, 0.4))
        found[f"{d} m"] = (1000.0 / (d * d + 0.16), 1000.0 / 0.16 * rings)
    return found


def solid_angle(point, axis, at, u, v):
    """Solid angle of a rectangle; by the corners' arc tangents."""
    others = [i for i in range(3) if i != axis]
    d = abs(at - point[axis])

    def corner(a, b):
        return math.atan(a * b / (d * math.sqrt(a * a + b * b + d * d)))

    p, q = point[others[0]], point[others[1]]
    return abs(corner(u[1] - p, v[1] - q) - corner(u[0] - p, v[1] - q) - corner(u[1] - p, v[0] - q) +
               corner(u[0] - p, v[0] - q))


def solid_angle_by_rule(point, axis, at, u, v):
    others = [i for i in range(3) if i != axis]
    d, p, q = abs(at - point[axis]), point[others[0]], point[others[1]]
    return integral(lambda y: integral(lambda x: d / ((x - p) ** 2 + (y - q) ** 2 + d * d) ** 1.5,
                                       (u[0], 0.5 * (u[0] + u[1]), u[1])), (v[0], 0.5 * (v[0] + v[1]), v[1]))


# 5.4: 10,000 lm in all directions in the middle of a black room of 4 x 4 x 3 m; and the same with an opening of 2 x 1 m in
# the wall y = 0. Centre of the lamp: that of the room in the first; (1.5, 1.2, 1.9) in the second, chosen here.
LAMP_5_4, ASIDE_5_4 = (2.0, 2.0, 1.5), (1.5, 1.2, 1.9)
OPENING_5_4 = (1, 0.0, (1.0, 3.0), (1.0, 2.0))


def case_5_4():
    found = {}
    for label, face in (("floor", (2, 0.0, (0.0, 4.0), (0.0, 4.0))), ("wall", (1, 0.0, (0.0, 4.0), (0.0, 3.0)))):
        found[label] = tuple(10000.0 / (4.0 * math.pi) * angle for angle in (
            solid_angle(LAMP_5_4, *face), solid_angle_by_rule(LAMP_5_4, *face)))
    found["room"] = (10000.0, 2.0 * found["floor"][1] + 4.0 * found["wall"][1])
    found["opening"] = tuple(10000.0 / (4.0 * math.pi) * angle for angle in (
        solid_angle(ASIDE_5_4, *OPENING_5_4), solid_angle_by_rule(ASIDE_5_4, *OPENING_5_4)))
    found["room with an opening"] = tuple(10000.0 - x for x in found["opening"])
    return found


def case_5_6(side):
    """E / (rho E of the ground), per cent."""
    ground = (2, 0.0, (2.0 - 0.5 * side, 2.0 + 0.5 * side), (2.0 - 0.5 * side, 2.0 + 0.5 * side))
    found = {}
    for points, normal in ((WALL_5_6, NORTH), (CEILING_5_6, DOWN)):
        for label, point in points.items():
            # A wall sees the ground in front of it only.
            seen = ground if normal == DOWN else (2, 0.0, ground[2], (max(0.0, ground[3][0]), ground[3][1]))
            found[label] = tuple(100.0 * f for f in (polygon_factor(point, normal, rectangle(*seen)),
                                                     area_factor(point, normal, *seen)))
    return found


def passes(point, place, low=(0.0, 2.5, -1.0), high=(4.0, 2.7, 1.0)):
    """Whether the segment misses the box of the obstruction, which reaches below the floor here: slabs."""
    begin, end = 0.0, 1.0
    for p, q, l, h in zip(point, place, low, high):
        if abs(q - p) < 1e-12:
            if not l < p < h:
                return True
            continue
        a, b = sorted(((l - p) / (q - p), (h - p) / (q - p)))
        begin, end = max(begin, a), min(end, b)
    return begin >= end


def case_5_7():
    """E / (rho E of the wall S2), per cent. The obstruction hides S2 below the line over its upper edges."""
    found = {}
    for points, normal in ((WALL, NORTH), (FLOOR_5_7, UP)):
        for label, point in points.items():
            lowest = max(0.0, *(point[2] + (1.0 - point[2]) * (4.0 - point[1]) / (edge - point[1])
                                for edge in (2.5, 2.7)))
            closed = 0.0
            if lowest < 3.0:
                closed = polygon_factor(point, normal, rectangle(1, 4.0, (0.0, 4.0), (lowest, 3.0)))
            rule = area_factor(point, normal, 1, 4.0, (0.0, 4.0), (0.0, 3.0),
                               lambda place, point=point: passes(point, place))
            found[label] = (100.0 * closed, 100.0 * rule)
    return found


def case_5_8():
    """Mean over the faces of a 4 m cube of the indirect illuminance: power balance; and bounces between six faces with
    the factors of opposite and adjacent squares in closed form (Howell C-11, C-14)."""
    root2, root3 = math.sqrt(2.0), math.sqrt(3.0)
    opposite = 2.0 / math.pi * (math.log(math.sqrt(4.0 / 3.0)) + 2.0 * root2 * math.atan(1.0 / root2) - math.pi / 2.0)
    adjacent = 1.0 / math.pi * (math.pi / 2.0 - root2 * math.atan(1.0 / root2) + 0.25 * math.log(0.75))
    found = {}
    for rho in REFLECTANCES_5_8:
        faces = [10000.0 / 96.0] * 6
        total, arriving = 0.0, faces
        while max(arriving) > 1e-12:
            leaving = [rho * e for e in arriving]
            arriving = [opposite * leaving[i ^ 1] + adjacent * math.fsum(leaving[j] for j in range(6) if j // 2 != i // 2)
                        for i in range(6)]
            total += math.fsum(arriving) / 6.0
        found[f"{rho}"] = (rho * 10000.0 / (96.0 * (1.0 - rho)), total)
    return found


def linear_flux(vertical, candela):
    """lm of a table [plane][angle] of planes that are equally spaced and cover a turn or, by symmetry, a part of it:
    intensity linear in the angle, in closed form; and by Gauss rules."""
    planes = len(candela)
    weights = [1.0] if planes == 1 else [(0.5 if j in (0, planes - 1) else 1.0) / (planes - 1) for j in range(planes)]
    mean = [math.fsum(w * plane[i] for w, plane in zip(weights, candela)) for i in range(len(vertical))]
    closed = rule = 0.0
    for a, b, low, high in zip(vertical, vertical[1:], mean, mean[1:]):
        a, b = math.radians(a), math.radians(b)
        slope = (high - low) / (b - a)
        closed += low * math.cos(a) - high * math.cos(b) + slope * (math.sin(b) - math.sin(a))
        rule += integral(lambda x, a=a, low=low, slope=slope: (low + slope * (x - a)) * math.sin(x), (a, b))
    return 2.0 * math.pi * closed, 2.0 * math.pi * rule


CASES = {"5.2": case_5_2, "5.3": case_5_3, "disk": disk_on_axis, "5.4": case_5_4,
         **{f"5.6, S2 of {side:g} m": lambda side=side: case_5_6(side) for side in SIDES_5_6},
         "5.7": case_5_7, "5.8": case_5_8}


def disagreement(pair):
    """Relative difference of the two derivations."""
    closed, second = pair
    return abs(closed - second) / max(abs(closed), 1e-9)
