# SPDX-License-Identifier: Apache-2.0
"""Bakes the diffuse light of a Blender scene with Luxel, into vertex colours or a lightmap.

The scene is written as a GLB, `luxel bake` finds its light, and the light comes back to the corners of the meshes.
Cycles' units are kept: one Blender unit counts as a metre, and light is in W/m², so what is baked is what Cycles'
diffuse bake finds. Written for Blender 3.4 and tested there; what later versions call otherwise is handled where it is
read (Principled BSDF and the linear colour space of 4.0, exposure and temperature of lamps of 4.5), from their
documentation. docs/blender.md says how to use it and what it does not do.
"""
import json
import math
import os
import queue
import shutil
import struct
import subprocess
import tempfile
import threading
import time
import zlib

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector

bl_info = {
    "name": "Luxel bake",
    "author": "Luxel",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Render > Luxel",
    "description": "Bakes diffuse light into vertex colours or lightmaps with Luxel",
    "category": "Render",
}  # of an extension, from Blender 4.2, blender_manifest.toml is read instead; tools/pack_addon.py checks that they agree

LAYER = "Luxel"  # the name of what is baked: colour attribute, UV map, image
EFFICACY = 179.0  # lm/W, Luxel's own: cd/m² and cd of the file over W
LUMINANCE = np.array((0.2126, 0.7152, 0.0722))  # of linear sRGB
SHEET_GAP = 2e-4  # m, between the two sides of a sheet that emits; surfaces nearer than 1e-4 m touch
LAMP_GAP = 5e-4  # m, that an area lamp hangs before the surface it lies in
LAMP_REFLECTANCE = 0.8  # of what there is of area lamps
LAMP_CELLS = 10  # along an edge of an area lamp; light goes through it in Cycles, so it is squares with gaps
LAMP_SQUARE = 0.25  # of a cell's edge, is a square's: a sixteenth of the lamp is in the way
# Custom properties of an empty with a photometric file, beside 'luminaire' itself, as docs/luminaires.md has them.
LUMINAIRE_PROPERTIES = ("luminaire_dimming", "luminaire_maintenance", "luminaire_group", "luminaire_turn",
                        "luminaire_lamp_set")


class BakeError(Exception):
    """What went wrong, in a sentence for the user."""


# ---- What a material is made of ----


class Picture:
    """An image as a texture: which image, by which UV map, placed and continued how."""

    def __init__(self, image, uv_map, placing, extension):
        self.image, self.uv_map, self.placing, self.extension = image, uv_map, placing, extension


class Surface:
    """What diffuse light sees of a material. Colours are linear: reflectance 0 to 1, emission W/(m² sr)."""

    def __init__(self):
        self.colour, self.colour_picture = np.zeros(3), None
        self.emission, self.emission_picture = np.zeros(3), None
        self.passes = 0.0  # share of the light that goes through
        self.alpha_picture = None
        self.colours = None  # the name of a colour attribute that multiplies the colour

    def scaled(self, factor):
        self.colour, self.emission = self.colour * factor, self.emission * factor
        self.passes *= factor
        return self

    def plus(self, other):
        for name in ("colour", "emission"):
            mine, theirs = getattr(self, name), getattr(other, name)
            if theirs.sum() > mine.sum():  # one picture a surface: that of the larger share
                setattr(self, name + "_picture", getattr(other, name + "_picture"))
            setattr(self, name, mine + theirs)
        self.passes += other.passes
        self.alpha_picture = self.alpha_picture or other.alpha_picture
        self.colours = self.colours or other.colours
        return self


class MaterialReader:
    """Reads node trees; what it has to leave out is noted, once for each material."""

    def __init__(self, gloss_is_diffuse=True):
        self.gloss_is_diffuse = gloss_is_diffuse
        self.notes = []
        self.name = ""

    def note(self, text):
        line = f"material '{self.name}': {text}"
        if line not in self.notes:
            self.notes.append(line)

    def read(self, material):
        self.name = material.name if material else "none"
        surface = Surface()
        if material is None:
            surface.colour = np.full(3, 0.8)  # Blender's grey
        elif not material.use_nodes or material.node_tree is None:
            surface.colour = np.array(material.diffuse_color[:3])
        else:
            output = material.node_tree.get_output_node("CYCLES")
            if output is not None and output.inputs["Surface"].links:
                surface = self.shader(output.inputs["Surface"])
        return surface

    def shader(self, socket):
        node = source_of(socket)
        if node is None:
            return Surface()
        reader = getattr(self, "read_" + node.type.lower(), None)
        if reader is None:
            self.note(f"the shader '{node.bl_label}' is taken as black")
            return Surface()
        return reader(node)

    def read_bsdf_principled(self, node):
        metallic = self.number(node.inputs["Metallic"])
        passes = self.number(named(node.inputs, "Transmission", "Transmission Weight")) * (1.0 - metallic)
        surface = Surface()
        surface.colour, surface.colour_picture, surface.colours = self.colour(node.inputs["Base Color"])
        # Principled's own reflectance at normal incidence; light from all around would meet twice as much.
        shine = self.reflectance_of_gloss(node) if self.gloss_is_diffuse else 0.0
        if surface.colour_picture is None and surface.colours is None:
            metal = surface.colour * metallic if self.gloss_is_diffuse else 0.0
            surface.colour = (surface.colour * (1.0 - metallic) + shine * (1.0 - metallic) + metal) * (1.0 - passes)
        else:  # a factor of the picture: what shines takes its colour
            surface.colour = surface.colour * (1.0 if self.gloss_is_diffuse else 1.0 - metallic) * (1.0 - passes)
        if metallic > 0.0:
            self.note("metal is taken as " + ("diffuse" if self.gloss_is_diffuse else "dark"))
        surface.emission, surface.emission_picture, _ = self.colour(named(node.inputs, "Emission", "Emission Color"))
        surface.emission = surface.emission * self.number(node.inputs["Emission Strength"])
        surface.passes = passes
        alpha = source_of(node.inputs["Alpha"])
        if alpha is not None and alpha.type == "TEX_IMAGE":
            surface.alpha_picture = self.picture(alpha)
        else:
            surface.passes = 1.0 - (1.0 - passes) * self.number(node.inputs["Alpha"])
        return surface

    def reflectance_of_gloss(self, node):
        """At normal incidence. From 4.0 on Specular scales that of the index of refraction, with 0.5 for all of it; before,
        it had a factor of its own."""
        if "Specular" in node.inputs:
            return 0.08 * self.number(node.inputs["Specular"])
        index = self.number(node.inputs["IOR"])
        return 2.0 * self.number(node.inputs["Specular IOR Level"]) * ((index - 1.0) / (index + 1.0)) ** 2

    def read_bsdf_diffuse(self, node):
        surface = Surface()
        surface.colour, surface.colour_picture, surface.colours = self.colour(node.inputs["Color"])
        return surface

    def read_emission(self, node):
        surface = Surface()
        surface.emission, surface.emission_picture, _ = self.colour(node.inputs["Color"])
        surface.emission = surface.emission * self.number(node.inputs["Strength"])
        return surface

    def read_bsdf_transparent(self, node):
        surface = Surface()
        surface.passes = float(np.mean(self.colour(node.inputs["Color"])[0]))
        return surface

    read_bsdf_glass = read_bsdf_refraction = read_bsdf_transparent

    def read_add_shader(self, node):
        return self.shader(node.inputs[0]).plus(self.shader(node.inputs[1]))

    def read_mix_shader(self, node):
        first, second = self.shader(node.inputs[1]), self.shader(node.inputs[2])
        factor = source_of(node.inputs[0])
        if factor is not None and factor.type == "TEX_IMAGE" and first.passes > 0.99:
            second.alpha_picture = self.picture(factor)
            return second
        share = self.number(node.inputs[0])
        return first.scaled(1.0 - share).plus(second.scaled(share))

    def number(self, socket):
        node = source_of(socket)
        if node is not None and node.type == "VALUE":
            return float(node.outputs[0].default_value)
        if node is not None:
            self.note(f"what is linked to '{socket.name}' is taken as {socket.default_value:.3g}")
        return float(socket.default_value)

    def colour(self, socket):
        """A colour, the picture that multiplies it and the colour attribute that does, or None each."""
        node = source_of(socket)
        if node is None:
            return np.array(socket.default_value[:3]), None, None
        if node.type == "RGB":
            return np.array(node.outputs[0].default_value[:3]), None, None
        if node.type == "TEX_IMAGE" and node.image is not None:
            return np.ones(3), self.picture(node), None
        if node.type == "VERTEX_COLOR":
            return np.ones(3), None, node.layer_name
        if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY":
            return np.ones(3), None, node.attribute_name
        self.note(f"what the node '{node.bl_label}' makes of '{socket.name}' is taken as its plain colour")
        return np.array(socket.default_value[:3]), None, None

    def picture(self, node):
        uv_map, placing = "", Matrix.Identity(4)
        source = source_of(node.inputs["Vector"])
        while source is not None:
            if source.type == "UVMAP":
                uv_map, source = source.uv_map, None
            elif source.type == "MAPPING" and source.vector_type == "POINT":
                step = Matrix.LocRotScale(*(source.inputs[name].default_value.copy()
                                            for name in ("Location", "Rotation", "Scale")))
                placing, source = placing @ step, source_of(source.inputs["Vector"])
            else:
                if not (source.type == "TEX_COORD" and source.outputs["UV"].is_linked):
                    self.note(f"a texture placed by '{source.bl_label}' is placed by the UV map")
                source = None
        return Picture(node.image, uv_map, placing, node.extension)


