# SPDX-License-Identifier: Apache-2.0
"""Configuration factors from a point to rectangles, by two methods that have nothing in common: Lambert's closed form
over the edges of a polygon, and Gauss-Legendre rules over its area."""
import math


def gauss(count):
    """Nodes and weights of the Gauss-Legendre rule on [-1, 1]; Newton's method on the Legendre polynomial."""
    rule = []
    for i in range(count):
        x = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(100):
            p, before = 1.0, 0.0
            for k in range(count):
                p, before = ((2 * k + 1) * x * p - k * before) / (k + 1), p
            slope = count * (x * p - before) / (x * x - 1.0)
            step = p / slope
            x -= step
            if abs(step) < 1e-15:
                break
        rule.append((x, 2.0 / ((1.0 - x * x) * slope * slope)))
    return rule


RULE = gauss(16)


def integral(function, breaks):
    """Integral of a function that is smooth between the breaks."""
    total = 0.0
    for low, high in zip(breaks, breaks[1:]):
        half, middle = 0.5 * (high - low), 0.5 * (high + low)
        total += half * math.fsum(weight * function(middle + half * x) for x, weight in RULE)
    return total


def panels(low, high, near, step):
    """Breaks from low to high that double their distance away from `near`, where the integrand is steepest."""
    breaks = {low, high}
    if low < near < high:
        breaks.add(near)
    for sign in (-1.0, 1.0):
        width = step
        while width < 2.0 * (high - low) + abs(near):
            if low < near + sign * width < high:
                breaks.add(near + sign * width)
            width *= 2.0
    return sorted(breaks)


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def polygon_factor(point, normal, corners):
    """Lambert 1760: half the sum over the edges of the angle that an edge subtends times the cosine between the normal
    and that of the edge's plane, over pi. The whole polygon lies in front of the point."""
    ways = [minus(corner, point) for corner in corners]
    total = 0.0
    for a, b in zip(ways, ways[1:] + ways[:1]):
        across = cross(a, b)
        size = length(across)
        if size > 0.0:
            total += math.atan2(size, dot(a, b)) * dot(across, normal) / size
    return abs(total) / (2.0 * math.pi)


def rectangle(axis, at, u, v):
    """Corners of a rectangle at right angles to an axis (0 x, 1 y, 2 z), at a coordinate; u, v: (low, high) of the other
    two axes, in their order."""
    corners = [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])]
    return [tuple([*c[:axis], at, *c[axis:]]) for c in corners]


def area_factor(point, normal, axis, at, u, v, visible=lambda place: True):
    """The same factor as an integral of cos cos / (pi d^2) over the rectangle. `visible` may hide all places of it on one
    side of a line of constant v, which bisection finds."""
    others = [i for i in range(3) if i != axis]

    def place(x, y):
        found = [0.0, 0.0, 0.0]
        found[axis], found[others[0]], found[others[1]] = at, x, y
        return tuple(found)

    def value(x, y):
        way = minus(place(x, y), point)
        squared = dot(way, way)
        return dot(way, normal) * abs(way[axis]) / (math.pi * squared * squared)

    step = max(0.05, 0.5 * abs(at - point[axis]))
    across = 0.5 * (u[0] + u[1])
    breaks = panels(v[0], v[1], point[others[1]], step)
    ends = [visible(place(across, y)) for y in v]
    if not any(ends):
        return 0.0
    if not all(ends):
        hidden, seen = (v[0], v[1]) if ends[1] else (v[1], v[0])
        for _ in range(100):
            middle = 0.5 * (hidden + seen)
            if visible(place(across, middle)):
                seen = middle
            else:
                hidden = middle
        low, high = (seen, v[1]) if ends[1] else (v[0], seen)
        breaks = sorted({low, high, *(b for b in breaks if low < b < high)})
    columns = panels(u[0], u[1], point[others[0]], step)
    return integral(lambda y: integral(lambda x: value(x, y), columns), breaks)
