# SPDX-License-Identifier: Apache-2.0
"""Scenes."""
import os

import numpy as np

from . import _core
from ._errors import InputError, Stopped
from ._options import call, documented, given, scene_options


class Material:
    """A diffuse surface.

    name: text, by which results name the surface.
    reflectance: part of the light that is reflected, in [0, 1); one number, or red, green and blue (linear sRGB).
    emission: radiance that the front emits, W/(m² sr); one number or three. 0: it is no lamp.
    transmittance: makes it a pane of glass with this visible transmittance at normal incidence, in (0, 1]; one number or
        three; None: opaque.
    two_sided: False: the back absorbs all light.

    A lamp of L W/(m² sr) has a luminous exitance of 179 * pi * L lm/m².
    """

    def __init__(self, name="default", reflectance=0.5, emission=0.0, transmittance=None, two_sided=True):
        self.name = str(name)
        self.reflectance = _colour(f"material '{name}': reflectance", reflectance, 1.0)
        self.emission = _colour(f"material '{name}': emission", emission, np.inf)
        self.transmittance = None
        if transmittance is not None:
            self.transmittance = _colour(f"material '{name}': transmittance", transmittance, 1.0)
        self.two_sided = bool(two_sided)

    def __repr__(self):
        return f"Material({self.name!r}, reflectance={self.reflectance}, emission={self.emission})"

    def _row(self):
        return _core.MaterialRow(self.name, list(self.reflectance), list(self.emission), list(self.transmittance or ()),
                                 self.two_sided)


def _colour(what, value, most):
    try:
        numbers = np.asarray(value, dtype=float).reshape(-1)
    except (TypeError, ValueError):
        raise InputError(f"{what}: expected one number or three, not {value!r}") from None
    if numbers.size not in (1, 3) or not np.all(np.isfinite(numbers)) or np.any(numbers < 0) or np.any(numbers > most):
        limit = "of 0 or more" if most == np.inf else f"from 0 to {most:g}"
        raise InputError(f"{what}: expected one number or three {limit}, not {value!r}")
    return tuple(float(n) for n in np.broadcast_to(numbers, 3))


def _materials_of(materials):
    if materials is None:
        return [Material()]
    if isinstance(materials, dict):
        materials = [m if isinstance(m, Material) else Material(name, **m) for name, m in materials.items()]
    elif isinstance(materials, Material):
        materials = [materials]
    found = [m if isinstance(m, Material) else Material(**m) for m in materials]
    if not found:
        raise InputError("materials: expected at least one material")
    return found


def _indices_of(face_materials, materials, count):
    if face_materials is None:
        return np.zeros(count, dtype=np.int64)
    indices = np.asarray(face_materials)
    if indices.dtype.kind in "US":
        names = [m.name for m in materials]
        for name in np.unique(indices):
            if name not in names:
                raise InputError(f"face_materials: there is no material '{name}', but {', '.join(names)}")
        indices = np.array([names.index(name) for name in indices], dtype=np.int64)
    if indices.shape != (count,) or indices.dtype.kind not in "iu":
        raise InputError(f"face_materials: expected {count} indices or names, one per face, found an array of shape "
                         f"{indices.shape} of {indices.dtype}")
    wrong = np.flatnonzero((indices < 0) | (indices >= len(materials)))
    if wrong.size:
        raise InputError(f"face_materials[{wrong[0]}] is {indices[wrong[0]]}: expected an index below {len(materials)}, "
                         "the number of materials")
    return indices.astype(np.int64)


def _mesh_of(vertices, faces):
    vertices = np.asarray(vertices, dtype=float)
    faces = np.asarray(faces)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise InputError(f"vertices: expected an array of shape (n, 3), found {vertices.shape}")
    if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
        raise InputError(f"faces: expected an array of integers of shape (m, 3), found {faces.shape} of {faces.dtype}")
    if not len(faces):
        raise InputError("faces: expected at least one triangle")
    wrong = np.flatnonzero(~np.isfinite(vertices).all(axis=1))
    if wrong.size:
        raise InputError(f"vertices[{wrong[0]}] is {vertices[wrong[0]].tolist()}: expected finite numbers")
    wrong = np.flatnonzero(((faces < 0) | (faces >= len(vertices))).any(axis=1))
    if wrong.size:
        raise InputError(f"faces[{wrong[0]}] is {faces[wrong[0]].tolist()}: expected indices below {len(vertices)}, the "
                         "number of vertices")
    return vertices, faces


