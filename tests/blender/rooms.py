# SPDX-License-Identifier: Apache-2.0
"""Rooms made in Blender, of sheets cut into small quads. Each quad has 4 x 4 texels of its own in the UV map 'Cells', so
that what Cycles bakes into an image can be averaged over it."""
import math

import bpy
import numpy as np
from mathutils import Vector

TEXELS = 4  # along an edge of a cell


def fresh_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    return scene


def paint(name, *colour):
    """A diffuse material; in Cycles' and Luxel's sense both."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    output, shader = nodes.new("ShaderNodeOutputMaterial"), nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*(colour if len(colour) == 3 else colour * 3), 1.0)
    material.node_tree.links.new(shader.outputs[0], output.inputs[0])
    return material


def glow(name, strength):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (0.6, 0.6, 0.6, 1.0)
    shader.inputs["Specular"].default_value = 0.0
    shader.inputs["Emission"].default_value = (1.0, 1.0, 1.0, 1.0)
    shader.inputs["Emission Strength"].default_value = strength
    return material


class Sheets:
    """Quads cut into cells, gathered into one object."""

    def __init__(self, name, material, cell):
        self.name, self.material, self.cell = name, material, cell
        self.places, self.faces = [], []

    def quad(self, corner, along, across):
        """The front is where along x across points."""
        corner, along, across = Vector(corner), Vector(along), Vector(across)
        u, v = (max(1, round(side.length / self.cell)) for side in (along, across))
        first = len(self.places)
        self.places += [corner + along * (i / u) + across * (j / v) for j in range(v + 1) for i in range(u + 1)]
        for j in range(v):
            for i in range(u):
                at = first + j * (u + 1) + i
                self.faces.append((at, at + 1, at + u + 2, at + u + 1))
        return self

    def box(self, low, high, turn=0.0, bottom=True):
        """Outside of a box, turned about its upright axis by degrees."""
        low, high = Vector(low), Vector(high)
        middle, size = 0.5 * (low + high), high - low
        angle = math.radians(turn)
        x = Vector((math.cos(angle), math.sin(angle), 0.0)) * size.x
        y = Vector((-math.sin(angle), math.cos(angle), 0.0)) * size.y
        z = Vector((0.0, 0.0, size.z))
        foot = middle - 0.5 * (x + y + z)
        self.quad(foot + z, x, y)
        if bottom:
            self.quad(foot, y, x)
        self.quad(foot, x, z).quad(foot + x, y, z).quad(foot + x + y, -x, z).quad(foot + y, -y, z)
        return self

    def done(self):
        mesh = bpy.data.meshes.new(self.name)
        mesh.from_pydata(self.places, [], self.faces)
        mesh.materials.append(self.material)
        item = bpy.data.objects.new(self.name, mesh)
        bpy.context.collection.objects.link(item)
        return item


def lamp(kind, place, watts, turn=(0.0, 0.0, 0.0), **more):
    data = bpy.data.lights.new(kind.title(), kind)
    data.energy = watts
    for name, value in more.items():
        setattr(data, name, value)
    item = bpy.data.objects.new(kind.title(), data)
    item.location, item.rotation_euler = place, turn
    bpy.context.collection.objects.link(item)
    return item


def cornell_box(cell=0.03):
    """scenes/cornell-box.obj with Z up and its lamp as one of Blender's: 16.5, 12, 5.5 W/(m² sr) are P / (4 A)."""
    w, h, d = 0.2764, 0.5488, 0.5592
    white, red, green = paint("white", 0.73), paint("red", 0.61, 0.06, 0.05), paint("green", 0.12, 0.44, 0.10)
    shell = Sheets("shell", white, cell)
    shell.quad((-w, 0, 0), (2 * w, 0, 0), (0, d, 0)).quad((-w, d, h), (2 * w, 0, 0), (0, -d, 0))
    shell.quad((-w, d, 0), (2 * w, 0, 0), (0, 0, h))
    shell.done()
    Sheets("left", red, cell).quad((-w, 0, 0), (0, d, 0), (0, 0, h)).done()
    Sheets("right", green, cell).quad((w, d, 0), (0, -d, 0), (0, 0, h)).done()
    blocks = Sheets("blocks", white, cell)
    blocks.box((0.0072, 0.0850, 0), (0.1736, 0.2520, 0.165), -16.6, bottom=False)
    blocks.box((-0.1719, 0.2706, 0), (-0.0080, 0.4366, 0.33), 17.1, bottom=False)
    blocks.done()
    lamp("AREA", (0, 0.2795, 0.5438), 16.5 * 4 * 0.130 * 0.105, shape="RECTANGLE", size=0.130, size_y=0.105,
         color=(1.0, 12.0 / 16.5, 5.5 / 16.5))


