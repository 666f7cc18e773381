# SPDX-License-Identifier: Apache-2.0
"""The irradiance that a lit mesh of Luxel's (.ply) has."""
import struct

KINDS = {"float": "f", "uchar": "B", "int": "i"}


def irradiance(path):
    """(red, green, blue) in W/m² of each triangle, the mean of its corners, by the triangle's place and facing. Sides
    that no light found are not in a lit mesh, so two meshes of one scene may have different ones."""
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts, fields = {}, []
    for words in map(str.split, data[:end].decode("ascii").splitlines()):
        if words[0] == "element":
            inside = words[1]
            counts[inside] = int(words[2])
        elif words[0] == "property" and inside == "vertex":
            fields.append((words[2], words[1]))
    layout = struct.Struct("<" + "".join(KINDS[kind] for _, kind in fields))
    light = [i for i, (name, _) in enumerate(fields) if name.startswith("irradiance_")]
    faces = end + counts["vertex"] * layout.size
    vertices = list(layout.iter_unpack(data[end:faces]))
    found = {}
    for _, *corners in struct.iter_unpack("<Biii", data[faces:faces + 13 * counts["face"]]):
        places = tuple(sorted(vertices[c][:6] for c in corners))
        found[places] = tuple(sum(vertices[c][i] for c in corners) / 3 for i in light)
    return found
