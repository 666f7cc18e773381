# SPDX-License-Identifier: Apache-2.0
"""In Blender: photographs GLB files as they are imported, with no lamp, and compares the pictures with one of Luxel's.

blender --background --factory-startup --python in_blender.py -- LIKE.png WIDTH HEIGHT EYE TARGET FOV OUT.png=FILE.glb...

EYE and TARGET are X,Y,Z in glTF's axes. Prints a line per file: its name and the mean difference in per cent of the
display's range, over the pixels that surfaces cover. The view transform is Standard; all else is as Blender has it.
"""
import math
import sys

import bpy
import numpy
from mathutils import Vector


def point(text):
    x, y, z = (float(number) for number in text.split(","))
    return Vector((x, -z, y))  # Blender's axes: Z up


def pixels(path):
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"  # codes as they are in the file
    values = numpy.array(image.pixels[:], dtype=numpy.float32).reshape(image.size[1], image.size[0], 4)
    bpy.data.images.remove(image)
    return values


def photograph(glb, out, camera, size):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # Debian 12's Blender and numpy open no glTF file with the default, "NORMALS".
    bpy.ops.import_scene.gltf(filepath=glb, import_shading="SMOOTH")
    scene = bpy.context.scene
    eye, target, fov = camera
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit, lens.angle = "VERTICAL", math.radians(fov)
    lens.clip_start = 0.001
    at = bpy.data.objects.new("camera", lens)
    at.location = eye
    at.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(at)
    scene.camera = at
    scene.render.engine = "CYCLES"  # Eevee needs a graphics card
    scene.cycles.samples = 16
    scene.cycles.use_denoising = False
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


def main(like, width, height, eye, target, fov, *jobs):
    camera = point(eye), point(target), float(fov)
    for job in jobs:
        out, glb = job.split("=", 1)
        photograph(glb, out, camera, (int(width), int(height)))
        shown, expected = pixels(out), pixels(like)
        covered = shown[..., 3] > 0.999
        difference = numpy.abs(shown[covered][:, :3] - expected[covered][:, :3]).mean()
        print(f"{glb}: {100 * difference:.3f} % from {like}, {covered.mean():.3f} covered", flush=True)


if __name__ == "__main__":
    main(*sys.argv[sys.argv.index("--") + 1:])
