# SPDX-License-Identifier: Apache-2.0
"""A scene for all programs: triangles with diffuse reflectances, lamps that emit from their fronts, an even sky.

Lamps are made black (`Kd 0`), because the programs differ in what a lamp reflects. Everything else is the file's.
"""
import math
import os
import re

import numpy

SUBSAMPLES = 3  # per pixel and axis, to find the pixels that see one surface only


class Scene:
    """points (n, 3), m; triangles (m, 3) of them; material of each; reflectance and radiance (k, 3); camera; sky."""

    def __init__(self, name, path):
        self.name = name
        self.names, self.reflectance, self.radiance = _read_mtl(os.path.splitext(path)[0] + ".mtl")
        with open(path, encoding="utf-8") as file:
            lines = file.readlines()
        head = "".join(line for line in lines[:20] if line.startswith("#"))
        camera = re.search(r"--eye (\S+) --target (\S+) --fov (\S+)", head)
        sky = re.search(r"bake with --sky (\S+)", head)
        self.eye, self.target = (numpy.array([float(v) for v in camera[i].split(",")]) for i in (1, 2))
        self.fov = float(camera[3])
        self.sky = numpy.array([float(v) for v in sky[1].split(",")]) if sky else numpy.zeros(3)
        points, triangles, materials, material = [], [], [], 0
        for line in lines:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words[0] == "usemtl":
                material = self.names.index(words[1])
            elif words[0] == "f":
                corners = [int(word.split("/")[0]) for word in words[1:]]
                corners = [c - 1 if c > 0 else len(points) + c for c in corners]
                triangles += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
                materials += [material] * (len(corners) - 2)
        self.points, self.triangles = numpy.array(points), numpy.array(triangles)
        self.materials = numpy.array(materials)
        lamps = self.radiance.any(axis=1)
        self.reflectance[lamps] = 0.0

    def basis(self):
        """Unit vectors to the right, up and ahead of the camera."""
        ahead = self.target - self.eye
        ahead /= numpy.linalg.norm(ahead)
        right = numpy.cross(ahead, (0.0, 1.0, 0.0))
        right /= numpy.linalg.norm(right)
        return right, numpy.cross(right, ahead), ahead

    def write_obj(self, path):
        with open(os.path.splitext(path)[0] + ".mtl", "w", encoding="utf-8") as file:
            for name, reflectance, radiance in zip(self.names, self.reflectance, self.radiance):
                file.write(f"newmtl {name}\nKd {words(reflectance)}\nKe {words(radiance)}\n")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"mtllib {os.path.basename(os.path.splitext(path)[0])}.mtl\n")
            file.writelines(f"v {words(point)}\n" for point in self.points)
            current = None
            for material, triangle in zip(self.materials, self.triangles + 1):
                if material != current:
                    file.write(f"usemtl {self.names[material]}\n")
                    current = material
                file.write("f {} {} {}\n".format(*triangle))

    def write_arrays(self, path):
        right, up, ahead = self.basis()
        numpy.savez(path, points=self.points, triangles=self.triangles, materials=self.materials,
                    reflectance=self.reflectance, radiance=self.radiance, sky=self.sky, eye=self.eye,
                    basis=numpy.stack([right, up, -ahead]), fov=math.radians(self.fov))

    def surfaces(self, width, height):
        """Pixels (height, width) that see one plane of one material, and whose eight neighbours see no lamp and no sky:
        programs filter pixels in different ways, which matters at edges only."""
        ids = self._visible(width * SUBSAMPLES, height * SUBSAMPLES)
        blocks = ids.reshape(height, SUBSAMPLES, width, SUBSAMPLES)
        low, high = blocks.min(axis=(1, 3)), blocks.max(axis=(1, 3))
        dim = numpy.pad(low >= 0, 1, constant_values=True)
        beside = [dim[y:y + height, x:x + width] for y in range(3) for x in range(3)]
        return (low == high) & numpy.all(beside, axis=0)

    def _planes(self):
        """A number for each triangle, shared by those of one plane and material; -1 for lamps."""
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        normal = numpy.cross(b - a, c - a)
        normal /= numpy.maximum(numpy.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
        distance = (normal * a).sum(axis=1)
        keys = numpy.round(numpy.column_stack([self.materials, normal * 100, distance * 1000])).astype(int)
        ids = numpy.unique(keys, axis=0, return_inverse=True)[1].reshape(-1)
        ids[self.radiance[self.materials].any(axis=1)] = -1
        return ids

    def _visible(self, width, height):
        """The plane in the middle of each pixel; -1: a lamp, or nothing. Each triangle is tested against the rays of
        its bounding box: ray = M b has b >= 0, and the depth is 1 / sum b (Olano and Greer 1997)."""
        right, up, ahead = self.basis()
        top = math.tan(math.radians(self.fov) / 2)
        x = (2 * (numpy.arange(width) + 0.5) / width - 1) * top * width / height
        y = (1 - 2 * (numpy.arange(height) + 0.5) / height) * top
        depth, ids = numpy.full((height, width), -1.0), numpy.full((height, width), -1)
        seen = (self.points - self.eye) @ numpy.stack([right, up, ahead], axis=1)
        for plane, corners in zip(self._planes(), seen[self.triangles]):
            if corners[:, 2].max() <= 1e-9 or abs(numpy.linalg.det(corners)) < 1e-15:
                continue
            columns, rows = slice(0, width), slice(0, height)
            if corners[:, 2].min() > 1e-6:
                u, v = corners[:, 0] / corners[:, 2], corners[:, 1] / corners[:, 2]
                columns = slice(*numpy.searchsorted(x, (u.min(), u.max())))
                rows = slice(*numpy.searchsorted(-y, (-v.max(), -v.min())))
            if columns.start >= columns.stop or rows.start >= rows.stop:
                continue
            inverse = numpy.linalg.inv(corners.T)
            weights = (inverse[:, 0, None, None] * x[None, None, columns] + inverse[:, 1, None, None] *
                       y[None, rows, None] + inverse[:, 2, None, None])
            nearness = weights.sum(axis=0)
            nearer = (weights >= 0).all(axis=0) & (nearness > depth[rows, columns])
            depth[rows, columns][nearer] = nearness[nearer]
            ids[rows, columns][nearer] = plane
        return ids


def words(values):
    return " ".join(f"{value:.9g}" for value in values)


def _read_mtl(path):
    names, colours = [], {"Kd": [], "Ke": []}
    with open(path, encoding="utf-8") as file:
        for line in file:
            parts = line.split()
            if parts[:1] == ["newmtl"]:
                names.append(parts[1])
                for values in colours.values():
                    values.append([0.0, 0.0, 0.0])
            elif parts and parts[0] in colours:
                colours[parts[0]][-1] = [float(v) for v in parts[1:4]]
            elif parts and parts[0].startswith("map_"):
                raise ValueError(f"{path} has textures: expected plain colours")
    return names, numpy.array(colours["Kd"]), numpy.array(colours["Ke"])
