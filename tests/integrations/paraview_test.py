# SPDX-License-Identifier: Apache-2.0
"""paraview_test.py LUXEL: integrations/paraview/luxel_light.py in ParaView: it draws both sides of a lit sheet with their
illuminances. Ends with 77, and a line that says why, where there is no ParaView or no virtual screen."""
import json
import os
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
# A sheet between two lamps, one weaker than the other, that face it.
SCENE = """mtllib sheet.mtl
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 1 -1
v 1 1 -1
v 1 1 1
v -1 1 1
v -1 -1 -1
v 1 -1 -1
v 1 -1 1
v -1 -1 1
usemtl sheet
f 4 3 2 1
usemtl strong
f 5 6 7 8
usemtl weak
f 12 11 10 9
"""
MATERIALS = """newmtl sheet
Kd 0.5 0.5 0.5
newmtl strong
Kd 0 0 0
Ke 3 3 3
newmtl weak
Kd 0 0 0
Ke 1 1 1
"""


def main(luxel):
    missing = next((f"{program}: apt-get install {package}" for program, package in
                    (("pvbatch", "python3-paraview"), ("xvfb-run", "xvfb xauth")) if shutil.which(program) is None), None)
    if missing:
        print("skipped: there is no", missing)
        return 77
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("sheet.obj", SCENE), ("sheet.mtl", MATERIALS)):
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
        subprocess.run([luxel, "bake", "sheet.obj", "--up", "y", "--max-edge", "0.25", "--mesh-error", "none", "--error", "2%", "-o",
                        "sheet.vtkhdf", "--quiet"], cwd=folder, check=True)
        picture = os.path.join(os.environ.get("LUXEL_PAGE_PICTURES") or folder, "paraview.png")
        done = subprocess.run(["xvfb-run", "-a", "-n", str(10000 + os.getpid() % 9000), "-s", "-screen 0 1024x768x24", "pvbatch", os.path.join(HERE, "in_paraview.py"),
                               os.path.join(ROOT, "integrations", "paraview"), "sheet.vtkhdf", picture],
                              cwd=folder, capture_output=True, text=True, check=False)
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        assert done.returncode == 0 and lines, f"{done.stdout}\n{done.stderr}"
        found = json.loads(lines[-1])
        with h5py.File(os.path.join(folder, "sheet.vtkhdf")) as file:
            cells = {name: array[:] for name, array in file["VTKHDF/CellData"].items()}
        lux = {side: 179.0 * cells[f"irradiance_{side}"].astype(float) @ (0.2126, 0.7152, 0.0722) for side in ("front", "back")}
        wanted = [float(lux[side] @ cells["area"]) for side in ("front", "back")]
        print(found, wanted)
        assert min(wanted) > 10.0 and abs(wanted[0] / wanted[1] - 1.0) > 0.5, f"both sides are lit, differently: {wanted}"
        np.testing.assert_allclose(found["lumens"], wanted, rtol=1e-4)
        np.testing.assert_allclose(found["lumens_of_state"], wanted, rtol=1e-4)
        assert found["title"] == "Illuminance, lx" and found["low"] == 0.0, found
        brightest = max(values.max() for values in lux.values())
        assert 0.5 * brightest < found["high"] < 2.0 * brightest, found
        for drawn in (picture, picture.replace(".png", "-state.png")):
            assert os.path.getsize(drawn) > 5000, f"{drawn} is of one colour"
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
