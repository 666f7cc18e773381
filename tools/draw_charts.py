#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws what luxel-bench measured: draw_charts.py BENCH.json FOLDER.

One SVG a scene (error-NAME.svg: true error against processor time, each method a line), cost-per-patch.svg,
time-against-polygons.svg, time-against-lamps.svg and one error-against-patches-NAME.svg a scene, from those sections that the file has. Their names are printed.
Both axes are logarithmic; each point says its numbers when pointed at; light and dark pages are both served. The same
file gives the same bytes.
"""
import json
import math
import os
import re
import sys
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BOTTOM = 72, 190, 56, 64
LABEL_STEP = 38  # px between two labels in the gutter, which take two lines each

# Series tell themselves apart by colour and by the shape of their points. Light page, dark page.
COLOURS = [("#1f66d0", "#6ea8ff"), ("#b4540a", "#ffa657"), ("#2b7d3c", "#6fd083"), ("#8a3ea8", "#d49bf0"),
           ("#b3273f", "#ff8f9d"), ("#5c636e", "#a3abb6")]


def style():
    light = [".page{fill:#ffffff}", ".grid{stroke:#e3e5e9;stroke-width:1}", ".axis{stroke:#8a9099;stroke-width:1}",
             ".target{stroke:#5c636e;stroke-width:1;stroke-dasharray:2 3}",
             "text{font-family:Helvetica,Arial,sans-serif;font-size:13px;fill:#24292f}",
             ".title{font-size:16px;font-weight:bold}", ".quiet{fill:#5c636e}", "path{fill:none;stroke-width:2}",
             ".beyond{stroke-dasharray:5 4}"]
    dark = [".page{fill:#14171c}", ".grid{stroke:#2a2f37}", ".axis{stroke:#737b87}", ".target{stroke:#98a0ac}",
            "text{fill:#e3e6ea}", ".quiet{fill:#a3abb6}"]
    for i, (on_light, on_dark) in enumerate(COLOURS):
        light.append(f".s{i}{{stroke:{on_light}}}.p{i}{{fill:{on_light}}}")
        dark.append(f".s{i}{{stroke:{on_dark}}}.p{i}{{fill:{on_dark}}}")
    return "".join(light) + "@media(prefers-color-scheme:dark){" + "".join(dark) + "}"


class LogAxis:
    """From values to pixels; the range goes on to a 1, 2 or 5 of a decade some way beyond the outermost values."""

    def __init__(self, values, first_pixel, last_pixel):
        self.ticks = self.marks(min(values), max(values))
        self.low, self.high = math.log10(self.ticks[0]), math.log10(self.ticks[-1])
        self.first, self.last = first_pixel, last_pixel

    @staticmethod
    def marks(low, high):
        every = [m * 10.0**e for e in range(math.floor(math.log10(low)) - 1, math.ceil(math.log10(high)) + 2)
                 for m in (1, 2, 5)]
        begin = max(i for i, v in enumerate(every) if v <= low / 1.1)
        end = min(i for i, v in enumerate(every) if v >= high * 1.1)
        return every[begin:end + 1]

    def labelled(self):
        """Not so many ticks that their words touch: decades alone where there are many."""
        if len(self.ticks) <= 9:
            return self.ticks
        return [t for t in self.ticks if abs(math.log10(t) - round(math.log10(t))) < 1e-6]

    def pixel(self, value):
        return self.first + (math.log10(value) - self.low) / (self.high - self.low) * (self.last - self.first)


def number(value):
    """Three digits at most, no exponent within reason: 0.02, 5, 1,000."""
    if value >= 1000:
        return f"{value:,.0f}"
    return f"{float(f'{value:.3g}'):g}"


def point_mark(shape, x, y, series, words):
    shapes = (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" class="p{series}">',
              f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" class="p{series}">',
              f'<polygon points="{x:.1f},{y - 5.5:.1f} {x + 5:.1f},{y + 4:.1f} {x - 5:.1f},{y + 4:.1f}" '
              f'class="p{series}">')
    mark = shapes[shape % len(shapes)]
    return f"{mark}<title>{escape(words)}</title></{mark[1:].split()[0]}>"


def spread_out(wanted, low, high):
    """Heights for labels near those wanted, in their order, LABEL_STEP apart or more."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    placed, at = {}, low
    for i in order:
        placed[i] = at = max(at, wanted[i])
        at += LABEL_STEP
    ceiling = high
    for i in reversed(order):
        placed[i] = ceiling = min(placed[i], ceiling)
        ceiling -= LABEL_STEP
    return [placed[i] for i in range(len(wanted))]