def named(items, *names):
    """The socket of the first of these names: versions of Blender differ."""
    return next(items[name] for name in names if name in items)


def source_of(socket):
    """The node that is linked to a socket; reroutes are followed."""
    while socket.is_linked:
        node = socket.links[0].from_node
        if node.type != "REROUTE":
            return node
        socket = node.inputs[0]
    return None


# ---- Pictures as PNG ----


def to_srgb(linear):
    low = linear <= 0.0031308
    return np.where(low, 12.92 * linear, 1.055 * np.power(np.maximum(linear, 0.0031308), 1.0 / 2.4) - 0.055)


def png_of(image):
    """The bytes of a PNG (or of the image's own file) in sRGB codes, and what its values are to be multiplied with."""
    if image.size[0] == 0 or image.size[1] == 0:
        raise BakeError(f"the image '{image.name}' cannot be read")
    if image.colorspace_settings.name == "sRGB" and not image.is_dirty and not image.is_float:
        own = bytes_of(image)
        if own[:8] == b"\x89PNG\r\n\x1a\n" or own[:3] == b"\xff\xd8\xff":
            return own, 1.0
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)  # of images in bytes as stored, of others linear
    pixels = pixels.reshape(image.size[1], image.size[0], 4)[::-1]
    scale = 1.0
    if image.is_float or image.colorspace_settings.name != "sRGB":
        scale = max(1.0, float(pixels[..., :3].max()))
        pixels = np.concatenate([to_srgb(pixels[..., :3] / scale), pixels[..., 3:]], axis=2)
    return write_png(np.round(np.clip(pixels, 0.0, 1.0) * 255.0).astype(np.uint8)), scale


def bytes_of(image):
    if image.packed_file is not None:
        return bytes(image.packed_file.data)
    path = bpy.path.abspath(image.filepath, library=image.library)
    if image.source != "FILE" or not os.path.isfile(path):
        return b""
    with open(path, "rb") as file:
        return file.read()


def write_png(rgba):
    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    height, width = rgba.shape[:2]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), rgba.reshape(height, width * 4)], axis=1)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))


def to_linear(codes):
    return np.where(codes <= 0.04045, codes / 12.92, ((np.maximum(codes, 0.04045) + 0.055) / 1.055) ** 2.4)


# ---- A GLB, written and read ----


class GlbWriter:
    """Collects a glTF file. Y is up in glTF: everything hangs on one node that turns Z there."""

    def __init__(self):
        self.json = {"asset": {"version": "2.0", "generator": "Luxel's add-on for Blender"}, "scene": 0,
                     "scenes": [{"nodes": [0]}],
                     "nodes": [{"name": "Blender", "children": [],
                                "matrix": [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1]}],
                     "extensionsUsed": []}
        self.body = bytearray()

    def add(self, kind, item):
        items = self.json.setdefault(kind, [])
        items.append(item)
        return len(items) - 1

    def extension(self, owner, name, content):
        owner.setdefault("extensions", {})[name] = content
        if name not in self.json["extensionsUsed"]:
            self.json["extensionsUsed"].append(name)

    def node(self, name, matrix, **what):
        node = {"name": name, **what}
        if matrix is not None:
            node["matrix"] = [matrix[row][column] for column in range(4) for row in range(4)]
        self.json["nodes"][0]["children"].append(self.add("nodes", node))
        return node

    def view(self, data):
        self.body += b"\0" * (-len(self.body) % 4)
        view = self.add("bufferViews", {"buffer": 0, "byteOffset": len(self.body), "byteLength": len(data)})
        self.body += data
        return view

    def array(self, values, with_bounds=False):
        kind = "SCALAR" if values.ndim == 1 else f"VEC{values.shape[1]}"
        is_index = values.dtype == np.uint32
        accessor = {"bufferView": self.view(values.tobytes()), "componentType": 5125 if is_index else 5126,
                    "count": len(values), "type": kind}
        if with_bounds:
            accessor["min"], accessor["max"] = values.min(axis=0).tolist(), values.max(axis=0).tolist()
        return self.add("accessors", accessor)

    def write(self, path):
        self.body += b"\0" * (-len(self.body) % 4)
        if self.body:
            self.json["buffers"] = [{"byteLength": len(self.body)}]
        if not self.json["extensionsUsed"]:
            del self.json["extensionsUsed"]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.body)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.body), b"BIN\0") + self.body)


