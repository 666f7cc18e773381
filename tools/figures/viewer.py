# SPDX-License-Identifier: Apache-2.0
"""The pictures of the viewer's page: each is what the window shows, done by a script off screen."""
import os

from figures.scenes import BOX, CAMERA

# Name: what a person does before the picture is taken.
PICTURES = {
    "preview": "set show grey",
    "light": "set show light\nwait finished\nwait 300 frames",
    "menu": "click 115 10\nwait 10 frames",
    "flying": "key escape\nmove 500 300\nwait 3 frames\nkey tab\nhold W 0.4\nhold D 0.3\nwait finished\nwait 300 frames",
    "irradiance": "key tab\nkey H\nwait 30 frames\nset show irradiance\nmove 560 300\nwait finished",
    "profile": "set show light\ndown shift\ndrag 360 420 720 200\nup shift\nwait 20 frames",
    "standard-error": "key escape\nset show standard-error\nwait finished",
    "patch-size": "set show patch-size\nwait finished",
    "difference": "compare {other}\nset show difference\nwait finished\nwait 30 frames",
    "sides": "set show sides\nset normals on\nwait finished",
    "wires": "set show light\nset normals off\nset wires on\nwait finished",
    "boxes": "set wires off\nset boxes on\nset box-level 6\nwait finished",
    "rays": "set boxes off\nmove 480 420\nset rays on\nset samples on\nwait finished",
    "faults": "set rays off\nset samples off\nset faults on\nwait finished\nwait 10 frames",
    "relit": "set faults off\nlamp lamp 0.5 0.3,0.6,1\npaint white 0.8,0.5,0.5\nwait finished",
    "bounces": "lamp lamp 1 1,1,1\npaint white {white}\nwait finished\nbounces 1\nwait finished",
    "unshot": "bounces all\nstepping on\nmethod shooting\nset show unshot\nwait 200 frames",
    "dialog": "stepping off\nstop\nwait finished\nset show light\ndrop missing.obj\nwait error\nwait 30 frames",
}
NAMES = [f"viewer-{name}.png" for name in PICTURES]


def white_of_the_box():
    """The reflectance of the box's white walls, as its MTL file says."""
    with open(BOX.replace(".obj", ".mtl"), encoding="utf-8") as file:
        material = ""
        for line in file:
            words = line.split()
            if words[:1] == ["newmtl"]:
                material = words[1]
            if words[:1] == ["Kd"] and material == "white":
                return ",".join(words[1:4])
    raise ValueError("the box has no white walls")


def viewer(luxel, folder):
    """One window, everything in it one after the other."""
    edge = luxel.choose(0.05, 0.2)
    other = luxel.at("viewer-other.vtkhdf")
    luxel.run("bake", BOX, "--max-edge", edge, "--error", luxel.choose("4%", "20%"), "--seed", 2, "-o", other)
    lines = ["wait mesh", "set help off"]
    for name, what in PICTURES.items():
        lines.append(what.format(other=other, white=white_of_the_box()))
        lines.append(f"snapshot {os.path.join(folder, f'viewer-{name}.png')}")
    script = luxel.at("viewer.txt")
    with open(script, "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")
    luxel.do("view", BOX, "--max-edge", edge, "--error", luxel.choose("1.5%", "15%"), "--off-screen", "--script", script,
             *CAMERA, "--width", 960, "--height", 600)
    return {"pictures": len(PICTURES)}
