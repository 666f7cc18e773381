# SPDX-License-Identifier: Apache-2.0
"""The true values of the daylight cases of CIE 171:2006, each derived twice. Printed by `tools/make_validation.py truth`.

x, y, z in metres, z is up. Values are percentages of the horizontal illuminance of open ground by the sky. First
derivation: Gauss rules over the area of the opening. Second: Gauss rules over azimuth and elevation, whose limits are the
edges of the opening. Each function returns {label: {sky: (first, second)}}; skies are types of the CIE general sky, and 16
the traditional overcast sky.
"""
import functools
import math

from validation.quadrature import RULE, dot, integral, panels

UP, DOWN, NORTH, SOUTH = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0)
ELEVATION = math.radians(60.0)  # of the sun, which stands in front of the opening or of the wall
SKIES = tuple(range(1, 17))
ALBEDO, MASK = 0.3, 0.3  # reflectance of the ground and of the masks
INDEX, TRANSMITTANCE = 1.52, 0.88  # of the panes: refractive index, and transmittance at normal incidence

# ISO 15469: gradation a, b and indicatrix c, d, e of the types 1 to 15.
TYPES = ((4, -.7, 0, -1, 0), (4, -.7, 2, -1.5, .15), (1.1, -.8, 0, -1, 0), (1.1, -.8, 2, -1.5, .15), (0, -1, 0, -1, 0),
         (0, -1, 2, -1.5, .15), (0, -1, 5, -2.5, .3), (0, -1, 10, -3, .45), (-1, -.55, 2, -1.5, .15),
         (-1, -.55, 5, -2.5, .3), (-1, -.55, 10, -3, .45), (-1, -.32, 10, -3, .45), (-1, -.32, 16, -3, .3),
         (-1, -.15, 16, -3, .3), (-1, -.15, 24, -2.8, .15))


def sun_towards(y, elevation=ELEVATION):
    """The sun's direction, with a horizontal part along +y or -y."""
    return (0.0, y * math.cos(elevation), math.sin(elevation))


def shape(kind, direction, sun):
    """Luminance without the scale; direction: unit, above the horizon."""
    if kind == 16:
        return 1.0 + 2.0 * direction[2]
    a, b, c, d, e = TYPES[kind - 1]
    height = max(direction[2], 0.0)
    cosine = max(-1.0, min(1.0, dot(direction, sun)))
    gradation = 1.0 + (a * math.exp(b / height) if height > 1e-9 else 0.0)
    return gradation * (1.0 + c * (math.exp(d * math.acos(cosine)) - math.exp(0.5 * d * math.pi)) + e * cosine * cosine)


def towards(azimuth, elevation):
    """Azimuth from +y to +x."""
    return (math.cos(elevation) * math.sin(azimuth), math.cos(elevation) * math.cos(azimuth), math.sin(elevation))


def pieces(low, high, width, *breaks):
    """Breaks from low to high, no further apart than a width."""
    ends = [low, *sorted(b for b in breaks if low < b < high), high]
    found = [low]
    for a, b in zip(ends, ends[1:]):
        n = max(1, math.ceil((b - a) / width - 1e-9))
        found += [a + (b - a) * i / n for i in range(1, n + 1)]
    return found


def nodes(breaks):
    return [(0.5 * (a + b) + 0.5 * (b - a) * x, 0.5 * (b - a) * weight) for a, b in zip(breaks, breaks[1:])
            for x, weight in RULE]


def horizontal(kind, sun_elevation=ELEVATION):
    """Illuminance of open ground, by the shape: azimuth and elevation around the zenith; half of the symmetric sky."""
    sun, total = sun_towards(1.0, sun_elevation), 0.0
    for elevation, w in nodes(pieces(0.0, 0.5 * math.pi, 0.2, sun_elevation)):
        ring = integral(lambda azimuth, e=elevation: shape(kind, towards(azimuth, e), sun),
                        pieces(0.0, math.pi, 0.4, 0.05, 0.15))
        total += w * 2.0 * ring * math.sin(elevation) * math.cos(elevation)
    return total


