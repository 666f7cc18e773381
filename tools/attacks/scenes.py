# SPDX-License-Identifier: Apache-2.0
"""Random scenes against the path tracer."""

import json
import shutil
import tempfile
from pathlib import Path

from .common import CORES, STATE, Finding, run


def random_box(chance, low, high):
    size = [chance.uniform(0.1, 0.5) * (h - l) for l, h in zip(low, high)]
    at = [chance.uniform(l, h - s) for l, h, s in zip(low, high, size)]
    return at, [a + s for a, s in zip(at, size)]


def box_faces(low, high, first, inwards):
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    if not inwards:
        quads = [tuple(reversed(quad)) for quad in quads]
    return corners, [tuple(first + index for index in quad) for quad in quads]


def random_scene(chance):
    """A closed room with boxes and a lamp below the ceiling: OBJ and MTL."""
    size = [chance.uniform(2.0, 6.0) for _ in range(3)]
    lines, materials, first = ["mtllib room.mtl"], [], 1

    def add(name, low, high, inwards, reflectance, radiance=0.0):
        nonlocal first
        corners, quads = box_faces(low, high, first, inwards)
        first += len(corners)
        lines.extend(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in corners)
        lines.extend([f"g {name}", f"usemtl {name}"])
        lines.extend("f " + " ".join(map(str, quad)) for quad in quads)
        colour = " ".join(f"{r:.4f}" for r in reflectance)
        materials.append(f"newmtl {name}\nKd {colour}\nKe {radiance} {radiance} {radiance}\n")

    def colour():
        return [chance.uniform(0.05, 0.85) for _ in range(3)]

    add("room", (0, 0, 0), size, True, colour())
    for number in range(chance.randrange(4)):
        add(f"box{number}", *random_box(chance, (0.05, 0.05, 0.05), [0.7 * s for s in size]), False, colour())
    low = [chance.uniform(0.2, 0.5) * s for s in size[:2]] + [size[2] - 0.12]
    add("lamp", low, [low[0] + 0.4, low[1] + 0.3, size[2] - 0.02], False, [0.5] * 3, 10.0)
    return "\n".join(lines) + "\n", "\n".join(materials)


class Scenes:
    """Solver and path tracer agree within their errors, in the mean over all patches."""

    at_once = CORES
    limit = 6.0  # standard errors; from some dozen replicates, so about one false alarm in 10,000 scenes

    def __init__(self, luxel):
        self.luxel = luxel

    def attempt(self, chance):
        folder = Path(tempfile.mkdtemp(prefix="scenes-", dir=STATE))
        obj, mtl = random_scene(chance)
        (folder / "room.obj").write_text(obj)
        (folder / "room.mtl").write_text(mtl)
        common = ["room.obj", "--max-edge", "0.5", "--sky", "none", "--threads", "1", "--seed", str(chance.randrange(1 << 30))]
        self.run(["bake", *common, "--rays", "100k", "--mesh-error", "none", "--store-transport", "-o", "a.vtkhdf"], folder)
        self.run(["reference", *common, "--samples", "50", "-o", "b.vtkhdf"], folder)
        compared = json.loads(self.run(["compare", "a.vtkhdf", "b.vtkhdf", "--json"], folder))
        measured = json.loads(self.run(["measure", "a.vtkhdf", "--json"], folder))
        bias, error = self.judge(compared, measured, folder)
        shutil.rmtree(folder)
        return {"bias": bias, "squared_ratio": (bias / error) ** 2}

    @staticmethod
    def report(total):
        tries = max(total["tries"], 1)
        bias, ratio = total.get("bias", 0.0) / tries, (total.get("squared_ratio", 0.0) / tries) ** 0.5
        return f"mean bias {100.0 * bias:+.3f} %, RMS of bias over its standard error {ratio:.2f}"

    def run(self, arguments, folder):
        result = run([self.luxel, *arguments], folder)
        if result.returncode not in (0, 3):  # 3: the rays ended before the error was reached
            raise Finding(f"{' '.join(arguments)} in {folder}: ended with {result.returncode}: {result.stderr[-500:]}")
        return result.stdout

    def judge(self, compared, measured, folder):
        if measured["errors_of_means"] != "replicates":
            raise Finding(f"the errors of means come from {measured['errors_of_means']}: {folder}")
        # Patches of one solve err together; the widest of the intervals of 95 % bounds what they have in common.
        means = [surface["mean_lx"] for surface in measured["surfaces"]]
        common = max((mean["high"] - mean["low"]) / (2.0 * 1.96 * mean["value"]) for mean in means if mean["value"] > 0)
        bias, error = compared["mean_bias"], (compared["bias_error"] ** 2 + common**2) ** 0.5
        if not abs(bias) <= self.limit * error:
            raise Finding(f"bias {bias:.4f}, standard error {error:.4f}: {folder}")
        return bias, error