class GlbReader:
    """Reads arrays of a GLB."""

    FORMATS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
    WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        if data[:4] != b"glTF":
            raise BakeError(f"{path} is no GLB file")
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.body = data[28 + length:]

    def array(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        form = np.dtype(self.FORMATS[accessor["componentType"]])
        width = self.WIDTHS[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * form.itemsize)
        return np.ndarray((accessor["count"], width), form, self.body, begin, (stride, form.itemsize)).copy()


# ---- The scene as a GLB ----


class Exporter:
    """Writes what Cycles would see of the scene. meshes has, for each object, the number of the file's mesh, which
    loops of the mesh the vertices of each of its primitives are, and how many loops there are."""

    def __init__(self, context, culled_is_one_sided=False, gloss_is_diffuse=True):
        self.context = context
        self.culled_is_one_sided = culled_is_one_sided
        self.glb = GlbWriter()
        self.reader = MaterialReader(gloss_is_diffuse)
        self.materials = {}
        self.surfaces = {}
        self.images = {}
        self.meshes = {}
        self.photometry = {}  # names beside the scene of photometric files, by path and content
        self.sky = np.zeros(3)
        # Cycles takes a Blender unit for a metre, whatever the scene's unit scale; our gaps are true metres.
        self.unit = 1.0 / max(context.scene.unit_settings.scale_length, 1e-9)

    @property
    def notes(self):
        return self.reader.notes

    def write(self, path):
        graph = self.context.evaluated_depsgraph_get()
        for instance in graph.object_instances:
            source = instance.instance_object if instance.is_instance else instance.object
            if source is None or source.hide_render or (instance.parent and instance.parent.hide_render):
                continue
            matrix = instance.matrix_world.copy()
            if source.type == "LIGHT":
                self.add_lamp(source, matrix)
            elif source.type == "EMPTY" and isinstance(source.original.get("luminaire"), str):
                self.add_luminaire_of_empty(source, matrix)
            elif source.type in {"MESH", "CURVE", "SURFACE", "FONT", "META"} and instance.show_self:
                self.add_object(source, matrix, is_own=not instance.is_instance)
        self.add_world(self.context.scene.world)
        self.write_photometry(os.path.dirname(path))
        self.glb.write(path)

    # Meshes.

    def add_object(self, source, matrix, is_own):
        mesh = source.to_mesh()
        if mesh is None:
            return
        try:
            mesh.calc_loop_triangles()
            if len(mesh.loop_triangles) > 0:
                primitives, parts = self.primitives_of(source, mesh, matrix)
                number = self.glb.add("meshes", {"name": source.name, "primitives": primitives})
                self.glb.node(source.name, matrix, mesh=number)
                if is_own and source.type == "MESH":
                    self.meshes[source.original.name] = (number, parts, len(mesh.loops))
        finally:
            source.to_mesh_clear()

    def primitives_of(self, source, mesh, matrix):
        count = len(mesh.loop_triangles)
        corners, slots = np.empty(count * 3, np.int32), np.empty(count, np.int32)
        mesh.loop_triangles.foreach_get("loops", corners)
        mesh.loop_triangles.foreach_get("material_index", slots)
        corners = corners.reshape(-1, 3)
        vertex = column(mesh.loops, "vertex_index", 1, np.int32)
        places = column(mesh.vertices, "co", 3)
        face = face_of_loops(mesh)
        primitives, parts = [], []
        slots = np.minimum(slots, max(len(source.material_slots) - 1, 0))
        for slot in np.unique(slots):
            material = source.material_slots[slot].material if source.material_slots else None
            triangles = np.flatnonzero(slots == slot)
            loops, indices = np.unique(corners[triangles], return_inverse=True)
            indices = indices.reshape(-1, 3).astype(np.uint32)
            position = np.ascontiguousarray(places[vertex[loops]], np.float32)
            surface = self.surface(material)
            attributes = {"POSITION": self.glb.array(position, with_bounds=True)}
            self.add_coordinates(attributes, mesh, surface, loops)
            self.add_colours(attributes, mesh, surface, loops, vertex)
            # So that what Luxel makes of it can be told to come from here: see Corners.
            attributes["_FACE"] = self.glb.array(face[loops].astype(np.float32))
            attributes["_LOOP"] = self.glb.array(loops.astype(np.float32))
            primitive = {"attributes": attributes, "indices": self.glb.array(indices.reshape(-1)),
                         "material": self.material(material)}
            primitives.append(primitive)
            parts.append(loops)
            if surface.emission.max() > 0.0 and not is_closed(mesh):
                self.add_back(source, primitive, position, indices, matrix)
        return primitives, parts

    def add_coordinates(self, attributes, mesh, surface, loops):
        for number, (name, placing) in enumerate(coordinates_of(surface)):
            layer = mesh.uv_layers.get(name) if name else next(
                (layer for layer in mesh.uv_layers if layer.active_render), None)
            if layer is None:
                continue
            uv = column(layer.data, "uv", 2)[loops]
            uv = np.concatenate([uv, np.zeros_like(uv[:, :1]), np.ones_like(uv[:, :1])], axis=1)
            uv = (uv @ np.array(placing).T)[:, :2]
            uv[:, 1] = 1.0 - uv[:, 1]
            attributes[f"TEXCOORD_{number}"] = self.glb.array(uv.astype(np.float32))

    def add_colours(self, attributes, mesh, surface, loops, vertex):
        layer = mesh.color_attributes.get(surface.colours) if surface.colours else None
        if layer is None:
            return
        colours = column(layer.data, "color", 4)
        colours = colours[loops] if layer.domain == "CORNER" else colours[vertex[loops]]
        attributes["COLOR_0"] = self.glb.array(np.ascontiguousarray(np.clip(colours[:, :3], 0.0, 1.0), np.float32))

    def add_back(self, source, primitive, position, indices, matrix):
        """A sheet shines from both sides in Cycles, from its front in Luxel: the back is a sheet of its own."""
        world = np.concatenate([position, np.ones_like(position[:, :1])], axis=1) @ np.array(matrix).T
        corner = world[indices][:, :, :3]  # all triangles apart, as each goes its own way back
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        if matrix.determinant() < 0.0:
            normal = -normal
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
        corner = (corner - SHEET_GAP * self.unit * normal[:, None, :])
        order = (0, 2, 1) if matrix.determinant() > 0.0 else (0, 1, 2)
        back = corner[:, order].reshape(-1, 3).astype(np.float32)
        taken = indices[:, order].reshape(-1)
        attributes = {"POSITION": self.glb.array(back, with_bounds=True)}
        for name, number in primitive["attributes"].items():
            if name == "POSITION" or name.startswith("_"):
                continue
            accessor = self.glb.json["accessors"][number]
            view = self.glb.json["bufferViews"][accessor["bufferView"]]
            width = GlbReader.WIDTHS[accessor["type"]]
            values = np.frombuffer(self.glb.body, np.float32, accessor["count"] * width, view["byteOffset"])
            attributes[name] = self.glb.array(values.reshape(-1, width)[taken].copy())
        mesh = self.glb.add("meshes", {"name": source.name + " back", "primitives": [
            {"attributes": attributes, "material": primitive["material"]}]})
        self.glb.node(source.name + " back", None, mesh=mesh)

    # Materials.

    def surface(self, material):
        key = material.name_full if material else None
        if key not in self.surfaces:
            self.surfaces[key] = self.reader.read(material)
        return self.surfaces[key]

    def material(self, material):
        key = material.name_full if material else None
        if key not in self.materials:
            self.materials[key] = self.glb.add("materials", self.describe(material, self.surface(material)))
        return self.materials[key]

    def describe(self, material, surface):
        base = {"metallicFactor": 0.0, "baseColorFactor": [*np.clip(surface.colour, 0.0, 1.0).tolist(), 1.0]}
        culled = material is not None and material.use_backface_culling and self.culled_is_one_sided
        item = {"name": material.name if material else "none", "pbrMetallicRoughness": base,
                "doubleSided": not culled}
        coordinates = coordinates_of(surface)
        picture = surface.colour_picture
        if picture is not None:
            base["baseColorTexture"], _ = self.texture(picture, coordinates)
        if surface.alpha_picture is not None:
            if picture is None or picture.image != surface.alpha_picture.image:
                self.reader.name = item["name"]
                self.reader.note("alpha from another picture than the colour is not taken over")
            else:
                item["alphaMode"] = "MASK"
        if surface.emission.max() > 0.0:
            self.emit(item, surface.emission, surface.emission_picture, coordinates)
        elif surface.passes > 0.5:  # the base colour would be its transmittance
            base.pop("baseColorTexture", None)
            base["baseColorFactor"] = [1.0, 1.0, 1.0, 1.0]
            self.glb.extension(item, "KHR_materials_transmission", {"transmissionFactor": 1.0})
        return item

    def emit(self, item, radiance, picture=None, coordinates=()):
        """radiance: W/(m² sr). The file has cd/m²."""
        if picture is not None:
            item["emissiveTexture"], scale = self.texture(picture, coordinates)
            radiance = radiance * scale
        most = float(np.max(radiance))
        item["emissiveFactor"] = (np.maximum(radiance, 0.0) / most).tolist()
        self.glb.extension(item, "KHR_materials_emissive_strength", {"emissiveStrength": most * EFFICACY})

    def texture(self, picture, coordinates):
        if picture.image.name_full not in self.images:
            data, scale = png_of(picture.image)
            kind = "image/jpeg" if data[:3] == b"\xff\xd8\xff" else "image/png"
            image = self.glb.add("images", {"bufferView": self.glb.view(data), "mimeType": kind})
            self.images[picture.image.name_full] = (image, scale)
        image, scale = self.images[picture.image.name_full]
        wrap = 10497 if picture.extension == "REPEAT" else 33071
        sampler = self.glb.add("samplers", {"wrapS": wrap, "wrapT": wrap})
        texture = self.glb.add("textures", {"source": image, "sampler": sampler})
        return {"index": texture, "texCoord": coordinates.index((picture.uv_map, frozen(picture.placing)))}, scale

    # Lamps, as Cycles in Blender 3.4 understands their watts.

    def add_lamp(self, source, matrix):
        lamp = source.data
        if self.ies_node(lamp) is not None:
            self.add_luminaire(source, matrix)
            return
        colour = colour_of_lamp(lamp) * lamp.energy * 2.0 ** getattr(lamp, "exposure", 0.0) * self.lamp_nodes(lamp)
        of_cycles = getattr(lamp, "cycles", None)  # which may be switched off
        if colour.max() <= 0.0 or (lamp.type == "AREA" and of_cycles is not None and of_cycles.is_portal):
            return
        if not getattr(lamp, "normalize", True):  # from 4.5 on
            self.notes.append(f"lamp '{source.name}': its power is taken as that of the whole lamp, as with Normalize")
        if lamp.type == "SUN":
            self.add_punctual(source, matrix, "directional", colour)  # W/m² on what faces it
        elif lamp.type == "AREA":
            self.add_area_lamp(source, matrix, colour)
        elif lamp.type == "SPOT":
            self.add_spot(source, matrix, colour / (4.0 * math.pi))
        elif lamp.shadow_soft_size > 1e-3 * self.unit:
            self.add_ball(source, matrix, colour)
        else:
            self.add_punctual(source, matrix, "point", colour / (4.0 * math.pi))

    @staticmethod
    def emission_of(lamp):
        """The Emission node that makes the light of a lamp, or None."""
        if not lamp.use_nodes or lamp.node_tree is None:
            return None
        output = lamp.node_tree.get_output_node("CYCLES")
        node = source_of(output.inputs["Surface"]) if output is not None else None
        return node if node is not None and node.type == "EMISSION" else None

    def ies_node(self, lamp):
        """The IES Texture node that is linked to the strength of a lamp's Emission node, or None."""
        emission = self.emission_of(lamp)
        node = source_of(emission.inputs["Strength"]) if emission is not None else None
        return node if node is not None and node.type == "TEX_IES" else None

    def add_luminaire(self, source, matrix):
        """The lumens are those of the photometric file, times the Strength of its node; the lamp's watts do not count, and
        its colour changes no lumens."""
        lamp = source.data
        node = self.ies_node(lamp)
        self.reader.name = lamp.name
        dimming = self.reader.number(node.inputs["Strength"])
        colour = colour_of_lamp(lamp) * self.reader.colour(self.emission_of(lamp).inputs["Color"])[0]
        luminance = float(colour @ LUMINANCE)
        if lamp.energy <= 0.0 or dimming <= 0.0 or luminance <= 0.0:
            return
        if node.inputs["Vector"].is_linked:
            self.reader.note("the vector of an IES Texture node is not taken over: the luminaire aims as its lamp does")
        lights = self.glb.json.setdefault("extensions", {}).setdefault("EXT_lights_ies", {"lights": []})["lights"]
        lights.append({"name": source.name, "mimeType": "application/x-ies-lm-63", "bufferView": self.glb.view(photometry_of(node))})
        placed = self.glb.node(source.name, unscaled(matrix))
        self.glb.extension(placed, "EXT_lights_ies", {"light": len(lights) - 1, "multiplier": dimming,
                                                      "color": (colour / luminance).tolist()})

    def add_luminaire_of_empty(self, source, matrix):
        """An empty with the custom property 'luminaire', the path of an IES or EULUMDAT file, and where needed
        luminaire_dimming, luminaire_turn and so on: docs/luminaires.md. It aims at the empty's -Z, with horizontal angle 0
        along its X. The file is put beside the scene; in extras a luminaire aims at -Y, to which the node is turned."""
        source = source.original  # whose properties are those of now
        path = bpy.path.abspath(source["luminaire"], library=source.library)
        try:
            with open(path, "rb") as file:
                content = file.read()
        except OSError as error:
            raise BakeError(f"{path}: the photometric file of the empty '{source.name}' cannot be read: "
                            f"{error.strerror}") from error
        name = f"luminaire-{len(self.photometry)}{os.path.splitext(path)[1].lower()}"
        name = self.photometry.setdefault((path, content), name)
        group = os.path.splitext(os.path.basename(path))[0]
        extras = {key: source[key] for key in LUMINAIRE_PROPERTIES if key in source}
        with_up = unscaled(matrix) @ Matrix.Rotation(math.radians(90.0), 4, "X")
        self.glb.node(source.name, with_up, extras={"luminaire_group": group, **extras, "luminaire": name})

    def write_photometry(self, folder):
        for (_, content), name in self.photometry.items():
            with open(os.path.join(folder, name), "wb") as file:
                file.write(content)

    def lamp_nodes(self, lamp):
        """What an Emission node multiplies a lamp with."""
        if not lamp.use_nodes or lamp.node_tree is None:
            return np.ones(3)
        self.reader.name = lamp.name
        node = self.emission_of(lamp)
        if node is None:
            return np.zeros(3)
        return self.reader.colour(node.inputs["Color"])[0] * self.reader.number(node.inputs["Strength"])

    def add_punctual(self, source, matrix, kind, watts, name="", **more):
        """watts: W/sr of points and spots, W/m² of the sun. The file has candela and lux."""
        most = float(watts.max())
        light = {"type": kind, "name": name or source.name, "color": (watts / most).tolist(),
                 "intensity": most * EFFICACY, **more}
        lights = self.glb.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append(light)
        node = self.glb.node(name or source.name, unscaled(matrix))
        self.glb.extension(node, "KHR_lights_punctual", {"light": len(lights) - 1})

    def add_spot(self, source, matrix, watts):
        """The profile of Blender's spot is the sum of a few of glTF's."""
        lamp = source.data
        for number, (weight, inner, outer) in enumerate(spot_parts(lamp.spot_size, lamp.spot_blend)):
            self.add_punctual(source, matrix, "spot", watts * weight, f"{source.name} {number}",
                              spot={"innerConeAngle": inner, "outerConeAngle": outer})

    def add_area_lamp(self, source, matrix, watts):
        """Radiance P / (4 A), from the side that -Z points to; the area is that of its squares, after scaling."""
        lamp = source.data
        x = 0.5 * lamp.size
        y = 0.5 * (lamp.size_y if lamp.shape in {"RECTANGLE", "ELLIPSE"} else lamp.size)
        middle = (2.0 * np.arange(LAMP_CELLS) + 1.0) / LAMP_CELLS - 1.0
        middle = np.stack(np.meshgrid(middle, middle), axis=-1).reshape(-1, 2)
        if lamp.shape in {"DISK", "ELLIPSE"}:
            middle = middle[(middle ** 2).sum(axis=1) <= 1.0]
        square = np.array([(-1, -1), (-1, 1), (1, 1), (1, -1)]) * (LAMP_SQUARE / LAMP_CELLS)
        place = ((middle[:, None, :] + square) * (x, y)).reshape(-1, 2)
        place = np.concatenate([place, np.zeros((len(place), 1))], axis=1)
        if lamp.spread < math.radians(179.0):
            self.notes.append(f"lamp '{source.name}': its spread is taken as 180 degrees")
        world = np.array(matrix)
        place = place @ world[:3, :3].T + world[:3, 3]
        normal = -np.cross(world[:3, 0], world[:3, 1])  # Cycles' own, also of a mirrored lamp
        normal /= max(np.linalg.norm(normal), 1e-30)
        if normal @ world[:3, 2] > 0.0:
            normal = -normal
        first = 4 * np.arange(len(middle))[:, None]
        indices = np.stack([first + (0, 1, 2), first + (0, 2, 3)], axis=1).reshape(-1, 3).astype(np.uint32)
        corner = place[indices]
        across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        area = 0.5 * np.linalg.norm(across, axis=1).sum()
        if area <= 0.0:
            return
        if across[0] @ normal < 0.0:
            indices = indices[:, ::-1]
        self.add_shining(source, place + LAMP_GAP * self.unit * normal, indices, watts / (4.0 * area),
                         LAMP_REFLECTANCE)

    def add_ball(self, source, matrix, watts):
        """A point lamp with a radius: a ball of the same watts. It stands in no lamp's way, as it gives back what meets
        it."""
        place, triangles = ball()
        place = place * source.data.shadow_soft_size + np.array(matrix.translation)
        corner = place[triangles]
        area = 0.5 * np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1).sum()
        self.add_shining(source, place, triangles, watts / (math.pi * area), 0.98)

    def add_shining(self, source, place, triangles, radiance, reflectance):
        item = {"name": source.name, "doubleSided": True,
                "pbrMetallicRoughness": {"metallicFactor": 0.0, "baseColorFactor": [reflectance] * 3 + [1.0]}}
        self.emit(item, radiance)
        primitive = {"attributes": {"POSITION": self.glb.array(place.astype(np.float32), with_bounds=True)},
                     "indices": self.glb.array(np.ascontiguousarray(triangles).reshape(-1).astype(np.uint32)),
                     "material": self.glb.add("materials", item)}
        mesh = self.glb.add("meshes", {"name": source.name, "primitives": [primitive]})
        self.glb.node(source.name, None, mesh=mesh)

    def add_world(self, world):
        """The same radiance all around; of a picture its mean."""
        if world is None:
            return
        self.reader.name = world.name
        if not world.use_nodes or world.node_tree is None:
            self.sky = np.array(world.color)
            return
        output = world.node_tree.get_output_node("CYCLES")
        node = source_of(output.inputs["Surface"]) if output is not None else None
        if node is None or node.type != "BACKGROUND":
            return
        around = source_of(node.inputs["Color"])
        if around is not None and around.type == "TEX_ENVIRONMENT" and around.image is not None:
            self.sky = mean_around(around.image)
            self.reader.note("of the picture around the scene its mean is taken")
        else:
            self.sky = self.reader.colour(node.inputs["Color"])[0]
        self.sky = self.sky * self.reader.number(node.inputs["Strength"])


