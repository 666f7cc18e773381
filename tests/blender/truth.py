# SPDX-License-Identifier: Apache-2.0
"""The light that Cycles bakes, as a mean over each quad."""
import os

import bpy
import numpy as np

from rooms import meshes


def settle(scene, samples, seed=0):
    """Path tracing without shortcuts: 64 bounces, nothing clamped, no denoiser."""
    cycles = scene.cycles
    cycles.samples, cycles.seed = samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = 64
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = 0.0
    scene.render.bake.margin = 0


def by_cell(scene, cells, samples, kind="DIFFUSE"):
    """What Cycles bakes, as the mean over each quad, by object: irradiance over pi, or with kind EMIT what shines."""
    settle(scene, samples)
    image = bpy.data.images.new("truth", cells.side, cells.side, alpha=False, float_buffer=True)
    for item in meshes():
        for slot in item.material_slots:
            nodes = slot.material.node_tree.nodes
            node = nodes.get("truth") or nodes.new("ShaderNodeTexImage")
            node.name, node.image = "truth", image
            nodes.active = node
        item.data.uv_layers.active = item.data.uv_layers["Cells"]
        item.select_set(True)
    bpy.context.view_layer.objects.active = meshes()[0]
    bpy.ops.object.bake(type=kind, pass_filter={"DIRECT", "INDIRECT"}, target="IMAGE_TEXTURES", use_clear=True)
    pixels = np.empty(cells.side * cells.side * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return cells.means(pixels)


def at_corners(scene, item, samples):
    """Irradiance over pi of each face of an object, from its corners."""
    settle(scene, samples)
    layer = item.data.color_attributes.new("truth", "FLOAT_COLOR", "CORNER")
    item.data.color_attributes.active_color = layer
    item.select_set(True)
    bpy.context.view_layer.objects.active = item
    bpy.ops.object.bake(type="DIFFUSE", pass_filter={"DIRECT", "INDIRECT"}, target="VERTEX_COLORS")
    return corner_colours(item, "truth")


def corner_colours(item, name):
    """Of each face the mean over it as it is drawn, in triangles: (faces, 3)."""
    mesh = item.data
    layer = mesh.color_attributes[name]
    colours = np.empty(len(layer.data) * 4, np.float32)
    layer.data.foreach_get("color", colours)
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    corners, face, area = np.empty(count * 3, np.int32), np.empty(count, np.int32), np.empty(count, np.float32)
    mesh.loop_triangles.foreach_get("loops" if layer.domain == "CORNER" else "vertices", corners)
    mesh.loop_triangles.foreach_get("polygon_index", face)
    mesh.loop_triangles.foreach_get("area", area)
    mean = colours.reshape(-1, 4)[corners.reshape(-1, 3), :3].mean(axis=1, dtype=np.float64)
    sums = [np.bincount(face, area * channel, len(mesh.polygons)) for channel in mean.T]
    return np.stack(sums, axis=1) / np.bincount(face, area, len(mesh.polygons))[:, None]


def pixels_of(image):
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(image.size[1], image.size[0], 4)


def packed_tiles(image, folder):
    """The tiles of an image from what is packed of them, in their order."""
    found = []
    for packed in sorted(image.packed_files, key=lambda packed: packed.filepath):
        path = os.path.join(folder, "packed.exr")
        with open(path, "wb") as file:
            file.write(packed.packed_file.data)
        read = bpy.data.images.load(path)
        found.append(pixels_of(read))
        bpy.data.images.remove(read)
    return found


def at_middles(item, name, tiles=None):
    """What an image, or its tiles, have at the middle of each face, by the UV map of the same name: (faces, 3)."""
    tiles = np.stack(tiles or [pixels_of(bpy.data.images[name])])
    layer = item.data.uv_layers[name]
    middles = [np.mean([layer.data[loop].uv for loop in face.loop_indices], axis=0) for face in item.data.polygons]
    row = np.floor(middles).astype(int)
    texels = ((np.array(middles) - row) * tiles.shape[2:0:-1]).astype(int)
    return tiles[row[:, 0] + 10 * row[:, 1], texels[:, 1], texels[:, 0], :3]


def areas():
    return {item.name: np.array([face.area for face in item.data.polygons]) for item in meshes()}
