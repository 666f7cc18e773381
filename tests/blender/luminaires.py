# SPDX-License-Identifier: Apache-2.0
"""A lamp with an IES Texture node has the lumens of its photometric file, whatever its watts and its colour; so has an empty."""
import json
import os

import bpy
import numpy as np

import rooms
import truth

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FILE = os.path.join(ROOT, "scenes", "luminaires", "spotlight.ies")
WASHER = os.path.join(ROOT, "scenes", "luminaires", "wall-washer.ies")
TURN = (0.3, -0.2, 0.7)  # radians
HEIGHT = 2.0  # m
EFFICACY = 179.0  # lm/W


def add_lamp(mode, strength, tint, path=FILE, turn=(0.0, 0.0, 0.0)):
    lamp = rooms.lamp("POINT", (0, 0, HEIGHT), 7.0, turn, shadow_soft_size=0.0, color=tint).data
    lamp.use_nodes = True
    node = lamp.node_tree.nodes.new("ShaderNodeTexIES")
    node.mode = mode
    if mode == "EXTERNAL":
        node.filepath = path
    else:
        node.ies = bpy.data.texts.load(path)
    node.inputs["Strength"].default_value = strength
    emission = next(each for each in lamp.node_tree.nodes if each.type == "EMISSION")
    lamp.node_tree.links.new(node.outputs["Fac"], emission.inputs["Strength"])
    return node


def check_empties(scene):
    """An empty with the properties of docs/luminaires.md lights as a lamp with the same file in the same place does, also
    where it is turned; so does the one that the panel adds."""
    def light(add):
        scene.scene = rooms.fresh_scene()
        item = scene.small_triangles()
        add()
        bpy.context.view_layer.update()
        assert scene.bake(error=0.5, max_edge=0.5) == {"FINISHED"}
        return truth.corner_colours(item, scene.add_on.LAYER)

    def lamp():
        add_lamp("EXTERNAL", 0.5, (1.0, 1.0, 1.0), WASHER, TURN)

    def empty():
        bpy.context.scene.cursor.location = (0, 0, HEIGHT)
        assert bpy.ops.luxel.add_luminaire(filepath=WASHER) == {"FINISHED"}
        item = bpy.context.view_layer.objects.active
        assert item["luminaire"] == WASHER
        item.rotation_euler = TURN
        item["luminaire_dimming"] = 0.5

    wanted, found = light(lamp), light(empty)
    assert wanted.max() > 3.0 * wanted.min() > 0.0, f"the light depends on the direction: {wanted}"
    assert np.allclose(found, wanted, rtol=0.01), f"found {found}, expected {wanted}"
    bpy.context.view_layer.objects.active["luminaire"] = "//none.ldt"
    try:
        scene.bake()
    except RuntimeError as error:
        assert "none.ldt: the photometric file of the empty 'wall-washer' cannot be read" in str(error), error
    else:
        raise AssertionError("a missing photometric file was accepted")


def check(scene):
    """scene: the Check of in_blender.py. Straight below the lamp: candela over the square of the height."""
    candela = json.loads(scene.printed("photometry", FILE, "--json"))["maximum"]["intensity"]
    for mode, strength, tint in (("EXTERNAL", 1.0, (1.0, 1.0, 1.0)), ("INTERNAL", 0.25, (1.0, 0.5, 0.1))):
        scene.scene = rooms.fresh_scene()
        item = scene.small_triangles()
        node = add_lamp(mode, strength, tint)
        bpy.context.view_layer.update()
        assert scene.bake(error=0.5, max_edge=0.5) == {"FINISHED"}, mode
        found = truth.corner_colours(item, scene.add_on.LAYER)[0]
        luminance, wanted = found @ (0.2126, 0.7152, 0.0722), strength * candela / HEIGHT ** 2 / EFFICACY / np.pi
        assert abs(luminance / wanted - 1.0) < 0.01, f"{mode}: found {luminance}, expected {wanted}"
        assert np.allclose(found / found[0], np.array(tint) / tint[0], rtol=0.01), f"{mode}: the colour {found}"
    # A missing file is one sentence.
    node.mode = "EXTERNAL"
    node.filepath = os.path.join(scene.folder, "none.ies")
    try:
        scene.bake()
    except RuntimeError as error:
        assert "none.ies: the file of an IES Texture node cannot be read" in str(error), error
    else:
        raise AssertionError("a missing photometric file was accepted")
    check_empties(scene)