def colour_of_lamp(lamp):
    """From 4.5 on a temperature may tint it."""
    colour = np.array(lamp.color)
    return colour * np.array(lamp.temperature_color) if getattr(lamp, "use_temperature", False) else colour


def photometry_of(node):
    """The photometric file of an IES Texture node, which is a text of the .blend or a file."""
    if node.mode == "INTERNAL":
        if node.ies is None:
            raise BakeError("an IES Texture node has no text: choose one, or a file")
        return node.ies.as_string().encode("utf-8")
    path = bpy.path.abspath(node.filepath)
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        raise BakeError(f"{path}: the file of an IES Texture node cannot be read: {error.strerror}") from error


def column(items, name, width, kind=np.float32):
    values = np.empty(len(items) * width, kind)
    items.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def face_of_loops(mesh):
    return np.repeat(np.arange(len(mesh.polygons)), column(mesh.polygons, "loop_total", 1, np.int32))


def is_closed(mesh):
    """Whether every edge has two faces: then only one side of each can be seen."""
    used = np.bincount(column(mesh.loops, "edge_index", 1, np.int32), minlength=len(mesh.edges))
    return len(used) > 0 and bool(np.all(used == 2))


def frozen(placing):
    return tuple(tuple(row) for row in placing)


def coordinates_of(surface):
    """The (UV map, placing) pairs that a surface's pictures lie by, in the order of TEXCOORD_n."""
    pairs = []
    for picture in (surface.colour_picture, surface.alpha_picture, surface.emission_picture):
        if picture is not None and (picture.uv_map, frozen(picture.placing)) not in pairs:
            pairs.append((picture.uv_map, frozen(picture.placing)))
    return pairs