def chart(title, x_title, y_title, y_word, series, target=None):
    """The SVG. Each of series: name, note, points [(x, y, words)], and beyond: None or an (x, y) that is foretold."""
    ends = [s["beyond"] for s in series if s["beyond"]]
    every = [p[:2] for s in series for p in s["points"]] + ends
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    xs = LogAxis([p[0] for p in every], LEFT, right)
    ys = LogAxis([p[1] for p in every] + ([target] if target else []), bottom, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
           f'height="{HEIGHT}" role="img">', f"<title>{escape(title)}</title>", f"<style>{style()}</style>",
           f'<rect width="{WIDTH}" height="{HEIGHT}" rx="6" class="page"/>',
           f'<text x="{LEFT}" y="30" class="title">{escape(title)}</text>']
    for tick in xs.ticks:
        x = xs.pixel(tick)
        out.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{bottom}" class="grid"/>')
    for tick in ys.ticks:
        y = ys.pixel(tick)
        out.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" class="grid"/>')
    for tick in xs.labelled():
        out.append(f'<text x="{xs.pixel(tick):.1f}" y="{bottom + 20}" text-anchor="middle" class="quiet">'
                   f"{number(tick)}</text>")
    for tick in ys.labelled():
        out.append(f'<text x="{LEFT - 8}" y="{ys.pixel(tick) + 4:.1f}" text-anchor="end" class="quiet">'
                   f"{y_word(tick)}</text>")
    out += [f'<line x1="{LEFT}" y1="{bottom}" x2="{right}" y2="{bottom}" class="axis"/>',
            f'<line x1="{LEFT}" y1="{TOP}" x2="{LEFT}" y2="{bottom}" class="axis"/>',
            f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 18}" text-anchor="middle">{escape(x_title)}</text>',
            f'<text transform="translate(20 {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle">'
            f"{escape(y_title)}</text>"]
    if target:
        y = ys.pixel(target)
        out.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" class="target"/>')
    last = [s["beyond"] or s["points"][-1][:2] for s in series]
    heights = spread_out([ys.pixel(y) for _, y in last], TOP + 6, bottom - 18)
    for i, (s, end, height) in enumerate(zip(series, last, heights)):
        line = " ".join(f"{'M' if k == 0 else 'L'}{xs.pixel(x):.1f} {ys.pixel(y):.1f}"
                        for k, (x, y, _) in enumerate(s["points"]))
        out.append(f'<path d="{line}" class="s{i}"/>')
        if s["beyond"]:
            x, y, _ = s["points"][-1]
            out.append(f'<path d="M{xs.pixel(x):.1f} {ys.pixel(y):.1f} L{xs.pixel(end[0]):.1f} '
                       f'{ys.pixel(end[1]):.1f}" class="s{i} beyond"/>')
        out += [point_mark(i, xs.pixel(x), ys.pixel(y), i, words) for x, y, words in s["points"]]
        out.append(point_mark(i, right + 16, height, i, s["name"]))
        out.append(f'<text x="{right + 26}" y="{height + 4:.1f}">{escape(s["name"])}</text>')
        out.append(f'<text x="{right + 26}" y="{height + 19:.1f}" class="quiet">{escape(s["note"])}</text>')
    return "\n".join(out + ["</svg>", ""])


def percent(share):
    return f"{number(100 * share)} %"


def error_series(method, target):
    points = []
    for run in method["runs"]:
        x, y = run["cpu_seconds"], run["true_error"]
        if not y or (points and run["rays"] == points[-1][3]):
            continue  # not known; or the very run before, since both settings ended with the same rays
        points.append((x, y, f"{method['method']}, {run['setting']}: {number(x)} s, {percent(y)}", run["rays"]))
    price = method["to_one_per_cent"]
    cost, how = price["cpu_seconds"], price["how"]
    notes = {"interpolated": f"{percent(target)} in {number(cost)} s", "unknown": "",
             "extrapolated": f"{percent(target)} in about {number(cost)} s",
             "at most": f"{percent(target)} in {number(cost)} s or less"}
    return {"name": method["method"], "note": notes[how], "points": [p[:3] for p in points],
            "beyond": (cost, target) if how == "extrapolated" else None}


def slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower().replace(",", "")).strip("-")


def error_charts(section):
    for scene in section["scenes"]:
        series = [error_series(m, section["target"]) for m in scene["methods"]]
        series = [s for s in series if s["points"]]
        if series:
            yield (f"error-{slug(scene['scene'])}.svg",
                   chart(f"{scene['scene'].split(',')[0].capitalize()}, {scene['patches']:,} patches",
                         "processor time, s", "true error of the light (relative RMS)", percent, series,
                         section["target"]))


