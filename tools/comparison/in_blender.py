# SPDX-License-Identifier: Apache-2.0
"""Renders a scene of scenes.Scene.write_arrays by Cycles, within Blender: in_blender.py -- JSON. See programs.Cycles."""
import json
import sys

import bpy
import numpy
from mathutils import Matrix


def material(name, reflectance, radiance):
    """A Lambertian surface, or a lamp that emits from its front, with a black back."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output, diffuse = nodes.new("ShaderNodeOutputMaterial"), nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*reflectance, 1)
    diffuse.inputs["Roughness"].default_value = 0
    shader = diffuse.outputs[0]
    if max(radiance) > 0:
        emission, mix, side = (nodes.new(f"ShaderNode{kind}") for kind in ("Emission", "MixShader", "NewGeometry"))
        strength = max(radiance)
        emission.inputs["Color"].default_value = (*[value / strength for value in radiance], 1)
        emission.inputs["Strength"].default_value = strength
        links.new(side.outputs["Backfacing"], mix.inputs[0])
        links.new(emission.outputs[0], mix.inputs[1])
        links.new(shader, mix.inputs[2])
        shader = mix.outputs[0]
    links.new(shader, output.inputs["Surface"])
    return made


def main(wanted):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene, data = bpy.context.scene, numpy.load(wanted["arrays"])
    mesh = bpy.data.meshes.new("scene")
    mesh.from_pydata(data["points"].tolist(), [], data["triangles"].tolist())
    for i, (reflectance, radiance) in enumerate(zip(data["reflectance"].tolist(), data["radiance"].tolist())):
        mesh.materials.append(material(str(i), reflectance, radiance))
    mesh.polygons.foreach_set("material_index", data["materials"].astype(numpy.int32))
    scene.collection.objects.link(bpy.data.objects.new("scene", mesh))

    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (*data["sky"].tolist(), 1)

    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle, camera.clip_start = "VERTICAL", float(data["fov"]), 1e-3
    viewer = bpy.data.objects.new("camera", camera)
    placed = numpy.eye(4)
    placed[:3, :3], placed[:3, 3] = data["basis"].T, data["eye"]
    viewer.matrix_world = Matrix(placed.tolist())
    scene.collection.objects.link(viewer)
    scene.camera = viewer

    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = wanted["width"], wanted["height"], 100
    render.threads_mode, render.threads = "FIXED", wanted["threads"]
    render.filepath = wanted["picture"]
    settings = render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth, settings.exr_codec = "OPEN_EXR", "RGB", "32", "ZIP"
    cycles.device, cycles.samples, cycles.seed = "CPU", wanted["samples"], wanted["seed"]
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = wanted["denoise"]
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.max_bounces = cycles.diffuse_bounces = 64
    cycles.pixel_filter_type = "BOX"
    if wanted["denoise"]:
        import _cycles
        if not _cycles.with_openimagedenoise:
            print("without a denoiser")
            sys.exit(3)
        cycles.denoiser = "OPENIMAGEDENOISE"
    bpy.ops.render.render(write_still=True)


main(json.loads(sys.argv[sys.argv.index("--") + 1]))
