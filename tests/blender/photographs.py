# SPDX-License-Identifier: Apache-2.0
"""Pictures of the office for docs/blender.md, to be run by Blender: photographs.py -- LUXEL FOLDER small|full.

blender-cycles.png: as Cycles renders it, light path by light path. blender-luxel.png: the same view of the mesh with
Luxel's light in its vertex colours, and no lamp left.
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import bpy  # noqa: E402

import in_blender  # noqa: E402
import rooms  # noqa: E402
import truth  # noqa: E402


def look(scene, size):
    camera = bpy.data.cameras.new("camera")
    item = bpy.data.objects.new("camera", camera)
    camera.angle = math.radians(72)
    item.location, item.rotation_euler = (3.85, 0.35, 1.75), (math.radians(80), 0.0, math.radians(27))
    scene.collection.objects.link(item)
    scene.camera = item
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.view_settings.view_transform, scene.view_settings.exposure = "Standard", -1.6
    scene.cycles.caustics_reflective = scene.cycles.caustics_refractive = False


def render(scene, folder, name, samples):
    truth.settle(scene, samples)
    scene.render.filepath = os.path.join(folder, name)
    bpy.ops.render.render(write_still=True)


def show_baked():
    """Each material shows its colour times the baked light, and what it emits itself."""
    reader = sys.modules["luxel_bake"].MaterialReader()
    for material in [material for material in bpy.data.materials if material.users]:
        surface = reader.read(material)
        tree = material.node_tree
        tree.nodes.clear()
        output, shader, light = (tree.nodes.new("ShaderNode" + kind)
                                 for kind in ("OutputMaterial", "Emission", "VertexColor"))
        light.layer_name = "Luxel"
        step = light.outputs[0]
        for operation, colour in (("MULTIPLY", surface.colour), ("ADD", surface.emission)):
            node = tree.nodes.new("ShaderNodeVectorMath")
            node.operation = operation
            node.inputs[1].default_value = colour
            tree.links.new(step, node.inputs[0])
            step = node.outputs[0]
        tree.links.new(step, shader.inputs[0])
        tree.links.new(shader.outputs[0], output.inputs[0])
    for item in [item for item in bpy.context.scene.objects if item.type == "LIGHT"]:
        bpy.data.objects.remove(item)


def main(luxel, folder, size):
    small = size == "small"
    scene = rooms.fresh_scene()
    rooms.office(cell=0.35 if small else 0.0875)
    in_blender.add_on()
    look(scene, (96, 72) if small else (480, 360))
    render(scene, folder, "blender-cycles.png", 4 if small else 256)
    scene.luxel.error = 5.0 if small else 1.0
    bpy.ops.luxel.bake(program=luxel)
    show_baked()
    render(scene, folder, "blender-luxel.png", 4 if small else 16)


if __name__ == "__main__":
    main(*sys.argv[sys.argv.index("--") + 1:])
