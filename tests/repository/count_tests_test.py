# SPDX-License-Identifier: Apache-2.0
"""count_tests.py against what ctest writes: nothing that did not run is taken for a pass."""
import os
import subprocess
import sys
import tempfile
import unittest

COUNT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "count_tests.py")
PASSED = '<testcase name="a" classname="a" time="0.1" status="run"><system-out>x &lt; y</system-out></testcase>'
FAILED = '<testcase name="b" status="fail"><failure message=""/><system-out>\x01</system-out></testcase>'
SKIPPED = ('<testcase name="c" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/><system-out>'
           "[ RUN      ] C.c\na_test.cpp:9: Skipped\nthere is no lamp\n\n[  SKIPPED ] C.c</system-out></testcase>")
MISSING = '<testcase name="d" status="notrun"><skipped message="Unable to find executable"/><system-out></system-out></testcase>'
DISABLED = '<testcase name="e" status="disabled"/>'


class CountTests(unittest.TestCase):
    def lines(self, *cases):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ctest.xml")
            with open(path, "w", encoding="utf-8") as file:
                file.write("<testsuite>" + "\n".join(cases) + "</testsuite>")
            done = subprocess.run([sys.executable, "-B", COUNT, path], capture_output=True, text=True, check=True)
            return done.stdout.splitlines()

    def test_each_test_is_counted_once(self):
        self.assertEqual(self.lines(PASSED, FAILED, PASSED)[-1], "2 1 0")

    def test_no_test_counts_as_nothing(self):
        self.assertEqual(self.lines(), ["0 0 0"])

    def test_a_skipped_test_says_why(self):
        self.assertEqual(self.lines(SKIPPED, DISABLED),
                         ["skipped: c: there is no lamp", "skipped: e: no reason given", "0 0 2"])

    def test_a_test_whose_program_is_missing_has_failed(self):
        self.assertEqual(self.lines(MISSING), ["failed: d", "0 1 0"])


if __name__ == "__main__":
    unittest.main()
