# SPDX-License-Identifier: Apache-2.0
"""make_figures.py: each picture that a page shows is committed, each that is made is shown, and what reads pictures
and meshes reads them right."""
import glob
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
MAKE = os.path.join(ROOT, "tools", "make_figures.py")
sys.path.insert(0, os.path.join(ROOT, "tools"))

import draw_charts  # noqa: E402
from figures import ply, png  # noqa: E402
from figures.pictures import noise  # noqa: E402
from figures.table import table  # noqa: E402

IMAGE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")


def figures():
    """The names of the figures in docs/figures, where pictures are WebP."""
    done = subprocess.run([sys.executable, "-B", MAKE, "--list"], capture_output=True, text=True, check=True)
    return [re.sub(r"\.png$", ".webp", name) for name in done.stdout.split()]


def shown():
    """(page, path of the picture from the root) for each picture of each page."""
    for page in [os.path.join(ROOT, "README.md"), *glob.glob(os.path.join(glob.escape(ROOT), "docs", "*.md"))]:
        with open(page, encoding="utf-8") as file:
            for link in IMAGE.findall(file.read()):
                yield page, os.path.relpath(os.path.join(os.path.dirname(page), link), ROOT)


def packed_png(width, height, lines):
    """A PNG of lines that are filtered already."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    return (png.SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


class Pages(unittest.TestCase):
    def test_every_picture_of_the_documents_is_committed(self):
        for page, picture in shown():
            self.assertTrue(os.path.exists(os.path.join(ROOT, picture)), f"{page} shows {picture}: run ./dev figures")

    def test_all_pictures_take_less_than_3_MB(self):
        size = sum(os.path.getsize(path) for folder in ("figures", "images")
                   for path in glob.glob(os.path.join(glob.escape(ROOT), "docs", folder, "*")))
        self.assertLess(size, 3e6)

    def test_every_figure_that_is_made_is_shown(self):
        self.assertEqual({os.path.join("docs", "figures", name) for name in figures()} -
                         {picture for _, picture in shown()}, set())

    def test_no_figure_is_named_twice(self):
        self.assertEqual(len(figures()), len(set(figures())))

    def test_a_section_that_there_is_not_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", MAKE, folder, folder, folder, "dance"], capture_output=True,
                                  check=False)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(os.listdir(folder), [])


class Readers(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = place.name

    def at(self, name):
        return os.path.join(self.place, name)

    def test_every_filter_of_a_png_is_undone(self):
        # Two pixels a line. None; sub; up; average; Paeth: each line is worked out by hand to be 10 20 30 40 50 60.
        lines = (b"\0" + bytes([10, 20, 30, 40, 50, 60]) + b"\1" + bytes([10, 20, 30, 30, 30, 30]) + b"\2" + bytes(6) +
                 b"\3" + bytes([5, 10, 15, 15, 15, 15]) + b"\4" + bytes(6))
        with open(self.at("a.png"), "wb") as file:
            file.write(packed_png(2, 5, lines))
        self.assertEqual(png.read(self.at("a.png")), (2, 5, bytes([10, 20, 30, 40, 50, 60] * 5)))

    def test_each_band_comes_from_its_own_picture(self):
        for i, name in enumerate("abc"):
            png.write(self.at(name), 2, 1, bytes(range(10 * i, 10 * i + 6)))
        png.band_of_each(self.at("d"), [self.at(name) for name in "abc"])
        self.assertEqual(png.read(self.at("d")), (2, 1, bytes([0, 11, 22, 3, 14, 25])))

    def test_what_is_no_picture_of_luxels_is_refused(self):
        with open(self.at("a"), "wb") as file:
            file.write(b"GIF89a")
        self.assertRaises(ValueError, png.read, self.at("a"))

    def test_the_light_of_a_mesh_is_found_by_place(self):
        head = ("ply\nformat binary_little_endian 1.0\nelement vertex 3\n" +
                "".join(f"property float {n}\n" for n in ("x", "y", "z", "nx", "ny", "nz")) +
                "".join(f"property uchar {n}\n" for n in ("red", "green", "blue")) +
                "".join(f"property float irradiance_{n}\n" for n in ("red", "green", "blue")) +
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n")
        with open(self.at("a.ply"), "wb") as file:
            file.write(head.encode())
            for x, y, light in ((0, 0, 1), (1, 0, 2), (0, 1, 6)):
                file.write(struct.pack("<6f3B3f", x, y, 0, 0, 0, 1, 9, 9, 9, light, 2 * light, 0))
            file.write(struct.pack("<Biii", 3, 2, 0, 1))
        self.assertEqual(ply.irradiance(self.at("a.ply")),
                         {((0, 0, 0, 0, 0, 1), (0, 1, 0, 0, 0, 1), (1, 0, 0, 0, 0, 1)): (3, 6, 0)})


class Measures(unittest.TestCase):
    def test_noise_of_brightness_and_of_colour_are_told_apart(self):
        truth = {"a": (1, 2, 4), "b": (1, 2, 4)}
        grey = noise({"a": (1.5, 3, 6), "b": (0.5, 1, 2)}, truth)
        self.assertAlmostEqual(grey["brightness"], 0.5)
        self.assertAlmostEqual(grey["colour"], 0)
        coloured = noise({"a": (1.5, 1, 4), "b": (0.5, 3, 4)}, truth)
        self.assertAlmostEqual(coloured["brightness"], 0)
        self.assertAlmostEqual(coloured["colour"], (0.5 / 3)**0.5)

    def test_charts_and_tables_are_valid_and_say_their_numbers(self):
        chart = draw_charts.methods_chart({"patches": 210, "methods": {
            "dense": [{"setting": "x", "cpu_seconds": 9, "true_error": 0.001}],
            "lines": [{"setting": "x", "cpu_seconds": 1, "true_error": 0.1},
                      {"setting": "y", "cpu_seconds": 10, "true_error": 0.03}]}})
        polygons = draw_charts.polygons_chart([
            {"polygons": n, "nanoseconds_per_ray": 50 * r, "ratio_to_first": r} for n, r in ((100, 1), (10000, 2))])
        lamps = draw_charts.lamps_chart([{"triangles": n, "ratio": 1, "ratio_low": 0.9, "ratio_high": 1.1}
                                         for n in (2, 128)])
        for svg, words in ((chart, "down to 3 %"), (polygons, "100 ns at the end"), (lamps, "1.00 at the end"),
                           (table("A <title>", ["", "x"], [["row", "7 %"]]), "7 %")):
            ElementTree.fromstring(svg)
            self.assertIn(words, svg)


if __name__ == "__main__":
    unittest.main()