def horizontal_by_disk(kind, sun_elevation=ELEVATION):
    """The same in the projection of Nusselt: the integral of the shape over the unit disk, x from the middle."""
    sun = sun_towards(1.0, sun_elevation)
    bright = sun[1]

    def row(y):
        half = math.sqrt(1.0 - y * y)
        return 2.0 * integral(lambda angle: half * math.cos(angle) * shape(
            kind, (half * math.sin(angle), y, half * math.cos(angle)), sun), pieces(0.0, 0.5 * math.pi, 0.4, 0.05, 0.15))

    return integral(lambda t: math.cos(t) * row(math.sin(t)),
                    pieces(-0.5 * math.pi, 0.5 * math.pi, 0.2, math.asin(bright)))


def over_zenith(kind, sun_elevation):
    """E_h / L_z, by both."""
    zenith = shape(kind, UP, sun_towards(1.0, sun_elevation))
    return horizontal(kind, sun_elevation) / zenith, horizontal_by_disk(kind, sun_elevation) / zenith


HORIZONTAL = {}


def scale(kind):
    """Luminance over shape, of a sky that gives 100 (per cent) on open ground."""
    if kind not in HORIZONTAL:
        HORIZONTAL[kind] = horizontal(kind)
    return 100.0 / HORIZONTAL[kind]


GROUND = 100.0 * ALBEDO / math.pi  # its luminance


def slab(cosine):
    """Transmittance of a pane at an angle of incidence: Fresnel's amplitudes, and every reflection between the faces."""
    def one(cosine, a):
        inside = math.sqrt(1.0 - (1.0 - cosine * cosine) / INDEX ** 2)
        a = a ** (1.0 / inside)
        total = 0.0
        for r in ((cosine - INDEX * inside) / (cosine + INDEX * inside),
                  (INDEX * cosine - inside) / (INDEX * cosine + inside)):
            total += 0.5 * (1.0 - r * r) ** 2 * a / (1.0 - (r * r * a) ** 2)
        return total

    global ABSORPTION  # of the glass, at normal incidence
    if ABSORPTION is None:
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if one(1.0, middle) < TRANSMITTANCE else (low, middle)
        ABSORPTION = low
    return one(cosine, ABSORPTION)


ABSORPTION = None


def slab_by_angles(cosine):
    """The same by Snell's angles, and the sum of the rays that leave after 0, 2, 4 ... reflections."""
    outside = math.acos(cosine)
    inside = math.asin(math.sin(outside) / INDEX)
    if outside < 1e-6:
        faces = [((INDEX - 1.0) / (INDEX + 1.0)) ** 2] * 2
    else:
        faces = [(math.sin(outside - inside) / math.sin(outside + inside)) ** 2,
                 (math.tan(outside - inside) / math.tan(outside + inside)) ** 2]
    slab(1.0)
    path = math.exp(math.log(ABSORPTION) / math.cos(inside))
    return sum(0.5 * (1.0 - r) ** 2 * path * sum((r * path) ** (2 * i) for i in range(200)) for r in faces)


class Sum:
    """Adds samples of the light from directions, per sky."""

    def __init__(self, skies, sun, glazed):
        self.skies, self.sun, self.glazed = skies, sun, glazed
        self.totals = {kind: 0.0 for kind in skies}

    def add(self, direction, weight, across, luminance=None):
        """weight: projected solid angle. luminance: of what is there in place of the sky or of the ground, {sky: value}."""
        if self.glazed:
            weight *= slab(abs(across))
        for kind in self.skies:
            if luminance is not None:
                value = luminance[kind]
            else:
                value = GROUND if direction[2] < 0.0 else scale(kind) * shape(kind, direction, self.sun)
            self.totals[kind] += weight * value


