# SPDX-License-Identifier: Apache-2.0
"""Solutions: the light of every patch."""
import os

import numpy as np

from . import _core
from ._arrays import SolutionArrays
from ._errors import InputError, Stopped
from ._measures import PLACES, Lightmap, Plane, Probes, Spheres, SurfaceMeasure, intervals
from ._options import call, documented, given, options_of


def _points(positions, what="positions"):
    points = np.atleast_2d(np.asarray(positions, dtype=float))
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise InputError(f"{what}: expected finite numbers of shape (n, 3), found shape {np.shape(positions)}")
    return points


def directions(normals, count):
    """Unit normals of `count` points, from one normal for all or one per point."""
    found = np.broadcast_to(_points(normals, "normals"), (count, 3)) if np.ndim(normals) == 1 else _points(normals, "normals")
    length = np.linalg.norm(found, axis=1)
    if found.shape != (count, 3) or not (length > 0).all():
        raise InputError(f"normals: expected one direction or {count}, none of length 0, found shape {np.shape(normals)}")
    return found / length[:, None]


def write_options():
    return options_of("write")


def relight_options():
    return options_of("relight")


def resume_options():
    return options_of("resume")


class Solution(SolutionArrays):
    """The light of a scene: irradiance and radiosity of both sides of every patch, with standard errors.

    Made by bake(), load(), merge() and by relight() and resume() of another one. Arrays of n patches are read-only views of
    the solution's own memory, without a copy, and keep that memory alive; so `with luxel.load(...) as solution:` frees a
    large file at its end as soon as no array of it is in use. Bands are red, green and blue, or wavelengths: see `bands`.
    """

    def __init__(self, handle):
        self._kept = handle

    # ---- Surfaces ----

    def patches_of(self, surface, scene=None):
        """(k,) uint32: indices of the patches of a surface: of a material by its name (with * and ?) or, with the Scene that
        was solved, of an object or a group."""
        found = self._handle.patches_called(surface, scene._handle if scene is not None else None)
        if not found:
            names = list(self.materials) + (list(scene.objects + scene.groups) if scene is not None else [])
            raise InputError(f"there is no surface '{surface}', but {', '.join(dict.fromkeys(names))}"
                             + ("" if scene is not None else "; give scene= for objects and groups"))
        return np.array(found, dtype=np.uint32)

    def measure(self, surface=None, *, side="auto", scene=None, threads=None):
        """The illuminance of a surface: mean, minimum, maximum and uniformity, with intervals.

        surface: name of a material (with * and ?) or, with scene=, of an object or group; or an array of patch indices; None:
            all materials, as a list. side: "auto" (the one that receives more light), "front" or "back".

        Returns a SurfaceMeasure. Patches that nearly no light reaches are left out; see docs of `luxel measure`. Intervals
        hold for the light on this mesh; they are narrower with store_transport=True.
        """
        if side not in ("auto", "front", "back"):
            raise InputError(f"side: expected auto, front or back, not {side!r}")
        if surface is None:
            used = np.unique(self.patch_materials)
            names = list(dict.fromkeys(self.materials[m] for m in used))
            sets = [np.flatnonzero(np.isin(self.patch_materials, [i for i, n in enumerate(self.materials) if n == name]))
                    for name in names]
        elif isinstance(surface, str):
            names, sets = [surface], [self.patches_of(surface, scene)]
        else:
            names, sets = ["patches"], [self._checked(surface)]
        found = self._handle.measure([s.tolist() for s in sets], side, call(threads))
        numbers = ("mean", "min", "max", "min_over_mean", "min_over_max")
        measures = [SurfaceMeasure(name, **intervals(m, numbers)) for name, m in zip(names, found)]
        return measures if surface is None else measures[0]

    def _checked(self, patches):
        indices = np.asarray(patches)
        if indices.dtype == bool and indices.shape == (len(self),):
            indices = np.flatnonzero(indices)
        if indices.ndim != 1 or not indices.size or indices.dtype.kind not in "iu" or indices.min() < 0 \
                or indices.max() >= len(self):
            raise InputError(f"surface: expected a name, or indices of patches from 0 to {len(self) - 1}")
        return indices

    def mean(self, surface, *, side="auto", scene=None, threads=None):
        """Mean illuminance of a surface, lx, as an Interval. Arguments as of measure()."""
        return self.measure(surface, side=side, scene=scene, threads=threads).mean

    # ---- Points and planes ----

    def probe(self, positions, normals=(0.0, 0.0, 1.0), *, error=None, floor=None, rays=None, seed=None, direct=False,
              threads=None, progress=None):
        """Illuminance at points, by rays of their own.

        positions: (n, 3) m, in the file's coordinates. normals: (n, 3) or one direction: light from the hemisphere around
            it counts. error: standard error of the sampling, relative; None: 0.02. floor: lx; darker points have the error
            of this much; None: 1. rays: most cosine rays per point; None: 262144. direct: only light straight from lamps
            and sky.

        Returns Probes. Some milliseconds per point. The size of the solution's patches is not part of the errors.
        """
        points = _points(positions)
        found = _core.probe(self._handle, points, directions(normals, len(points)),
                            _probe_options(error, floor, rays, seed, direct), call(threads, progress))
        if found is None:
            raise Stopped("stopped before all points were measured")
        found["place"] = PLACES[found["place"]]
        found["reached"] = found["reached"].astype(bool)
        return Probes(**found)

    def probe_spheres(self, positions, count=9, *, error=None, floor=None, rays=None, seed=None, threads=None,
                      progress=None):
        """Radiance from all around points, in spherical harmonics, for game engines.

        positions: (n, 3) m. count: 4 or 9 coefficients. Others as of probe(). Returns Spheres.
        """
        if count not in (4, 9):
            raise InputError(f"count: expected 4 or 9 spherical harmonics, not {count}")
        found = _core.probe_spheres(self._handle, _points(positions), count,
                                    _probe_options(error, floor, rays, seed, False), call(threads, progress))
        if found is None:
            raise Stopped("stopped before all points were measured")
        return Spheres(**found)

    def plane(self, height=None, *, polygon=None, surface=None, scene=None, spacing=None, border=0.0, maintenance=1.0,
              error=None, floor=None, rays=None, seed=None, direct=False, threads=None, progress=None):
        """Illuminance on a calculation plane: mean, minimum, uniformity and the grid of points, with intervals.

        One of: height: m, on the up axis; a plane over the whole scene. polygon: (k, 3) m, corners in one plane. surface:
            name of a flat surface (a material; with scene=, also an object or group).
        spacing: m, of the points; None: the grid of EN 12464-1. border: m, left free along the edges. maintenance: factor
            that all illuminances are multiplied by. Others as of probe().

        Returns a Plane. Points inside or behind one-sided surfaces are left out.
        """
        if sum(given is not None for given in (height, polygon, surface)) != 1:
            raise InputError("plane(): expected one of height, polygon and surface")
        if height is not None:
            corners = _core.extents_at(self._handle, float(height))
        else:
            corners = [] if polygon is None else _points(polygon, "polygon").tolist()
        area = _core.Area("plane", corners, surface or "", None if spacing is None else float(spacing), float(border),
                          float(maintenance))
        area.is_direct = direct
        found = _core.measure_plane(self._handle, area, scene._handle if scene is not None else None,
                                    _probe_options(error, floor, rays, seed, direct), call(threads, progress))
        if found is None:
            raise Stopped("stopped before all points were measured")
        return Plane(**intervals(found, ("mean", "min", "max", "uniformity", "diversity")))

    # ---- Other light ----

    @documented(relight_options)
    def relight(self, *, threads=None, progress=None, **options):
        """Other lamps and colours, without tracing a ray; needs store_transport=True.

        Names may have * and ?. Arguments that name groups or materials take dictionaries: light={"desk": 0.3},
        tint={"ceiling": "#ffd0a0"}, reflectance={"wall": (0.5, 0.2, 0.2)}; off=["sun"].

        Returns a Solution, with standard errors of its own. For many in a row use relighter(), which keeps its memory.
        """
        return self.relighter(threads=threads).light(progress=progress, **options)

    def relighter(self, *, threads=None):
        """A Relighter: relights again and again, in milliseconds each."""
        return Relighter(_core.relighter(self._handle, call(threads)))

    @documented(resume_options)
    def resume(self, *, threads=None, progress=None, **options):
        """Goes on with the run that made it, to a smaller error or more rays; needs store_transport=True.

        Returns a Solution: the same bits as a run that was never interrupted. Raises Stopped where it is stopped before
        there is light.
        """
        pairs = given(resume_options(), "Solution.resume", options)
        text = "luxel resume " + " ".join([self._handle.name] + [f"--{name} {value}" for name, value in pairs])
        handle = _core.resume(self._handle, pairs, text, call(threads, progress))
        if handle is None:
            raise Stopped("stopped before there was any light")
        return Solution(handle)

    # ---- Files and pictures ----

    def save(self, path):
        """Writes a .vtkhdf file, whole or not at all: for load(), the command, ParaView and h5py. Stores the transport if
        has_transport. The same solution gives the same bytes."""
        path = os.fspath(path)
        if not path.lower().endswith(".vtkhdf"):
            raise InputError(f"{path}: expected the extension .vtkhdf; write() has the other formats")
        self._handle.save(path, call())

    @documented(write_options)
    def write(self, path, scene=None, scale=1.0, *, threads=None, progress=None, **options):
        """Writes a file for other programs, by its extension: .glb, .ply, .html, .png, .exr, .hdr or .vtkhdf.

        scene: the Scene that was solved: a .glb then keeps the contents of a glTF file, and can keep its triangles
        (preserve_topology=True). scale: metres per unit that it was loaded with. The options are those of `luxel export` and
        `luxel render`; `as` and `for` are words of Python, so they are as_ and for_ here.

        Raises DeviceError where the file cannot be written, Stopped where it was stopped.
        """
        pairs = given(write_options(), "Solution.write", options)
        if not _core.write(self._handle, os.fspath(path), scene._handle if scene is not None else None, float(scale), pairs,
                           call(threads, progress)):
            raise Stopped(f"stopped before {os.fspath(path)} was written")

    @documented(write_options)
    def render(self, radiance=False, *, threads=None, progress=None, **options):
        """A picture as an array, from a camera that is chosen where none is given.

        Returns (height, width, 3): uint8, as a display shows it; with radiance=True float32, W/(m² sr), linear sRGB.
        """
        picture = _core.render(self._handle, given(write_options(), "Solution.render", options), bool(radiance),
                               call(threads, progress))
        if picture is None:
            raise Stopped("stopped before the picture was finished")
        return picture

    def lightmap(self, *, texels_per_metre=None, page_size=None, margin=None, crease_angle=None, final_gather=None,
                 gather_rays=None, seed=None, threads=None, progress=None):
        """Unwraps the surfaces onto pages and fills these with light; see the Lightmap it returns.

        texels_per_metre: None: as many as cover 131,000 texels, or 40 per chart. page_size: texels, at most; None: 1024.
        margin: texels around charts; None: 2. final_gather: standard error of each texel, relative; 0: none; None: 0.02.
        gather_rays: most rays per texel; None: 4096.
        """
        options = _core.LightmapOptions()
        for name, value in (("texels_per_metre", texels_per_metre), ("page_size", page_size), ("margin", margin),
                            ("crease_angle", crease_angle), ("final_gather", final_gather), ("gather_rays", gather_rays),
                            ("seed", seed)):
            if value is not None:
                setattr(options, name, value)
        found = _core.lightmap(self._handle, options, call(threads, progress))
        if found is None:
            raise Stopped("stopped before the lightmap was made")
        return Lightmap(**found)