def cost_chart(section):
    rows = [r for r in section["rows"] if r["cpu_us_per_patch"] > 0]
    if len(rows) < 2:
        return

    def relative(name, key, note, word):
        first = rows[0][key]
        points = [(r["patches"], r[key] / first, f"{name}, {r['patches']:,} patches: {number(r[key])} {word}")
                  for r in rows]
        return {"name": name, "note": note.format(number(rows[-1][key])), "points": points, "beyond": None}

    series = [relative(f"a patch to {percent(section['target'])}", "cpu_us_per_patch", "{} µs at the end", "µs"),
              relative("a ray of Embree alone", "embree_cpu_ns_per_ray", "{} ns at the end", "ns")]
    yield ("cost-per-patch.svg",
           chart("Processor time as the Cornell box is cut finer", "patches",
                 f"times that at {rows[0]['patches']:,} patches", number, series))


def plain(name, note, points):
    return {"name": name, "note": note, "points": points, "beyond": None}


def polygons_chart(rows):
    first = rows[0]
    measured = [(r["polygons"], r["ratio_to_first"],
                 f"{r['polygons']:,} polygons: {number(r['nanoseconds_per_ray'])} ns a ray") for r in rows]
    logarithm = [(r["polygons"], math.log(r["polygons"]) / math.log(first["polygons"]), "the logarithm") for r in rows]
    return chart("Time of a ray against the number of polygons", "polygons",
                 f"times that at {first['polygons']:,} polygons", number,
                 [plain("measured", f"{number(rows[-1]['nanoseconds_per_ray'])} ns at the end", measured),
                  plain("the logarithm", "of the polygons", logarithm)])


def lamps_chart(rows):
    points = [(r["triangles"], r["ratio"], f"{r['triangles']} triangles: {r['ratio']:.3f} ({r['ratio_low']:.3f} to "
               f"{r['ratio_high']:.3f})") for r in rows]
    return chart("Time of a solve against the triangles of its lamp", "triangles of the lamp, power the same",
                 "times that with 2 triangles", number,
                 [plain("measured", f"{rows[-1]['ratio']:.2f} at the end", points)], 1.0)


def mesh_charts(section):
    for scene in section["scenes"]:
        series = []
        for where, words in (("whole", "all surfaces"), ("floor", "the floor alone")):
            for how in ("one size", "refined"):
                rows = [r for r in scene["rows"] if r["how"] == how]
                points = [(r["whole"]["patches"], r[where]["error"],
                           f"{how}, {words}, {r['whole']['patches']:,} patches: {percent(r[where]['error'])} "
                           f"± {percent(r[where]['standard_error'])}") for r in rows if r[where]["error"] > 0]
                series.append(plain(how, words, points))
        yield (f"error-against-patches-{slug(scene['scene'])}.svg",
               chart(f"{scene['scene']}: error against patches", "patches in all",
                     "error of the drawn light (relative RMS)", percent, series))


def methods_chart(section):
    """Every method on one mesh: {patches, methods: {name: [{setting, cpu_seconds, true_error}]}}."""
    series = []
    for name, runs in section["methods"].items():
        points = [(r["cpu_seconds"], r["true_error"],
                   f"{name}, {r['setting']}: {number(r['cpu_seconds'])} s, {percent(r['true_error'])}") for r in runs]
        best = min(r["true_error"] for r in runs)
        series.append(plain(name, f"down to {percent(best)}", points))
    return chart(f"Error against time, Cornell box with {section['patches']:,} patches", "processor time, s",
                 "true error of the light (relative RMS)", percent, series, 0.01)


def main(words):
    if len(words) != 3:
        sys.exit(f"usage: {words[0]} BENCH.json FOLDER")
    with open(words[1], encoding="utf-8") as file:
        bench = json.load(file)
    os.makedirs(words[2], exist_ok=True)
    charts = []
    if "error_against_time" in bench:
        charts += error_charts(bench["error_against_time"])
    if "cost_per_patch" in bench:
        charts += cost_chart(bench["cost_per_patch"])
    if "error_against_patches" in bench:
        charts += mesh_charts(bench["error_against_patches"])
    if "time_against_polygons" in bench:
        charts.append(("time-against-polygons.svg", polygons_chart(bench["time_against_polygons"])))
    if "time_against_lamps" in bench:
        charts.append(("time-against-lamps.svg", lamps_chart(bench["time_against_lamps"])))
    for name, svg in charts:
        path = os.path.join(words[2], name)
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(svg)
        print(path)
    if not charts:
        sys.exit(f"{words[0]}: {words[1]} has nothing to draw: run luxel-bench {words[1]} error patches")


if __name__ == "__main__":
    main(sys.argv)
