# SPDX-License-Identifier: Apache-2.0
"""Writes the scenes and photometric files of the cases. Places are x, y, z in metres with z up; glTF has y up."""
import base64
import json
import math
import struct


def to_file(place):
    x, y, z = place
    return (x, z, -y)


def quad(a, b, c, d):
    return (a, b, c, d)


def box(low, high, outside=True):
    """Six quads; their fronts look outwards, or inwards."""
    l, h = low, high
    faces = [((l[0], h[1], l[2]), (h[0], h[1], l[2]), (h[0], l[1], l[2]), (l[0], l[1], l[2])),
             ((l[0], l[1], h[2]), (h[0], l[1], h[2]), (h[0], h[1], h[2]), (l[0], h[1], h[2])),
             ((l[0], l[1], l[2]), (h[0], l[1], l[2]), (h[0], l[1], h[2]), (l[0], l[1], h[2])),
             ((h[0], l[1], l[2]), (h[0], h[1], l[2]), (h[0], h[1], h[2]), (h[0], l[1], h[2])),
             ((h[0], h[1], l[2]), (l[0], h[1], l[2]), (l[0], h[1], h[2]), (h[0], h[1], h[2])),
             ((l[0], h[1], l[2]), (l[0], l[1], l[2]), (l[0], l[1], h[2]), (l[0], h[1], h[2]))]
    return faces if outside else [tuple(reversed(face)) for face in faces]


def towards(direction):
    """The quaternion (x, y, z, w) that turns -Z, along which a light of glTF shines, into a direction of the file."""
    size = math.sqrt(sum(c * c for c in direction))
    x, y, z = (c / size for c in direction)
    w = 1.0 - z  # 1 + cosine of the angle between them
    if w < 1e-9:
        return [0.0, 1.0, 0.0, 0.0]
    turn = (y, -x, 0.0, w)  # (0, 0, -1) x direction
    size = math.sqrt(sum(c * c for c in turn))
    return [c / size for c in turn]


def write_gltf(path, surfaces, sun=None):
    """surfaces: name -> (reflectance, quads). sun: (direction of its light, lx of what faces it)."""
    data, views, accessors, primitives, materials = b"", [], [], [], []
    for name, (reflectance, quads) in surfaces.items():
        corners = [to_file(corner) for face in quads for i in (0, 1, 2, 0, 2, 3) for corner in (face[i],)]
        packed = b"".join(struct.pack("<3f", *corner) for corner in corners)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data += packed
        accessors.append({"bufferView": len(views) - 1, "componentType": 5126, "count": len(corners), "type": "VEC3",
                          "min": [min(c[i] for c in corners) for i in range(3)],
                          "max": [max(c[i] for c in corners) for i in range(3)]})
        materials.append({"name": name, "doubleSided": True, "pbrMetallicRoughness": {
            "baseColorFactor": [reflectance] * 3 + [1.0], "metallicFactor": 0.0, "roughnessFactor": 1.0}})
        primitives.append({"attributes": {"POSITION": len(accessors) - 1}, "material": len(materials) - 1})
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                "nodes": [{"name": "room", "mesh": 0}], "meshes": [{"primitives": primitives}], "materials": materials,
                "accessors": accessors, "bufferViews": views,
                "buffers": [{"byteLength": len(data),
                             "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    if sun:
        document["extensionsUsed"] = ["KHR_lights_punctual"]
        document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": sun[1]}]}}
        document["nodes"].append({"name": "sun", "rotation": towards(to_file(sun[0])),
                                  "extensions": {"KHR_lights_punctual": {"light": 0}}})
        document["scenes"][0]["nodes"].append(1)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)


def write_obj(path, surfaces):
    """surfaces: name -> (reflectance, emittance in W/m2, quads)."""
    library = path[:-4] + ".mtl"
    with open(library, "w", encoding="utf-8") as file:
        for name, (reflectance, emittance, _) in surfaces.items():
            file.write(f"newmtl {name}\nKd {reflectance} {reflectance} {reflectance}\n")
            if emittance:
                file.write("Ke" + f" {emittance / math.pi:.17g}" * 3 + "\n")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"mtllib {library.rsplit('/', 1)[-1]}\n")
        count = 0
        for name, (_, _, quads) in surfaces.items():
            file.write(f"usemtl {name}\n")
            for face in quads:
                file.writelines("v {:.9g} {:.9g} {:.9g}\n".format(*corner) for corner in face)
                file.write("f " + " ".join(str(count + i) for i in range(1, 5)) + "\n")
                count += 4


def write_ies(path, vertical, planes, candela, size=(0.0, 0.0)):
    """Type C, absolute. candela: [plane][angle]; size: along X and along Y, m."""
    with open(path, "w", encoding="utf-8") as file:
        file.write("IESNA:LM-63-2002\n[MANUFAC] Luxel\n[LUMINAIRE] made for validation\nTILT=NONE\n")
        file.write(f"1 -1 1 {len(vertical)} {len(planes)} 1 2 {size[1]:g} {size[0]:g} 0\n1 1 0\n")
        file.write(" ".join(f"{a:g}" for a in vertical) + "\n" + " ".join(f"{a:g}" for a in planes) + "\n")
        for row in candela:
            file.write("\n".join(f"{value:.9g}" for value in row) + "\n")


def cosine(candela):
    """Every half degree."""
    angles = [0.5 * i for i in range(181)]
    return angles, [0.0], [[max(0.0, candela * math.cos(math.radians(a))) for a in angles]]


def write_points(path, points):
    """points: (position, normal) each."""
    with open(path, "w", encoding="utf-8") as file:
        file.write("x,y,z,nx,ny,nz\n")
        for position, normal in points:
            file.write(",".join(f"{c:.9g}" for c in (*to_file(position), *to_file(normal))) + "\n")


def write_luminaires(path, rows):
    """rows: dictionaries of the columns of a list of luminaires; `place` and `aim` stand for three columns each."""
    columns = ["file", "x", "y", "z", "dir_x", "dir_y", "dir_z", "rotation", "dimming"]
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in rows:
            place, aim = to_file(row["place"]), to_file(row.get("aim", (0.0, 0.0, -1.0)))
            numbers = [*place, *aim, row.get("rotation", 0.0), row.get("dimming", 1.0)]
            file.write(",".join([row["file"], *(f"{n:.9g}" for n in numbers)]) + "\n")