class Relighter:
    """Relights one solution again and again; made by Solution.relighter(). Not for several threads at once."""

    def __init__(self, handle):
        self._handle = handle

    @documented(relight_options)
    def light(self, *, threads=None, progress=None, **options):
        """A Solution with these lamps and colours; what is not named is as in the run. Arguments as of Solution.relight().
        Tens of milliseconds at 50,000 patches; longer with other reflectances."""
        return Solution(self._handle.light(given(relight_options(), "Relighter.light", options), call(threads, progress)))


def _probe_options(error, floor, rays, seed, direct):
    options = _core.ProbeOptions()
    for name, value in (("error", error), ("floor", floor), ("rays", rays), ("seed", seed)):
        if value is not None:
            setattr(options, name, value)
    if not 0.0 < options.error < 1.0:
        raise InputError(f"error: expected a fraction above 0 and below 1, such as 0.02, not {error}")
    options.direct = bool(direct)
    return options


def load(path, *, progress=None):
    """Reads a solution: a .vtkhdf file of save() or of the command. Returns a Solution; use it in a `with` statement to free
    large ones early. Raises InputError where there is no such file, FormatError where it is damaged."""
    return Solution(_core.read_solution(os.fspath(path), call(None, progress)))


def merge(solutions, *, threads=None, progress=None):
    """One solution of two or more independent ones of the same scene and patches, with a smaller error: baked with other
    seeds. Takes Solutions or paths. Raises InputError where they do not fit together, or one shares its seed."""
    parts = [s if isinstance(s, Solution) else load(s) for s in solutions]
    if len(parts) < 2:
        raise InputError("merge(): expected two or more solutions")
    return Solution(_core.merge([s._handle for s in parts], call(threads, progress)))