def office(cell=0.2):
    """4.2 x 5.6 x 2.8 m: two desks, shelves, a screen, a bulb, a spot, a window that glows, and on the ceiling two panels
    that are area lamps and two that are sheets in openings."""
    w, d, h = 4.2, 5.6, 2.8
    wall, floor, ceiling, wood = paint("wall", 0.7, 0.68, 0.62), paint("floor", 0.25, 0.22, 0.2), \
        paint("ceiling", 0.8), paint("wood", 0.45, 0.3, 0.18)
    Sheets("floor", floor, cell).quad((0, 0, 0), (w, 0, 0), (0, d, 0)).done()
    above = Sheets("ceiling", ceiling, cell)
    above.quad((0, d, h), (w, 0, 0), (0, -1.05, 0)).quad((0, 3.85, h), (w, 0, 0), (0, -3.85, 0))
    panels = Sheets("panels", glow("panel", 40.0), cell)
    for x, width, into in ((0.0, 0.7, above), (0.7, 0.7, panels), (1.4, 1.4, above), (2.8, 0.7, panels),
                           (3.5, 0.7, above)):
        into.quad((x, 4.55, h), (width, 0, 0), (0, -0.7, 0))
    above.done()
    panels.done()
    walls = Sheets("walls", wall, cell)
    walls.quad((0, 0, 0), (0, d, 0), (0, 0, h)).quad((w, d, 0), (0, -d, 0), (0, 0, h))
    walls.quad((w, 0, 0), (-w, 0, 0), (0, 0, h))
    walls.quad((0, d, 0), (w, 0, 0), (0, 0, 0.875)).quad((0, d, 2.1), (w, 0, 0), (0, 0, h - 2.1))
    walls.quad((0, d, 0.875), (0.7, 0, 0), (0, 0, 1.225)).quad((3.5, d, 0.875), (0.7, 0, 0), (0, 0, 1.225))
    walls.done()
    Sheets("window", glow("window", 4.0), cell).quad((0.7, d, 0.875), (2.8, 0, 0), (0, 0, 1.225)).done()
    desks = Sheets("desks", wood, cell)
    for y in (1.05, 3.5):
        desks.box((1.4, y, 0.70), (3.15, y + 0.7, 0.74))
        desks.box((1.5, y + 0.1, 0.0), (1.56, y + 0.6, 0.6999), bottom=False)
        desks.box((3.0, y + 0.1, 0.0), (3.06, y + 0.6, 0.6999), bottom=False)
    desks.done()
    shelf = Sheets("shelf", wood, cell)
    for z in (0.35, 0.7, 1.05, 1.4):
        shelf.box((0.02, 1.4, z), (0.37, 3.15, z + 0.03))
    shelf.done()
    Sheets("screen", paint("felt", 0.2, 0.3, 0.45), cell).quad((1.4, 2.8, 0.05), (1.4, 0, 0), (0, 0, 1.4)).done()
    for x in (1.05, 3.15):
        lamp("AREA", (x, 1.4, h - 0.02), 60.0, shape="RECTANGLE", size=0.6, size_y=0.6)
    lamp("POINT", (0.6, 5.0, 1.5), 15.0, shadow_soft_size=0.08, color=(1.0, 0.8, 0.55))
    lamp("SPOT", (3.6, 0.8, 2.5), 60.0, shadow_soft_size=0.0, spot_size=math.radians(70), spot_blend=0.4)


def meshes():
    return [item for item in bpy.context.scene.objects if item.type == "MESH"]


class Cells:
    """Gives every quad of the scene a square of texels of an image, in the UV map 'Cells': side texels by side."""

    def __init__(self):
        self.first, self.count, count = {}, {}, 0
        for item in meshes():
            self.first[item.name], self.count[item.name] = count, len(item.data.polygons)
            count += len(item.data.polygons)
        across = math.ceil(math.sqrt(count))
        self.side = across * TEXELS
        square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])[None]
        for item in meshes():
            cells = self.first[item.name] + np.arange(self.count[item.name])
            corner = np.stack([cells % across, cells // across], axis=1)[:, None, :]
            layer = item.data.uv_layers.new(name="Cells")
            layer.data.foreach_set("uv", ((corner + square) / across).astype(np.float32).reshape(-1))

    def means(self, pixels):
        """Of an image the mean in each cell, by object: arrays of (quads, 3)."""
        across = self.side // TEXELS
        cells = pixels.reshape(across, TEXELS, across, TEXELS, 4)[..., :3].mean(axis=(1, 3), dtype=np.float64)
        cells = cells.reshape(-1, 3)
        return {name: cells[first:first + self.count[name]] for name, first in self.first.items()}