def by_area(point, normal, opening, skies, sun, glazed=False, beyond=None, breaks=()):
    """opening: (axis, coordinate, u, v). beyond(place): the luminance of what hides the sky there, or None; breaks: v at
    which that changes."""
    axis, at, u, v = opening
    others = [i for i in range(3) if i != axis]
    found = Sum(skies, sun, glazed)
    d = abs(at - point[axis])
    foot = [point[i] for i in others]
    steps = (at - point[axis]) / sun[axis] if sun[axis] else -1.0
    sun_at = [foot[i] + steps * sun[others[i]] for i in (0, 1)] if steps > 0.0 else foot

    def cells(low, high, near, bright):
        fine = set(panels(low, high, near, max(0.02, 0.5 * d))) | set(panels(low, high, bright, 0.04 * d))
        return sorted(fine)

    columns = nodes(cells(*u, foot[0], sun_at[0]))
    rows = sorted(set(cells(*v, foot[1], sun_at[1])) | {b for b in (*breaks, foot[1]) if v[0] < b < v[1]})
    for y, wy in nodes(rows):
        for x, wx in columns:
            place = [0.0, 0.0, 0.0]
            place[axis], place[others[0]], place[others[1]] = at, x, y
            way = tuple(q - p for p, q in zip(point, place))
            size = math.sqrt(dot(way, way))
            direction = tuple(c / size for c in way)
            across = abs(direction[axis])
            found.add(direction, wx * wy * dot(direction, normal) * across / size ** 2, across,
                      beyond(place) if beyond else None)
    return found.totals


def by_angles(point, normal, opening, skies, sun, glazed=False, limits=None):
    """The same by azimuth and elevation. limits(azimuth, low, high): the part of the elevations in which the sky is seen."""
    axis, at, u, v = opening
    found = Sum(skies, sun, glazed)
    if axis == 2:
        corners = [(x - point[0], y - point[1]) for x in u for y in v]
        inside = u[0] < point[0] < u[1] and v[0] < point[1] < v[1]
    else:
        corners = [(x - point[0], at - point[1]) for x in u]
        inside = False
    # Measured from the middle of the opening, so that no opening lies across the jump of the angle.
    middle = (0.5 * (u[0] + u[1]) - point[0], (0.5 * (v[0] + v[1]) if axis == 2 else at) - point[1])
    ahead = 0.0 if inside else math.atan2(*middle)

    def turned(x, y):
        return (math.atan2(x, y) - ahead + math.pi) % (2.0 * math.pi) - math.pi

    azimuths = [turned(*c) for c in corners]
    low, high = (-math.pi, math.pi) if inside else (min(azimuths), max(azimuths))
    bright = turned(sun[0], sun[1])
    for turn, wa in nodes(pieces(low, high, 0.3, *azimuths, *(bright + s for s in (-0.2, -0.05, 0.0, 0.05, 0.2)))):
        azimuth = ahead + turn
        step = (math.sin(azimuth), math.cos(azimuth))
        if axis == 2:
            near, far = 0.0, math.inf
            for (a, b), p, s in zip((u, v), point, step):
                if abs(s) > 1e-14:
                    near, far = max(near, min((a - p) / s, (b - p) / s)), min(far, max((a - p) / s, (b - p) / s))
            if far <= near:
                continue
            ends = math.atan2(at - point[2], far), math.atan2(at - point[2], near)
        else:
            distance = (at - point[1]) / step[1]
            ends = tuple(math.atan2(z - point[2], distance) for z in v)
        if limits:
            ends = limits(azimuth, *ends)
        if ends[1] <= ends[0]:
            continue
        for elevation, we in nodes(pieces(*ends, 0.3, 0.0, ELEVATION, ELEVATION - 0.1, ELEVATION + 0.1)):
            direction = towards(azimuth, elevation)
            found.add(direction, wa * we * dot(direction, normal) * math.cos(elevation), direction[axis])
    return found.totals


def pairs(first, second):
    return {kind: (first[kind], second[kind]) for kind in first}


WALL = {label: (2.0, 0.0, 2.75 - 0.5 * i) for i, label in enumerate("ABCDEF")}
FLOOR = {label: (2.0, 0.25 + 0.5 * i, 0.0) for i, label in enumerate("GHIJKLMN")}
FAR_WALL = {label: (2.0, 4.0, 2.75 - 0.5 * i) for i, label in enumerate("ABCDEF")}
FAR_FLOOR = {label: (2.0, 3.75 - 0.5 * i, 0.0) for i, label in enumerate("GHIJKLMN")}
FAR_CEILING = {label + "'": (2.0, 3.75 - 0.5 * i, 3.0) for i, label in enumerate("GHIJKLMN")}
MASK_FLOOR = {label: (2.0, 3.75 - 0.5 * i, 0.0) for i, label in enumerate("ABCDEFGH")}
ROOF = {"1 × 1 m": (2, 3.0, (1.5, 2.5), (1.5, 2.5)), "4 × 4 m": (2, 3.0, (0.0, 4.0), (0.0, 4.0))}
FACADE = {"2 × 1 m": (1, 0.0, (1.0, 3.0), (1.0, 2.0)), "4 × 3 m": (1, 0.0, (0.0, 4.0), (0.0, 3.0))}


