# SPDX-License-Identifier: Apache-2.0
"""Meshes put together from simple shapes, and written as OBJ with MTL, or as glTF where there is a sun.

Metres, Y up. A part is one material's triangles: corners [n, 3], places on its texture [n, 2] in repeats, and triangles
[m, 3], counter-clockwise seen from the front.
"""
import base64
import json
import os

import numpy as np

QUAD = np.array([[0, 1, 2], [0, 2, 3]])
LUMENS_PER_WATT = 179.0  # by which glTF's lux and Luxel's W/m² are related


class Mesh:
    """Parts by material. Materials: {"name": {"Kd": (r, g, b), "Ke": ..., "d": opacity, "map_Kd": file}}."""

    def __init__(self, materials):
        self.materials = materials
        self.parts = []  # (material, corners, places, triangles)

    def add(self, material, corners, places, triangles):
        self.parts.append((material, np.asarray(corners, float), np.asarray(places, float), np.asarray(triangles)))

    def quad(self, material, a, b, c, d, repeat=1.0):
        """A parallelogram, counter-clockwise seen from the front. repeat: metres that the texture covers."""
        across, along = np.linalg.norm(np.subtract(b, a)), np.linalg.norm(np.subtract(d, a))
        places = np.array([(0, 0), (across, 0), (across, along), (0, along)]) / repeat
        self.add(material, [a, b, c, d], places, QUAD)

    def box(self, material, low, high, repeat=1.0):
        """The outside of a box that stands on a surface, without its bottom."""
        (x, y, z), (X, Y, Z) = low, high
        for corners in (((x, Y, Z), (X, Y, Z), (X, Y, z), (x, Y, z)), ((x, y, Z), (X, y, Z), (X, Y, Z), (x, Y, Z)),
                        ((X, y, z), (x, y, z), (x, Y, z), (X, Y, z)), ((X, y, Z), (X, y, z), (X, Y, z), (X, Y, Z)),
                        ((x, y, z), (x, y, Z), (x, Y, Z), (x, Y, z))):
            self.quad(material, *corners, repeat=repeat)

    def turned(self, material, centre, profile, slices, repeat=1.0):
        """A profile [(radius, height), ...] turned about the vertical through `centre`. The front looks outwards where the
        profile goes up. A radius of 0 is a point."""
        profile = np.asarray(profile, float)
        rings, columns = len(profile), slices + 1
        angle = 2 * np.pi * np.arange(columns) / slices
        angle[-1] = 0.0  # where the seam closes
        corners = np.stack([profile[:, :1] * np.cos(angle), np.repeat(profile[:, 1:], columns, 1),
                            -profile[:, :1] * np.sin(angle)], axis=-1) + np.asarray(centre, float)
        length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(profile, axis=0).T))])
        girth = 2 * np.pi * profile[:, 0].max()
        places = np.stack(np.meshgrid(girth * np.arange(columns) / slices, length), axis=-1) / repeat
        ring, column = np.meshgrid(np.arange(rings - 1), np.arange(slices), indexing="ij")
        a = (ring * columns + column).ravel()
        lower = np.stack([a, a + 1, a + columns + 1], axis=1)[(profile[ring.ravel(), 0] > 0)]
        upper = np.stack([a, a + columns + 1, a + columns], axis=1)[(profile[ring.ravel() + 1, 0] > 0)]
        self.add(material, corners.reshape(-1, 3), places.reshape(-1, 2), np.concatenate([lower, upper]))

    def sphere(self, material, centre, radius, stacks, slices):
        angle = np.pi * np.arange(stacks + 1) / stacks
        profile = np.stack([radius * np.sin(angle), -radius * np.cos(angle)], axis=1)
        profile[[0, -1], 0] = 0
        self.turned(material, centre, profile, slices)

    def triangle_count(self):
        return sum(len(triangles) for _, _, _, triangles in self.parts)


def write_obj(path, mesh, comment):
    library = os.path.splitext(os.path.basename(path))[0] + ".mtl"
    with open(os.path.join(os.path.dirname(path), library), "w", encoding="ascii", newline="\n") as file:
        for name, properties in mesh.materials.items():
            file.write(f"newmtl {name}\n")
            for key, value in properties.items():
                file.write(f"{key} {value if isinstance(value, (str, float)) else ' '.join(map(str, value))}\n")
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write("".join(f"# {line}\n" for line in comment) + f"mtllib {library}\n")
        first = 1
        for i, (material, corners, places, triangles) in enumerate(mesh.parts):
            file.write(f"g part{i}\nusemtl {material}\n")
            np.savetxt(file, corners, "v %.6f %.6f %.6f")
            np.savetxt(file, places, "vt %.6f %.6f")
            np.savetxt(file, np.repeat(triangles + first, 2, axis=1), "f %d/%d %d/%d %d/%d")
            first += len(corners)


def write_gltf(path, mesh, sun):
    """Even colours only. sun: the direction in which light travels, and its irradiance on what faces it, W/m²."""
    direction, irradiance = sun
    data, views, accessors, primitives = b"", [], [], []
    names = list(mesh.materials)

    def accessor(values, kind, component):
        nonlocal data
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": values.size // kind[1],
                          "type": kind[0]})
        if kind[0] == "VEC3":
            accessors[-1].update(min=values.min(0).tolist(), max=values.max(0).tolist())
        data += values.tobytes()
        return len(accessors) - 1

    for material, corners, _, triangles in mesh.parts:
        primitives.append({"attributes": {"POSITION": accessor(corners.astype("<f4"), ("VEC3", 3), 5126)},
                           "indices": accessor(triangles.astype("<u4"), ("SCALAR", 1), 5125),
                           "material": names.index(material)})
    # A node that looks along -Z, turned towards the sun's direction: the half-way quaternion.
    unit = np.asarray(direction, float) / np.linalg.norm(direction)
    turn = np.append(np.cross((0, 0, -1), unit), 1 - unit[2])
    turn /= np.linalg.norm(turn)
    lamp = {"type": "directional", "name": "sun", "intensity": irradiance * LUMENS_PER_WATT}
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"rotation": turn.tolist(), "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [lamp]}},
        "meshes": [{"primitives": primitives}],
        "materials": [{"name": name, "doubleSided": True, "pbrMetallicRoughness": {
            "baseColorFactor": [*mesh.materials[name]["Kd"], 1], "metallicFactor": 0}} for name in names],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," +
                     base64.b64encode(data).decode()}]}
    with open(path, "w", encoding="ascii", newline="\n") as file:
        json.dump(document, file)