def unscaled(matrix):
    place, turn, _ = matrix.decompose()
    return Matrix.LocRotScale(place, turn, Vector((1.0, 1.0, 1.0)))


def mean_around(image):
    """The mean radiance of an equirectangular picture, W/(m² sr)."""
    if image.size[0] == 0:
        raise BakeError(f"the image '{image.name}' cannot be read")
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(image.size[1], image.size[0], 4)[..., :3]
    if not image.is_float and image.colorspace_settings.name == "sRGB":
        pixels = to_linear(pixels)
    rows = pixels.mean(axis=1, dtype=np.float64)
    weight = np.cos(math.pi * ((np.arange(image.size[1]) + 0.5) / image.size[1] - 0.5))
    return (rows * weight[:, None]).sum(axis=0) / weight.sum()


def spot_parts(size, blend):
    """Of a spot of Blender's opening angle and blend: (weight, inner angle, outer angle) of glTF spots whose sum has
    its profile, cos(angle) times a smooth step over the blend, and its power."""
    edge = math.cos(min(0.5 * size, 0.5 * math.pi))
    cosine = edge + (1.0 - edge) * (np.arange(400) + 0.5) / 400.0
    step = np.clip((cosine - edge) / max((1.0 - edge) * blend, 1e-6), 0.0, 1.0)
    wanted = cosine * step * step * (3.0 - 2.0 * step)
    marks = edge + (1.0 - edge) * np.array([0.0, 0.08, 0.2, 0.35, 0.5, 0.7, 1.0])
    cones = [(outer, inner) for i, outer in enumerate(marks[:-1]) for inner in marks[i + 1:]]
    if blend < 0.1:
        cones.append((edge, edge + 2e-3))
    shapes = np.stack([np.clip((cosine - outer) / (inner - outer), 0.0, 1.0) ** 2 for outer, inner in cones], axis=1)
    weight = positive_fit(shapes, wanted)
    weight[weight < 1e-3] = 0.0
    weight *= wanted.sum() / (shapes @ weight).sum()
    return [(float(w), math.acos(min(inner, 1.0)), math.acos(outer))
            for w, (outer, inner) in zip(weight, cones) if w > 0.0]


def positive_fit(shapes, wanted):
    """Weights of 0 or more with which the shapes come nearest to what is wanted (Lawson and Hanson 1974)."""
    count = shapes.shape[1]
    weight, used = np.zeros(count), np.zeros(count, bool)
    for _ in range(3 * count):
        pull = shapes.T @ (wanted - shapes @ weight)
        pull[used] = 0.0
        best = int(np.argmax(pull))
        if pull[best] <= 1e-9 * len(wanted):
            break
        used[best] = True
        while True:
            trial = np.zeros(count)
            trial[used] = np.linalg.lstsq(shapes[:, used], wanted, rcond=None)[0]
            below = used & (trial <= 0.0)
            if not below.any():
                break
            share = np.min(weight[below] / (weight[below] - trial[below]))
            weight = weight + share * (trial - weight)
            used &= weight > 1e-12
            weight[~used] = 0.0
        weight = trial
    return weight