def case_5_5():
    """Transmittance at angles of incidence, in degrees; over that at normal incidence."""
    found = {}
    for angle in range(0, 90, 10):
        cosine = math.cos(math.radians(angle))
        found[str(angle)] = (slab(cosine) / TRANSMITTANCE, slab_by_angles(cosine) / TRANSMITTANCE)
    return found


def points_of_roof():
    """{label: (place, normal)} of 5.9 and 5.10."""
    return {**{label: (at, NORTH) for label, at in WALL.items()}, **{label: (at, UP) for label, at in FLOOR.items()}}


def points_of_facade():
    """{label: (place, normal)} of 5.11 and 5.12."""
    return {**{label: (at, SOUTH) for label, at in FAR_WALL.items()}, **{label: (at, UP) for label, at in FAR_FLOOR.items()},
            **{label: (at, DOWN) for label, at in FAR_CEILING.items()}}


@functools.cache
def roof(size, glazed, skies=SKIES):
    """5.9 and 5.10. The sun stands towards +y, in front of the wall y = 0 of the points A to F."""
    sun = sun_towards(1.0)
    return {label: pairs(by_area(at, normal, ROOF[size], skies, sun, glazed),
                         by_angles(at, normal, ROOF[size], skies, sun, glazed))
            for label, (at, normal) in points_of_roof().items()}


@functools.cache
def facade(size, glazed, skies=SKIES):
    """5.11 and 5.12. The sun stands towards -y, outside of the opening."""
    sun = sun_towards(-1.0)
    return {label: pairs(by_area(at, normal, FACADE[size], skies, sun, glazed),
                         by_angles(at, normal, FACADE[size], skies, sun, glazed))
            for label, (at, normal) in points_of_facade().items()}


@functools.cache
def overhang(depth, skies=SKIES):
    """5.13. Underside of a continuous overhang at z = 3, y from -depth to 0, lit by the ground before a continuous
    façade."""
    sun, opening, found = sun_towards(-1.0), FACADE["2 × 1 m"], {}

    def luminance(y):
        return MASK * GROUND * 0.5 * (1.0 - y / math.hypot(y, 3.0))

    for label, at in MASK_FLOOR.items():
        edge = 3.0 * at[1] / (at[1] + depth)  # height in the opening above which the overhang is seen

        def beyond(place, at=at, edge=edge):
            return dict.fromkeys(skies, luminance(at[1] * (1.0 - 3.0 / place[2]))) if place[2] > edge else None

        def limits(azimuth, low, high, at=at):
            return low, min(high, math.atan2(3.0, (at[1] + depth) / -math.cos(azimuth)))

        first = by_area(at, UP, opening, skies, sun, False, beyond, (edge,))
        second = by_angles(at, UP, opening, skies, sun, False, limits)
        # The overhang by its area: at y, the opening shows it between x = 2 - half and 2 + half.
        low, high = max(-depth, at[1] * (1.0 - 3.0 / 1.0)), at[1] * (1.0 - 3.0 / 2.0)
        mask = 0.0
        if high > low:
            def strip(y, at=at):
                half = (at[1] - y) / at[1]
                return luminance(y) * 2.0 * integral(lambda x: 9.0 / (x * x + (at[1] - y) ** 2 + 9.0) ** 2,
                                                     pieces(0.0, half, 0.5))
            mask = integral(strip, pieces(low, high, 0.25))
        found[label] = pairs(first, {kind: value + mask for kind, value in second.items()})
    return found


DEPTH = 1000.0  # of the building's black roof


