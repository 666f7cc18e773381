# SPDX-License-Identifier: Apache-2.0
"""The irradiance that a lit mesh of Luxel's (.ply) has at its vertices."""
import struct

SIZES = {"float": ("f", 4), "uchar": ("B", 1), "int": ("i", 4)}


def irradiance(path):
    """(red, green, blue) in W/m² of each vertex."""
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    count, fields, inside = 0, [], False
    for line in data[:end].decode("ascii").splitlines():
        words = line.split()
        if words[0] == "element":
            inside = words[1] == "vertex"
            count = int(words[2]) if inside else count
        elif words[0] == "property" and inside:
            fields.append((words[2], words[1]))
    layout = struct.Struct("<" + "".join(SIZES[kind][0] for _, kind in fields))
    places = [i for i, (name, _) in enumerate(fields) if name.startswith("irradiance_")]
    return [tuple(values[i] for i in places)
            for values in layout.iter_unpack(data[end:end + count * layout.size])]
