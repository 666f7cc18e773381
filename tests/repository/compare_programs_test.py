# SPDX-License-Identifier: Apache-2.0
"""compare_programs_test.py BIN: compare_programs.py --quick; every program that is there gives the light of the truth.

Ends with 77, and a line that says why, where its libraries are missing.
"""
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
# Of the mean luminance. The fastest settings were 3 % (Luxel) and 4 % (POV-Ray) off; a lamp that faces the wrong way,
# a wrong unit or a lost bounce changes it by 15 % or more.
TOLERANCE = 0.10
ABSENT = ("not found", "built without")


def main(programs):
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError:
        print("skipped: apt-get install python3-numpy python3-matplotlib")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-B", os.path.join(HERE, "..", "..", "tools", "compare_programs.py"), programs,
                        folder, "--quick"], check=True)
        with open(os.path.join(folder, "comparison.json"), encoding="utf-8") as file:
            scene, = json.load(file)["scenes"]
        for name in ("comparison.md", "comparison.svg", "comparison-pictures.png"):
            assert os.path.getsize(os.path.join(folder, name)) > 500, f"{name} is empty"
    truth = scene["truth"]
    if "brightness_ratio" in truth:
        assert abs(truth["brightness_ratio"]) < 5 * truth["brightness_standard_error"], f"the truths differ: {truth}"
    for program in scene["programs"]:
        if program["problem"]:
            assert any(word in program["problem"] for word in ABSENT), f"{program['program']}: {program['problem']}"
        for run in program["runs"]:
            assert abs(run["mean"]) < TOLERANCE, f"{program['program']}: the mean is off by {run['mean']:.1%}"
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
