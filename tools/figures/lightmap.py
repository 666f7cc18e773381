# SPDX-License-Identifier: Apache-2.0
"""The pictures of the page about lightmaps: a page, and the box as a reader of such pages sees it."""
import os
import shutil

from figures.scenes import BOX, view

# Name: what the texels hold.
LOOKS = {"interpolated": "none", "gathered": "3%"}
NAMES = ["lightmap-page.png"] + [f"lightmap-{name}.png" for name in LOOKS]


def lightmap(luxel, folder):
    """A rough solution on large patches, which shows what a final gather takes away."""
    solution = luxel.at("lightmap.vtkhdf")
    luxel.run("bake", BOX, "--max-edge", luxel.choose(0.05, 0.2), "--error", "5%", "-o", solution)
    measured = {}
    for name, gather in LOOKS.items():
        page = luxel.at(f"lightmap-{name}-page.png")
        report = luxel.run("lightmap", solution, "-o", page, "--texels-per-metre", luxel.choose(80, 20),
                           "--final-gather", gather if not luxel.small or gather == "none" else "20%",
                           "--preview", os.path.join(folder, f"lightmap-{name}.png"), *view(luxel.choose(480, 48)))
        stages = {stage["name"]: stage for stage in report["stages"]}
        measured[name] = {"seconds": stages["lightmap"]["seconds"], "rays": stages["lightmap"].get("rays", 0)}
    shutil.copyfile(luxel.at("lightmap-gathered-page.png"), os.path.join(folder, "lightmap-page.png"))
    return measured
