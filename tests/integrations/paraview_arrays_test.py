# SPDX-License-Identifier: Apache-2.0
"""paraview_arrays_test.py LUXEL: the arrays that ParaView's macro names are in a file that Luxel writes, of the shapes that
it takes them to have, and its formula has their illuminance. Without ParaView: its modules are empty ones here."""
import html
import os
import re
import subprocess
import sys
import tempfile
import types
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "integrations", "paraview"))
paraview = types.ModuleType("paraview")
paraview.servermanager, paraview.simple = types.ModuleType("servermanager"), types.ModuleType("simple")
sys.modules["paraview"] = paraview

try:
    import h5py
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}: apt-get install python3-h5py")
    sys.exit(77)
import luxel_light  # noqa: E402

LUXEL = sys.argv.pop(1)


def evaluated(expression, cells):
    """A sum of products as ParaView's calculator has it."""
    total = 0.0
    for factor, name in re.findall(r'([\d.e+-]+)\*"([a-z_]+(?:_(?:[XYZ]|\d+))?)"', expression):
        array, _, component = name.rpartition("_")
        if component in "XYZ":
            total = total + float(factor) * cells[array][:, "XYZ".index(component)]
        elif component.isdigit():
            total = total + float(factor) * cells[array][:, int(component)]
        else:
            total = total + float(factor) * cells[name]
    return total


class Macro(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def bake(self, *words):
        path = os.path.join(self.folder, "box.vtkhdf")
        subprocess.run([LUXEL, "bake", os.path.join(ROOT, "scenes", "cornell-box.obj"), "--max-edge", "0.3", "--mesh-error", "none",
                        "--error", "20%", "-o", path, "--quiet", *words], check=True)
        with h5py.File(path) as file:
            return path, {name: array[:] for name, array in file["VTKHDF/CellData"].items()}

    def test_colour(self):
        path, cells = self.bake("-o", os.path.join(self.folder, "box.png"))
        self.assertEqual(cells[luxel_light.AREA].ndim, 1)
        own = luxel_light.stored(path)
        self.assertEqual({name: len(values) for name, values in own["view"].items()},
                         {"eye": 3, "target": 3, "up": 3, "vertical_fov": 1})
        self.assertEqual(own["up"], [0.0, 1.0, 0.0])
        self.assertNotIn("linear_srgb", own)
        for array in luxel_light.SIDES.values():
            name, unit, factors = luxel_light.quantity_of(cells[array].shape[1])
            self.assertEqual((name, unit), ("Illuminance", "lx"))
            lux = 179.0 * cells[array] @ (0.2126, 0.7152, 0.0722)
            np.testing.assert_allclose(evaluated(luxel_light.expression_of(array, factors), cells), lux, rtol=1e-5, atol=1e-6)
        self.assertGreater(lux.size, 34)

    def test_spectrum(self):
        path, cells = self.bake("--spectral", os.path.join(ROOT, "scenes", "cornell-spectra.csv"), "--bands", "8")
        bands = luxel_light.stored(path)["linear_srgb"]
        array = luxel_light.SIDES["front"]
        self.assertEqual(bands.shape, (cells[array].shape[1], 3))
        _, unit, factors = luxel_light.quantity_of(cells[array].shape[1], bands)
        lux = 179.0 * cells[array] @ bands @ (0.2126, 0.7152, 0.0722)
        self.assertEqual(unit, "lx")
        self.assertGreater(lux.max(), 1.0)
        np.testing.assert_allclose(evaluated(luxel_light.expression_of(array, factors), cells), lux, rtol=1e-4, atol=1e-4)

    def test_single_band(self):
        name, unit, factors = luxel_light.quantity_of(1)
        self.assertEqual((name, unit), ("Irradiance", "W/m²"))
        self.assertEqual(luxel_light.expression_of("irradiance_front", factors), '1*"irradiance_front"')

    def test_the_state_file_has_the_formulas_of_the_macro(self):
        with open(os.path.join(ROOT, "integrations", "paraview", "luxel_light.pvsm"), encoding="utf-8") as file:
            functions = {html.unescape(text) for text in re.findall(r'"(\d[^"]*irradiance[^"]*)"', file.read())}
        _, _, factors = luxel_light.quantity_of(3)
        self.assertEqual(functions, {luxel_light.expression_of(array, factors) for array in luxel_light.SIDES.values()})

    def test_scale_has_round_ends(self):
        self.assertEqual([luxel_light.round_up(value) for value in (0.0, 1.0, 2.1, 460.0, 710.0)], [1.0, 1.0, 3.0, 500.0, 1000.0])
        values, areas = np.array([0.0, 90.0, 100.0, 5000.0]), np.array([50.0, 1.0, 98.0, 1.0])
        self.assertEqual(luxel_light.upper_end(values, areas), 100.0)  # a hundredth is brighter; unlit area does not count
        self.assertEqual(luxel_light.upper_end(np.zeros(3), np.ones(3)), 1.0)


if __name__ == "__main__":
    unittest.main()