class Scene:
    """Surfaces, lamps and sky, ready to be solved. Made by load_scene() and Scene.from_arrays(); does not change.

    Arrays are read-only views of the scene's own memory; they stay valid after the scene is gone.
    """

    def __init__(self, handle):
        self._handle = handle

    @staticmethod
    @documented(scene_options)
    def from_arrays(vertices, faces=None, materials=None, face_materials=None, *, threads=None, progress=None,
                    **options):
        """Makes a scene of triangles in arrays.

        vertices: (n, 3) numbers, m. Or any object with attributes `vertices` and `faces`, such as a mesh of trimesh;
            leave out `faces` then.
        faces: (m, 3) indices of vertices, counter-clockwise seen from the front.
        materials: a Material, a list of them, or a dictionary {name: {"reflectance": ..., "emission": ...}} in the order
            that face_materials counts; None: one grey material.
        face_materials: (m,) indices or names of materials; None: the first for all.

        Raises InputError, which names the first wrong element. Copies the arrays once.
        """
        if faces is None:
            if not (hasattr(vertices, "vertices") and hasattr(vertices, "faces")):
                raise TypeError("from_arrays(): expected vertices and faces, or an object that has both as attributes, not "
                                f"{type(vertices).__name__} alone")
            vertices, faces = vertices.vertices, vertices.faces
        vertices, faces = _mesh_of(vertices, faces)
        rows = _materials_of(materials)
        indices = _indices_of(face_materials, rows, len(faces))
        pairs = given(scene_options(), "Scene.from_arrays", options)
        return Scene(_core.scene_from_arrays(vertices, faces.astype(np.int64), indices, [m._row() for m in rows], pairs,
                                             call(threads, progress)))

    @property
    def source(self):
        """The file that it was read from; "arrays" where it was made of arrays."""
        return self._handle.source

    @property
    def vertices(self):
        """(n, 3) float32, m, counted from `origin`."""
        return self._handle.vertices

    @property
    def faces(self):
        """(m, 3) uint32: indices of vertices, in the order of the file."""
        return self._handle.faces

    @property
    def face_materials(self):
        """(m,) uint32: indices into `materials`."""
        return self._handle.face_materials

    @property
    def face_groups(self):
        """(m,) uint32: indices into `groups`."""
        return self._handle.face_groups

    @property
    def materials(self):
        """Names of the materials."""
        return tuple(self._handle.materials)

    @property
    def groups(self):
        """Names of groups of faces; at least one."""
        return tuple(self._handle.groups)

    @property
    def objects(self):
        """Names of objects, where the file has any."""
        return tuple(self._handle.objects)

    @property
    def origin(self):
        """(x, y, z) m, in the file's coordinates: what vertices count from. 0 unless the scene lies far from zero."""
        return self._handle.origin

    @property
    def has_light(self):
        """Whether there is a lamp or a sky. bake() lights scenes without, unless sky="none"."""
        return self._handle.has_light

    @property
    def luminaires(self):
        """Number of lamps without a surface: luminaires, suns, points and spots."""
        return self._handle.luminaires

    @property
    def fingerprint(self):
        """64 bits of all that the light depends on."""
        return self._handle.fingerprint

    def __repr__(self):
        return f"<luxel.Scene {self.source}: {len(self.faces)} triangles, {len(self.materials)} materials>"


@documented(scene_options)
def load_scene(path, *, threads=None, progress=None, **options):
    """Reads a scene: .obj, .gltf, .glb, .ply, .stl, .fbx, .dae or .3ds.

    path: text or pathlib.Path. Returns a Scene. Raises InputError with `file` and `line`. About half a second per million
    faces.
    """
    handle = _core.load_scene(os.fspath(path), given(scene_options(), "load_scene", options), call(threads, progress))
    if not len(handle.faces):
        raise Stopped(f"{os.fspath(path)}: stopped while it was read")
    return Scene(handle)


def scene_of(scene, options, function, threads, progress):
    """A Scene of an argument, and the options that are left."""
    own = {name: value for name, value in options.items() if name in scene_options()}
    rest = {name: value for name, value in options.items() if name not in own}
    if isinstance(scene, Scene):
        for name, value in own.items():
            if value is not None:
                raise InputError(f"{name}: give it to load_scene() or Scene.from_arrays(), which make the scene")
        return scene, rest
    if isinstance(scene, (str, os.PathLike)):
        return load_scene(scene, threads=threads, progress=progress, **own), rest
    if hasattr(scene, "vertices") and hasattr(scene, "faces"):
        return Scene.from_arrays(scene, threads=threads, progress=progress, **own), rest
    raise TypeError(f"{function}(): expected a path or a Scene, not {type(scene).__name__}")
