# SPDX-License-Identifier: Apache-2.0
"""draw_charts.py: what luxel-bench measured comes out as valid SVG, each point where its numbers say."""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

DRAW = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "draw_charts.py")
SVG = "{http://www.w3.org/2000/svg}"


def run(cpu, error, rays):
    return {"setting": f"{rays} rays", "cpu_seconds": cpu, "true_error": error, "rays": rays}


def method(name, runs, cpu, how):
    return {"method": name, "runs": runs, "to_one_per_cent": {"cpu_seconds": cpu, "rays": 1.0, "how": how}}


def scene(*methods):
    return {"error_against_time": {"target": 0.01, "scenes": [
        {"scene": "Room <1>, 10,000", "patches": 9952, "methods": list(methods)}]}}


SAMPLED = method("sampled", [run(0.1, 0.04, 10), run(0.11, 0.04, 10), run(1.6, 0.005, 99)], 0.9, "interpolated")
SHOOTING = method("shooting", [run(0.2, 0.2, 5), run(3.2, 0.05, 80), run(9.9, None, 400)], 80.0, "extrapolated")
COST = {"cost_per_patch": {"target": 0.01, "rows": [
    {"patches": 2000, "cpu_us_per_patch": 50.0, "embree_cpu_ns_per_ray": 100.0},
    {"patches": 20000, "cpu_us_per_patch": 25.0, "embree_cpu_ns_per_ray": 150.0},
    {"patches": 200000, "cpu_us_per_patch": 0.0, "embree_cpu_ns_per_ray": 200.0}]}}


def draw(bench):
    """The exit status, and the files drawn: name -> bytes."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bench.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(bench, file)
        out = os.path.join(folder, "new", "images")
        done = subprocess.run([sys.executable, "-B", DRAW, path, out], capture_output=True, text=True, check=False)
        drawn = {}
        for name in sorted(os.listdir(out)):
            with open(os.path.join(out, name), "rb") as file:
                drawn[name] = file.read()
        return done.returncode, drawn


class Chart:
    def __init__(self, svg):
        self.root = ElementTree.fromstring(svg)
        self.texts = ["".join(t.itertext()) for t in self.root.iter(SVG + "text")]

    def points(self, tag):
        """What each point of this shape says -> where its middle stands."""
        where = {"circle": lambda e: (float(e.get("cx")), float(e.get("cy"))),
                 "rect": lambda e: (float(e.get("x")) + 4, float(e.get("y")) + 4)}[tag]
        marks = [(e.find(SVG + "title"), e) for e in self.root.iter(SVG + tag)]
        return {title.text: where(e) for title, e in marks if title is not None}

    def axis(self, anchor, unit=""):
        """The pixel of a value, by the words at the ticks."""
        ticks = []
        for t in self.root.iter(SVG + "text"):
            match = re.fullmatch(r"([\d.,]+)" + unit, t.text)
            if match and t.get("text-anchor") == anchor and t.get("transform") is None:
                pixel = float(t.get("x")) if anchor == "middle" else float(t.get("y")) - 4
                ticks.append((math.log10(float(match[1].replace(",", ""))), pixel))
        (a, at_a), (b, at_b) = ticks[0], ticks[-1]
        return lambda value: at_a + (math.log10(value) - a) / (b - a) * (at_b - at_a)


class DrawCharts(unittest.TestCase):
    def test_each_point_stands_where_its_numbers_say(self):
        status, drawn = draw(scene(SAMPLED, SHOOTING))
        self.assertEqual((status, list(drawn)), (0, ["error-room-1-10000.svg"]))
        chart = Chart(drawn["error-room-1-10000.svg"])
        x, y = chart.axis("middle"), chart.axis("end", " %")
        for tag, words, cpu, error in (("circle", "sampled, 10 rays: 0.1 s, 4 %", 0.1, 4),
                                       ("circle", "sampled, 99 rays: 1.6 s, 0.5 %", 1.6, 0.5),
                                       ("rect", "shooting, 80 rays: 3.2 s, 5 %", 3.2, 5)):
            at = chart.points(tag)[words]
            self.assertAlmostEqual(at[0], x(cpu), delta=0.2)
            self.assertAlmostEqual(at[1], y(error), delta=0.2)

    def test_a_run_that_repeats_the_one_before_or_has_no_known_error_is_no_point(self):
        chart = Chart(draw(scene(SAMPLED, SHOOTING))[1]["error-room-1-10000.svg"])
        self.assertEqual(len(chart.points("circle")), 2 + 1)  # and one beside the name
        self.assertEqual(len(chart.points("rect")), 2 + 1)

    def test_titles_and_notes_say_what_is_drawn(self):
        chart = Chart(draw(scene(SAMPLED, SHOOTING))[1]["error-room-1-10000.svg"])
        for words in ("Room <1>, 9,952 patches", "processor time, s", "sampled", "1 % in 0.9 s", "shooting",
                      "1 % in about 80 s"):
            self.assertIn(words, chart.texts)

    def test_what_is_foretold_is_dashed_and_what_is_measured_is_not(self):
        chart = Chart(draw(scene(SAMPLED, SHOOTING))[1]["error-room-1-10000.svg"])
        kinds = [e.get("class") for e in chart.root.iter(SVG + "path")]
        self.assertEqual(kinds, ["s0", "s1", "s1 beyond"])

    def test_names_do_not_cover_each_other(self):
        chart = Chart(draw(scene(*(SAMPLED,) * 4))[1]["error-room-1-10000.svg"])
        heights = sorted(float(t.get("y")) for t in chart.root.iter(SVG + "text") if t.text == "sampled")
        self.assertEqual(len(heights), 4)
        self.assertGreaterEqual(min(b - a for a, b in zip(heights, heights[1:])), 30)

    def test_the_cost_of_a_patch_is_drawn_relative_to_the_first(self):
        status, drawn = draw(COST)
        self.assertEqual((status, list(drawn)), (0, ["cost-per-patch.svg"]))
        chart = Chart(drawn["cost-per-patch.svg"])
        x, y = chart.axis("middle"), chart.axis("end")
        solver = chart.points("circle")
        self.assertEqual(len(solver), 2 + 1, "the row of unknown cost is left out")
        at = solver["a patch to 1 %, 20,000 patches: 25 µs"]
        self.assertAlmostEqual(at[0], x(20000), delta=0.2)
        self.assertAlmostEqual(at[1], y(0.5), delta=0.2)
        embree = chart.points("rect")["a ray of Embree alone, 20,000 patches: 150 ns"]
        self.assertAlmostEqual(embree[1], y(1.5), delta=0.2)

    def test_the_same_file_gives_the_same_bytes(self):
        self.assertEqual(draw({**scene(SAMPLED), **COST}), draw({**scene(SAMPLED), **COST}))

    def test_nothing_to_draw_is_a_failure(self):
        self.assertEqual(draw({"cores": 2}), (1, {}))


if __name__ == "__main__":
    unittest.main()