def screen_luminance(height, skies, second=False):
    """Luminance of the screen of 5.14 at a height: {sky: value}. Façade and roof are black, the ground is not."""
    sun, found = sun_towards(-1.0), {}
    over = math.atan2(3.0 - height, 6.0)  # of the façade's upper edge, in the plane across it
    lowest = max(0.0, over)
    ground = 0.5 * (1.0 - math.sin(math.atan2(height, 6.0)))
    if height > 3.0:
        ground += 0.5 * math.sin(math.atan2(height - 3.0, 6.0 + DEPTH))
    for kind in skies:
        if second:  # by the azimuth from +y, and the elevation above the slanted edge
            def column(azimuth, kind=kind):
                edge = math.atan(math.tan(lowest) * math.cos(azimuth))
                return math.cos(azimuth) * integral(lambda e: math.cos(e) ** 2 * shape(kind, towards(azimuth, e), sun),
                                                    pieces(edge, 0.5 * math.pi, 0.8))
            sky = 2.0 * integral(column, pieces(0.0, 0.5 * math.pi, 0.8))
        else:  # by the angle across the façade, and the angle along it
            def across(angle, kind=kind):
                return math.cos(angle) * 2.0 * integral(lambda s: math.cos(s) ** 2 * shape(
                    kind, (math.sin(s), math.cos(s) * math.cos(angle), math.cos(s) * math.sin(angle)), sun),
                    pieces(0.0, 0.5 * math.pi, 0.8))
            sky = integral(across, pieces(lowest, 0.5 * math.pi, 0.8))
        found[kind] = MASK * (scale(kind) * sky / math.pi + GROUND * ground)
    return found


@functools.cache
def screen(height, skies=SKIES):
    """5.14. A continuous screen of reflectance 0.3 at y = -6, as high as this, before a continuous façade."""
    sun, opening, found = sun_towards(-1.0), FACADE["2 × 1 m"], {}
    for label, at in MASK_FLOOR.items():
        edge = height * at[1] / (at[1] + 6.0)  # height in the opening below which the screen is seen
        cache = {}

        def beyond(place, at=at, edge=edge, cache=cache):
            if place[2] >= edge:
                return None
            if place[2] not in cache:
                cache[place[2]] = screen_luminance(place[2] * (at[1] + 6.0) / at[1], skies)
            return cache[place[2]]

        def limits(azimuth, low, high, at=at):
            return max(low, math.atan2(height, (at[1] + 6.0) / -math.cos(azimuth))), high

        bend = 3.0 * at[1] / (at[1] + 6.0)  # the screen's luminance has a kink at 3 m
        first = by_area(at, UP, opening, skies, sun, False, beyond, (edge, bend))
        second = by_angles(at, UP, opening, skies, sun, False, limits)
        ratio = (at[1] + 6.0) / at[1]
        low, high = ratio, min(height, 2.0 * ratio)
        if high > low:
            for z, w in nodes(pieces(low, high, 1.0, 3.0)):
                half, d = ratio, at[1] + 6.0
                strip = 2.0 * integral(lambda x, z=z: z * d / (x * x + z * z + d * d) ** 2, pieces(0.0, half, 2.0))
                seen = screen_luminance(z, skies, True)
                for kind in skies:
                    second[kind] += w * strip * seen[kind]
        found[label] = pairs(first, second)
    return found


DETAIL = (16, 12)  # the skies of the tables


def groups(skies=DETAIL):
    """{name: function that returns {label: {sky: (first, second)}}}."""
    found = {}
    for glazed, case in ((False, "5.9"), (True, "5.10")):
        for size in ROOF:
            found[f"{case}, {size}"] = lambda size=size, glazed=glazed: roof(size, glazed, skies)
    for glazed, case in ((False, "5.11"), (True, "5.12")):
        for size in FACADE:
            found[f"{case}, {size}"] = lambda size=size, glazed=glazed: facade(size, glazed, skies)
    for depth in (0.5, 1.0, 2.0):
        found[f"5.13, {depth} m"] = lambda depth=depth: overhang(depth, skies)
    for height in (3.0, 6.0, 9.0):
        found[f"5.14, {height:g} m"] = lambda height=height: screen(height, skies)
    return found