def ball():
    """Places and triangles, fronts outwards, of a ball of radius 1 in 80 triangles."""
    g = (1.0 + math.sqrt(5.0)) / 2.0
    place = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
             (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    place = [np.array(p) / math.sqrt(1.0 + g * g) for p in place]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    middles, finer = {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            between = place[a] + place[b]
            place.append(between / np.linalg.norm(between))
            middles[key] = len(place) - 1
        return middles[key]

    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return np.array(place), np.array(finer, np.uint32)


# ---- Running Luxel ----


class Run:
    """`luxel` in a process of its own; poll() says what it has said since."""

    def __init__(self, program, words, folder):
        found = shutil.which(bpy.path.abspath(program) if program.startswith("//") else program)
        if found is None:
            raise BakeError(f"there is no program '{program}': say in the add-on's preferences where luxel is")
        self.stage, self.done, self.error, self.said = "starting", 0.0, 0.0, []
        self.process = subprocess.Popen(
            [found, *words, "--progress", "json"], cwd=folder, text=True, errors="replace",
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))
        self.lines = queue.Queue()
        self.listener = threading.Thread(target=self.listen, daemon=True)
        self.listener.start()

    def listen(self):
        for line in self.process.stderr:
            self.lines.put(line.rstrip())

    def poll(self):
        """The exit code, or None while it runs."""
        code = self.process.poll()
        if code is not None:
            self.listener.join()
        while not self.lines.empty():
            self.hear(self.lines.get())
        return code

    def hear(self, line):
        try:
            told = json.loads(line)
            self.stage, self.done, self.error = told["stage"], told["done"], told["error"]
        except (ValueError, KeyError, TypeError):
            self.said.append(line.removeprefix("warning: "))

    def stop(self):
        """Ends it at once: what it has so far is not wanted."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.listener.join()
        self.process.stderr.close()


class Bake:
    """One bake from the scene to what is applied. begin(), then poll() until it says True, then apply(); close() in any
    case."""

    def __init__(self, context, settings, program):
        self.context, self.settings, self.program = context, settings, program
        self.run, self.notes = None, []
        self.folder = tempfile.mkdtemp(prefix="luxel-")
        self.exporter = Exporter(context, settings.culled_is_one_sided, settings.gloss_is_diffuse)

    def begin(self):
        self.exporter.write(os.path.join(self.folder, "scene.glb"))
        self.notes += self.exporter.notes
        self.steps = [self.words()] + (self.words_of_pages() if self.settings.target == "LIGHTMAP" else [])
        self.begin_step()

    def begin_step(self):
        self.run = Run(self.program, [*self.steps.pop(0), "--threads", str(self.settings.threads)], self.folder)

    def words(self):
        settings, exporter = self.settings, self.exporter
        words = ["bake", "scene.glb", "--error", f"{settings.error:.6g}%"]
        if settings.target == "VERTEX":
            words += ["-o", "lit.glb", "--as", "vertex", "--preserve-topology", "--compress", "none"]
        else:
            words += ["-o", "light.vtkhdf"]
        if settings.max_edge > 0.0:
            words += ["--max-edge", f"{settings.max_edge:.6g}"]
        if settings.mesh_error > 0.0:
            words += ["--mesh-error", f"{settings.mesh_error:.6g}%"]
        has_sky = exporter.sky.max() > 0.0
        words += ["--sky", ",".join(f"{part:.6g}" for part in exporter.sky) if has_sky else "none"]
        if abs(exporter.unit - 1.0) > 1e-6:
            words += ["--contact-gap", f"{1e-4 * exporter.unit:.6g}"]
        return words

    def words_of_pages(self):
        """The light on pages, in floats; and where the corners lie on these, which the same options make the same."""
        pages = ["--page-size", str(self.settings.page)]
        if self.settings.texels > 0.0:
            pages += ["--texels-per-metre", f"{self.settings.texels:.6g}"]
        return [["lightmap", "light.vtkhdf", "-o", "page.exr", *pages],
                ["export", "light.vtkhdf", "--scene", "scene.glb", "-o", "lit.glb", "--compress", "none", "--as", "lightmap",
                 "--layout", "new", "--final-gather", "none", *pages]]

    def poll(self):
        code = self.run.poll()
        if code is None:
            return False
        if code not in (0, 3) or not (self.steps or os.path.exists(os.path.join(self.folder, "lit.glb"))):
            said = "; ".join(self.run.said[-3:]) or f"exit code {code}"
            raise BakeError(f"luxel failed: {said}")
        self.notes += [note for note in self.run.said if note not in self.notes]
        if self.steps:
            self.run.stop()
            self.begin_step()
            return False
        return True

    def apply(self):
        """Gives how many meshes took the light."""
        lit = GlbReader(os.path.join(self.folder, "lit.glb"))
        graph = self.context.evaluated_depsgraph_get()
        chosen = [self.context.scene.objects.get(name) for name in self.exporter.meshes]
        if self.settings.only_selected:
            chosen = [item for item in chosen if item and item.select_get()]
        image = self.image() if self.settings.target == "LIGHTMAP" else None
        applied = 0
        for item in filter(None, chosen):
            number, parts, corners = self.exporter.meshes[item.name]
            mesh = self.own_mesh(item, corners, graph)
            if mesh is None:
                continue
            primitives = lit.json["meshes"][number]["primitives"]
            if image is None:  # backs come behind
                write_colours(mesh, self.colours(lit, primitives[:len(parts)], parts, corners))
            else:
                cut = write_coordinates(mesh, [Corners(lit, primitive) for primitive in primitives
                                               if page_of(lit, primitive)])
                if cut:
                    self.notes.append(f"{cut} faces of '{item.name}' were cut where light jumps across them, or took "
                                      "corners of such neighbours")
                show_image(mesh, image)
            applied += 1
        return applied

    def colours(self, lit, primitives, parts, corners):
        """The colour of every corner: light is irradiance over pi, what a white surface would send to the eye."""
        is_light = self.settings.content == "LIGHT"
        colours = np.zeros((corners, 4), np.float32)
        colours[:, 3] = 1.0
        for loops, primitive in zip(parts, primitives):
            if "_IRRADIANCE" not in primitive["attributes"]:
                continue  # light passes through it
            values = lit.array(primitive["attributes"]["_IRRADIANCE" if is_light else "COLOR_0"])[:len(loops), :3]
            if values.dtype.kind == "u":
                values = values / np.iinfo(values.dtype).max
            colours[loops, :3] = values / math.pi if is_light else values
        return colours

    def image(self):
        """The image 'Luxel': irradiance over pi, linear, in floats; of several pages a tile each."""
        pages = []
        while os.path.exists(path := self.page_file(len(pages))):
            pages.append(radiance_in(path))
        if len(pages) > 1:
            return self.tiled_image(pages)
        image = bpy.data.images.get(LAYER)
        size = tuple(pages[0].shape[1::-1])
        if image is not None and (tuple(image.size) != size or not image.is_float or image.source == "TILED"):
            bpy.data.images.remove(image)
            image = None
        if image is None:
            image = bpy.data.images.new(LAYER, *size, alpha=False, float_buffer=True)
        make_linear(image)
        image.pixels.foreach_set(pages[0].reshape(-1))
        image.update()
        image.pack()
        return image

    def page_file(self, page):
        return os.path.join(self.folder, "page.exr" if page == 0 else f"page-{page + 1}.exr")

    def tiled_image(self, pages):
        """Page n is UDIM tile 1001 + n. Blender fills the tiles of an image from files alone."""
        for page, pixels in enumerate(pages):
            with open(os.path.join(self.folder, f"{LAYER}.{1001 + page}.exr"), "wb") as file:
                file.write(exr_of(pixels))
        if LAYER in bpy.data.images:
            bpy.data.images.remove(bpy.data.images[LAYER])
        image = bpy.data.images.load(os.path.join(self.folder, f"{LAYER}.1001.exr"))
        image.source, image.name = "TILED", LAYER
        make_linear(image)
        image.filepath = os.path.join(self.folder, f"{LAYER}.<UDIM>.exr")
        for page in range(len(pages)):
            if image.tiles.get(1001 + page) is None:
                image.tiles.new(tile_number=1001 + page)
        image.pack()
        return image

    def own_mesh(self, item, corners, graph):
        """The mesh of an object to write to: its own, and with as many corners as were baked."""
        if item.data.library is not None:
            self.notes.append(f"'{item.name}' has a linked mesh, which cannot take the light")
            return None
        if len(item.data.loops) != corners:
            applied = bpy.data.meshes.new_from_object(item.evaluated_get(graph), preserve_all_data_layers=True,
                                                      depsgraph=graph)
            if len(applied.loops) != corners:
                bpy.data.meshes.remove(applied)
                self.notes.append(f"'{item.name}' was changed meanwhile and took no light")
                return None
            self.notes.append(f"the modifiers of '{item.name}' were applied, as they change its corners")
            applied.name = item.data.name
            item.modifiers.clear()
            item.data = applied
        elif item.data.users > 1:
            item.data = item.data.copy()
        return item.data

    def close(self):
        if self.run is not None:
            self.run.stop()
        shutil.rmtree(self.folder, ignore_errors=True)


class Corners:
    """The triangles of a primitive with places on the pages: which face of the mesh each was, and which of its loops,
    where it is no new corner. Page n has its places where UDIM has tile 1001 + n."""

    def __init__(self, lit, primitive):
        attributes, page = primitive["attributes"], page_of(lit, primitive)
        name = lit.json["images"][lit.json["textures"][page["index"]]["source"]]["name"]  # "lightmap 2"
        tile = int(name.split()[-1]) - 1
        of = lit.array(primitive["indices"]).reshape(-1, 3)
        self.face = np.round(lit.array(attributes["_FACE"])[of[:, 0], 0]).astype(int)
        self.place = lit.array(attributes["POSITION"])[of]
        self.uv = lit.array(attributes[f"TEXCOORD_{page['texCoord']}"])[of]
        self.uv[..., 0] += tile % 10
        self.uv[..., 1] = tile // 10 + 1.0 - self.uv[..., 1]
        self.loop = lit.array(attributes["_LOOP"])[of][..., 0]


def make_linear(image):
    """The colour space of linear sRGB, which was called 'Linear' before 4.0."""
    image.colorspace_settings.name = "Linear" if bpy.app.version < (4, 0, 0) else "Linear Rec.709"


def radiance_in(path):
    """Irradiance over pi of a page that Luxel wrote: (height, width, 4), from the bottom left as Blender counts."""
    read = bpy.data.images.load(path)
    pixels = np.empty(read.size[0] * read.size[1] * 4, np.float32)
    read.pixels.foreach_get(pixels)
    pixels = pixels.reshape(read.size[1], read.size[0], 4)
    bpy.data.images.remove(read)
    pixels[..., :3] /= math.pi
    pixels[..., 3] = 1.0
    return pixels


def exr_of(pixels):
    """The bytes of an OpenEXR file of floats, as they are: Blender's own writer changes their colour space."""
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value

    height, width = pixels.shape[:2]
    channels = b"".join(name + b"\0" + struct.pack("<IIII", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<II", 20000630, 2) + b"".join((
        attribute(b"channels", b"chlist", channels), attribute(b"compression", b"compression", b"\0"),
        attribute(b"dataWindow", b"box2i", window), attribute(b"displayWindow", b"box2i", window),
        attribute(b"lineOrder", b"lineOrder", b"\0"), attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1.0)),
        attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0.0, 0.0)),
        attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1.0)))) + b"\0"
    rows = pixels[::-1, :, 2::-1].transpose(0, 2, 1).astype("<f4").reshape(height, -1)  # from the top: B, G, R
    line = 8 + rows[0].nbytes
    begin = len(header) + 8 * height
    offsets = struct.pack(f"<{height}Q", *range(begin, begin + height * line, line))
    return header + offsets + b"".join(struct.pack("<iI", y, row.nbytes) + row.tobytes() for y, row in enumerate(rows))


