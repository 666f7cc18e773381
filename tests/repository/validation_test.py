# SPDX-License-Identifier: Apache-2.0
"""tools/validation: the two derivations of every true value agree, and the tests in C++ have these values."""
import os
import re
import sys
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tools"))
from validation import daylight_truth, truth  # noqa: E402
from validation.scenes import towards  # noqa: E402


def numbers_of(name):
    with open(os.path.join(ROOT, "tests", "truth", name), encoding="utf-8") as file:
        return [float(n) for n in re.findall(r"(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?(?!\w)", file.read())]


class Truth(unittest.TestCase):
    def test_two_derivations_agree_to_six_digits(self):
        for name, case in truth.CASES.items():
            for label, pair in case().items():
                self.assertLess(truth.disagreement(pair), 1e-6, f"{name} {label}")

    def test_the_tests_have_these_values(self):
        for file, names in (("cie171_lamps_test.cpp", ("5.2", "5.3")),
                            ("cie171_reflection_test.cpp", ("5.6, S2 of 0.5 m", "5.6, S2 of 4 m", "5.6, S2 of 500 m", "5.7",
                                                            "5.8"))):
            numbers = numbers_of(file)
            for name in names:
                for label, (value, _) in truth.CASES[name]().items():
                    near = min(numbers, key=lambda n, value=value: abs(n - value))
                    self.assertAlmostEqual(near, value, delta=2e-7 * max(value, 1e-3) + 1e-8, msg=f"{file}: {name} {label}")
        lamps = numbers_of("cie171_lamps_test.cpp")
        for label in ("floor", "opening"):
            value = truth.case_5_4()[label][0]
            self.assertLess(min(abs(n - value) for n in lamps), 1e-6, label)

    def test_solid_angles_of_a_room_fill_the_sphere(self):
        room = truth.case_5_4()
        self.assertAlmostEqual(2.0 * room["floor"][0] + 4.0 * room["wall"][0], 10000.0, places=8)

    def test_the_obstruction_hides_what_lies_behind_it(self):
        self.assertFalse(truth.passes((2.0, 0.25, 0.0), (2.0, 4.0, 1.0)))
        self.assertTrue(truth.passes((2.0, 0.25, 0.0), (2.0, 4.0, 2.9)))

    def test_a_light_of_glTF_turns_where_its_light_goes(self):
        for direction in ((1.0, 2.0, -0.5), (0.0, 0.0, 1.0), (0.3, -0.8, 0.2)):
            x, y, z, w = towards(direction)
            # -Z turned by the quaternion
            turned = (-2.0 * (x * z + w * y), -2.0 * (y * z - w * x), -(1.0 - 2.0 * (x * x + y * y)))
            size = sum(c * c for c in direction) ** 0.5
            for a, b in zip(turned, direction):
                self.assertAlmostEqual(a, b / size, places=9)


class DaylightTruth(unittest.TestCase):
    # Sections of daylight_truth and their arguments, with the skies under which the tests have them.
    OPENINGS = [(daylight_truth.roof, "4 × 4 m", False, (16, 5, 12)), (daylight_truth.roof, "1 × 1 m", False, (12, 13)),
                (daylight_truth.roof, "1 × 1 m", True, (12,)), (daylight_truth.roof, "4 × 4 m", True, (16,)),
                (daylight_truth.facade, "2 × 1 m", False, (16, 12)), (daylight_truth.facade, "4 × 3 m", False, (14,)),
                (daylight_truth.facade, "2 × 1 m", True, (12,)), (daylight_truth.facade, "4 × 3 m", True, (16,))]
    MASKS = [(daylight_truth.overhang, 0.5, (16,)), (daylight_truth.overhang, 1.0, (12,)), (daylight_truth.overhang, 2.0, (16,)),
             (daylight_truth.screen, 3.0, (12,)), (daylight_truth.screen, 6.0, (16,)), (daylight_truth.screen, 9.0, (12,))]

    def hold(self, file, sections):
        numbers = numbers_of(file)
        for section, *words in sections:
            for label, of_sky in section(*words).items():
                for sky, pair in of_sky.items():
                    name = f"{file}: {section.__name__} {words} {label}, sky {sky}"
                    self.assertLess(truth.disagreement(pair), 1e-5, name)
                    near = min(numbers, key=lambda n, value=pair[0]: abs(n - value))
                    self.assertAlmostEqual(near, pair[0], delta=1e-7 * pair[0], msg=name)

    def test_two_derivations_agree_and_the_tests_have_these_values(self):
        self.hold("cie171_daylight_test.cpp", self.OPENINGS)
        self.hold("cie171_masks_test.cpp", self.MASKS)

    def test_glass_has_its_transmittance_by_both_derivations(self):
        numbers = numbers_of("cie171_daylight_test.cpp")
        for angle, pair in daylight_truth.case_5_5().items():
            self.assertLess(truth.disagreement(pair), 1e-12, angle)
            self.assertLess(min(abs(n - 100.0 * pair[0]) for n in numbers), 1e-6, angle)

    def test_open_ground_has_its_illuminance_by_both_derivations(self):
        for sky in daylight_truth.SKIES:
            self.assertLess(truth.disagreement(daylight_truth.over_zenith(sky, 0.5)), 1e-6, sky)


if __name__ == "__main__":
    unittest.main()