def page_of(lit, primitive):
    """The page that a primitive's material names, as MOZ_lightmap has it; None where light passes through it."""
    return lit.json["materials"][primitive["material"]].get("extensions", {}).get("MOZ_lightmap")


def write_coordinates(mesh, parts):
    """The UV map 'Luxel'. A face that lies on the page in several pieces is cut into them; how many were."""
    if not parts:
        return 0
    layer = mesh.uv_layers.get(LAYER) or mesh.uv_layers.new(name=LAYER, do_init=False)
    if layer is None:
        raise BakeError(f"'{mesh.name}' has eight UV maps already: there is no room for one more")
    total = column(mesh.polygons, "loop_total", 1, np.int32)
    face_of = face_of_loops(mesh)
    face, loop, uv, place = (np.concatenate([getattr(part, name) for part in parts])
                             for name in ("face", "loop", "uv", "place"))
    # Of a sheet that light fell on from both sides the front is shown.
    normal = column(mesh.polygons, "normal", 3)[face]
    across = np.cross(place[:, 1] - place[:, 0], place[:, 2] - place[:, 0])
    front = np.einsum("ij,ij->i", across, normal) > 0.0
    face, loop, uv, place = face[front], loop[front], uv[front], place[front]
    # Whole are faces whose triangles have the face's own corners, and one place on the page for each.
    nearest = np.clip(np.round(loop).astype(int), 0, len(mesh.loops) - 1)
    own = (np.abs(loop - nearest) < 1e-3) & (face_of[nearest] == face[:, None])
    whole = np.bincount(face, minlength=len(total)) == total - 2
    whole[face[~own.all(axis=1)]] = False
    found = np.full((len(mesh.loops), 2), np.nan)
    found[nearest[own]] = uv[own]
    apart = own & (np.abs(found[nearest] - uv).max(axis=2) > 1e-5)
    whole[face[apart.any(axis=1)]] = False
    coordinates = np.nan_to_num(found).astype(np.float32)
    layer.data.foreach_set("uv", coordinates.reshape(-1))
    pieces = np.flatnonzero(~whole[face])
    if len(pieces) > 0:
        cut_faces(mesh, face[pieces], place[pieces], uv[pieces])
    return len(np.unique(face[pieces]))


def cut_faces(mesh, face, place, uv):
    """Puts these triangles in the place of the faces they lie in; what one need not see is joined again."""
    work = bmesh.new()
    work.from_mesh(mesh)
    work.faces.ensure_lookup_table()
    layer = work.loops.layers.uv[LAYER]
    old = {number: work.faces[number] for number in np.unique(face)}
    corners = {frozen_place(vertex.co): vertex for item in old.values() for vertex in item.verts}
    pieces = []
    for number, places, coordinates in zip(face, place, uv):
        around = []
        for at in places:
            key = frozen_place(at)
            if key not in corners:
                corners[key] = work.verts.new(at)
            around.append(corners[key])
        if len(set(around)) < 3:
            continue
        source = old[number]
        piece = work.faces.new(around)
        piece.copy_from(source)
        for corner, at in zip(piece.loops, coordinates):
            interpolate_layers(corner, source)
            corner[layer].uv = at
        pieces.append(piece)
    bmesh.ops.delete(work, geom=list(old.values()), context="FACES_ONLY")
    within = {edge for piece in pieces for edge in piece.edges}
    around = {vertex for piece in pieces for vertex in piece.verts}
    bmesh.ops.dissolve_limit(work, angle_limit=1e-3, use_dissolve_boundaries=False, verts=list(around),
                             edges=list(within), delimit={"UV", "MATERIAL"})
    bmesh.ops.delete(work, geom=[edge for edge in work.edges if not edge.link_faces and edge in within], context="EDGES")
    work.to_mesh(mesh)
    work.free()
    mesh.update()


def interpolate_layers(corner, source):
    """Blender 3.4 takes the arguments of this call as one tuple, by mistake."""
    try:
        corner.copy_from_face_interp(source, False, False)
    except TypeError:
        corner.copy_from_face_interp((source, False, False))


def frozen_place(at):
    return tuple(np.asarray(at, np.float32).tolist())


def show_image(mesh, image):
    """The active image of every material that has nodes is the page, on its own UV map: for the user to link."""
    for material in mesh.materials:
        if material is None or not material.use_nodes:
            continue
        nodes = material.node_tree.nodes
        node = nodes.get(LAYER)
        if node is None or node.type != "TEX_IMAGE":
            node = nodes.new("ShaderNodeTexImage")
            node.name = node.label = LAYER
            node.extension = "EXTEND"
            by = nodes.new("ShaderNodeUVMap")
            by.uv_map = LAYER
            material.node_tree.links.new(by.outputs["UV"], node.inputs["Vector"])
        node.image = image


def write_colours(mesh, colours):
    layer = mesh.color_attributes.get(LAYER)
    if layer is not None and (layer.data_type, layer.domain) != ("FLOAT_COLOR", "CORNER"):
        mesh.color_attributes.remove(layer)
        layer = None
    if layer is None:
        layer = mesh.color_attributes.new(LAYER, "FLOAT_COLOR", "CORNER")
    layer.data.foreach_set("color", colours.reshape(-1))
    mesh.color_attributes.active_color = layer
    mesh.color_attributes.render_color_index = mesh.color_attributes.find(LAYER)
    mesh.update()


# ---- What the user sees ----


class LuxelPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    program: bpy.props.StringProperty(name="Program", subtype="FILE_PATH", default="luxel",
                                      description="The luxel program: its name on the PATH, or where it is")

    def draw(self, _context):
        self.layout.prop(self, "program")


class LuxelSettings(bpy.types.PropertyGroup):
    target: bpy.props.EnumProperty(
        name="Into", items=[("VERTEX", "Vertex colours", "A colour attribute, 'Luxel', at the corners of the meshes"),
                            ("LIGHTMAP", "Lightmap", "An image and a UV map, both 'Luxel'")], default="VERTEX")
    content: bpy.props.EnumProperty(
        name="What", items=[("LIGHT", "Light", "What a white surface would send to the eye: irradiance over pi, as "
                                               "Cycles' diffuse bake without colour"),
                            ("LOOK", "Look", "What a display shows, after Luxel's tone curve: colours and "
                                             "emission in it")],
        default="LIGHT")
    error: bpy.props.FloatProperty(name="Error", subtype="PERCENTAGE", default=2.0, min=0.05, max=50.0, precision=2,
                                   description="Stop when the light seen from 95 % of viewpoints all over the scene has "
                                               "this standard error, relative to the brightness there")
    max_edge: bpy.props.FloatProperty(name="Longest edge", default=0.0, min=0.0, precision=3,
                                      description="Longest edge of a patch in Blender units; 0: chosen by Luxel")
    mesh_error: bpy.props.FloatProperty(
        name="Mesh error", subtype="PERCENTAGE", default=0.0, min=0.0, max=50.0,
        description="Cut patches where the light needs it, until their size does no more to it than this; 0: do not")
    texels: bpy.props.FloatProperty(name="Texels per unit", default=0.0, min=0.0,
                                    description="The least there are along one Blender unit; 0: chosen by Luxel")
    page: bpy.props.IntProperty(name="Page", default=2048, min=64, max=16384, subtype="PIXEL",
                                description="No tile of the image is wider or higher than this")
    threads: bpy.props.IntProperty(name="Threads", default=0, min=0, max=4096, description="0 takes every core")
    only_selected: bpy.props.BoolProperty(
        name="Only selected", description="Only selected objects get the light; all of them take part in it")
    gloss_is_diffuse: bpy.props.BoolProperty(
        name="Gloss as diffuse", default=True,
        description="What the gloss of Principled BSDF reflects goes on as diffuse light; else it is lost")
    culled_is_one_sided: bpy.props.BoolProperty(
        name="Culled backs absorb", description="The backs of materials with backface culling absorb light; else both "
                                                "sides reflect, as in Cycles")


class LUXEL_OT_bake(bpy.types.Operator):
    """Bake the light of this scene with Luxel; Esc stops"""

    bl_idname = "luxel.bake"
    bl_label = "Bake light"
    bl_options = {"REGISTER", "UNDO"}

    program: bpy.props.StringProperty(name="Program", options={"SKIP_SAVE"},
                                      description="The luxel program; empty: that of the preferences")

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def start(self, context):
        bake = Bake(context, context.scene.luxel, self.program or program_of(context))
        try:
            bake.begin()
        except (BakeError, OSError) as error:
            bake.close()
            self.report({"ERROR"}, str(error))
            return None
        return bake

    def finish(self, bake):
        try:
            count = bake.apply()
        except (BakeError, OSError, KeyError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            bake.close()
        for note in bake.notes:
            self.report({"WARNING"}, note)
        self.report({"INFO"}, f"{count} meshes have Luxel's light")
        return {"FINISHED"}

    def execute(self, context):
        """Waits for the end: in the background, and from scripts."""
        bake = self.start(context)
        if bake is None:
            return {"CANCELLED"}
        try:
            while not bake.poll():
                time.sleep(0.02)
        except BakeError as error:
            bake.close()
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except BaseException:  # Ctrl-C
            bake.close()
            raise
        return self.finish(bake)

    def invoke(self, context, _event):
        self.bake = self.start(context)
        if self.bake is None:
            return {"CANCELLED"}
        manager = context.window_manager
        self.timer = manager.event_timer_add(0.1, window=context.window)
        manager.progress_begin(0.0, 1.0)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.leave(context)
            self.bake.close()
            self.report({"INFO"}, "stopped: nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        try:
            done = self.bake.poll()
        except BakeError as error:
            self.leave(context)
            self.bake.close()
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if done:
            self.leave(context)
            return self.finish(self.bake)
        run = self.bake.run
        context.window_manager.progress_update(run.done)
        so_far = f", error {100.0 * run.error:.2g} %" if run.error > 0.0 else ""
        context.workspace.status_text_set(f"Luxel: {run.stage} {100.0 * run.done:.0f} %{so_far}   Esc stops")
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """Blender is being closed, or another file opened."""
        self.leave(context)
        self.bake.close()

    def leave(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)


class LUXEL_OT_add_luminaire(bpy.types.Operator):
    """Add an empty that emits as an IES or EULUMDAT file, at the 3D cursor, aimed straight down"""

    bl_idname = "luxel.add_luminaire"
    bl_label = "Add luminaire..."
    bl_options = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(subtype="FILE_PATH")
    filter_glob: bpy.props.StringProperty(default="*.ies;*.ldt", options={"HIDDEN"})

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        if not os.path.isfile(bpy.path.abspath(self.filepath)):
            self.report({"ERROR"}, f"'{self.filepath}' is no file: choose an IES or EULUMDAT file")
            return {"CANCELLED"}
        item = bpy.data.objects.new(os.path.splitext(os.path.basename(self.filepath))[0], None)
        item.empty_display_type = "SINGLE_ARROW"  # along +Z, away from its light
        item.location = context.scene.cursor.location
        item["luminaire"], item["luminaire_dimming"] = self.filepath, 1.0
        context.collection.objects.link(item)
        for other in context.selected_objects:
            other.select_set(False)
        item.select_set(True)
        context.view_layer.objects.active = item
        return {"FINISHED"}

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}


class LUXEL_PT_bake(bpy.types.Panel):
    bl_label = "Luxel"
    bl_idname = "LUXEL_PT_bake"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings, layout = context.scene.luxel, self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(settings, "target")
        if settings.target == "VERTEX":
            layout.prop(settings, "content")
        else:
            layout.prop(settings, "texels")
            layout.prop(settings, "page")
        for name in ("error", "max_edge", "mesh_error", "threads", "only_selected", "gloss_is_diffuse",
                     "culled_is_one_sided"):
            layout.prop(settings, name)
        layout.operator_context = "INVOKE_DEFAULT"
        layout.operator("luxel.bake", icon="LIGHT")
        layout.operator("luxel.add_luminaire", icon="OUTLINER_OB_LIGHT")


def program_of(context):
    addon = context.preferences.addons.get(__name__)
    return addon.preferences.program if addon is not None and addon.preferences is not None else "luxel"


CLASSES = (LuxelPreferences, LuxelSettings, LUXEL_OT_bake, LUXEL_OT_add_luminaire, LUXEL_PT_bake)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.luxel = bpy.props.PointerProperty(type=LuxelSettings)


def unregister():
    del bpy.types.Scene.luxel
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
