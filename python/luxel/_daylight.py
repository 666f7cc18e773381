# SPDX-License-Identifier: Apache-2.0
"""Daylight factors, and a year of daylight."""
import os
from typing import NamedTuple

import numpy as np

from . import _core
from ._errors import InputError, Stopped
from ._measures import Interval, intervals
from ._options import call
from ._scene import scene_of
from ._solution import _points, directions

_FIGURES = ("mean", "median", "min", "uniformity", "sDA", "sDA_with_blinds", "ASE")


class DaylightFactors(NamedTuple):
    """Daylight factors of n points: illuminance over that of open ground under an overcast sky (CIE type 16), fractions."""

    factor: np.ndarray  # (n,) float32
    factor_error: np.ndarray  # (n,) float32, standard errors
    sky: np.ndarray  # (n,) the part straight from the sky
    external: np.ndarray  # (n,) reflected outside
    internal: np.ndarray  # (n,) reflected inside
    mean: Interval  # over the points
    median: Interval
    min: Interval
    uniformity: Interval  # min over mean


class Daylight:
    """The daylight of points. Made by daylight(). Arrays are read-only; hours are those of the weather file with light."""

    def __init__(self, handle):
        self._handle = handle

    def __repr__(self):
        return f"<luxel.Daylight of {len(self.factors.factor)} points, {len(self.times)} hours>"

    @property
    def factors(self):
        """DaylightFactors."""
        return DaylightFactors(**intervals(self._handle.factors(), _FIGURES))

    @property
    def place(self):
        """The place of the weather file; empty without one."""
        return self._handle.place

    @property
    def times(self):
        """(hours,) datetime64[m]: the middle of each hour with light, local standard time. Weather files are of a typical
        year: the year is 2023, or 2024 where the file has a 29 February."""
        return self._handle.minutes.astype("datetime64[m]")

    @property
    def sun_elevation(self):
        """(hours,) degrees above the horizon."""
        return self._handle.sun[:, 0]

    @property
    def sun_azimuth(self):
        """(hours,) degrees from north to the east."""
        return self._handle.sun[:, 1]

    @property
    def sky_illuminance(self):
        """(hours,) lx of open ground by the sky."""
        return self._handle.sun[:, 2]

    @property
    def sun_illuminance(self):
        """(hours,) lx of a plane that faces the sun, by the sun."""
        return self._handle.sun[:, 3]

    @property
    def illuminance(self):
        """(hours, n) float32, lx: by sky and sun. Computed: 0.3 ns per hour, point and patch of the sky; keep it."""
        self._needs_year()
        return self._handle.illuminance()

    @property
    def illuminance_error(self):
        """(hours, n) float32, lx: standard errors of `illuminance`. Costs eight times as much."""
        self._needs_year()
        return self._handle.illuminance_error()

    @property
    def direct_sun(self):
        """(hours, n) float32, lx: the part straight from the sun."""
        self._needs_year()
        return self._handle.direct_sun()

    @property
    def metrics(self):
        """Metrics of the year as a dictionary: sDA, sDA_with_blinds and ASE as Intervals; by point, with standard errors under
        NAME_error, daylight_autonomy, continuous_daylight_autonomy, useful_daylight, below_100, autonomous, above_3000
        (fractions of the occupied hours), exposure (lx h) and sun_hours (h); occupied_hours; closed_hours of blinds by group."""
        self._needs_year()
        return intervals(self._handle.metrics(), _FIGURES)

    @property
    def error(self):
        """Standard error of the solve behind it, as Solution.error."""
        return self._handle.solve_error

    def _needs_year(self):
        if not self._handle.has_year:
            raise InputError("there are no hours without weather: give daylight(weather=...)")


def daylight(scene, positions, normals=None, *, weather=None, north=0.0, albedo=0.2, sky_patches=577, error=None, rays=None,
             seed=None, max_edge=None, occupied=(8, 18), blind_transmittance=None, blinds=None, threads=None, progress=None, **options):
    """Daylight factors at points and, with weather, the illuminance of each hour of a year: from one solve.

    scene: a path, a Scene, or an object with `vertices` and `faces`; its lamps are left out. positions: (n, 3) m, in the
        file's coordinates. normals: (n, 3) or one direction; None: up.
    weather: an EPW or WEA file. north: degrees, clockwise seen from above, from +Y where Z is up, from -Z where Y is up.
        albedo: reflectance of the ground outside. sky_patches: 145, 577 or 2305.
    error: standard error of the light that the sky's patches together give; None: 0.05. rays: cosine rays per point, and as
        many towards windows; None: 4096. seed: None: 1. max_edge: m; None: automatic.
    occupied: hours of every day that metrics count, local standard time. blind_transmittance: of closed blinds; None: 0.05.
        blinds: windows whose blinds are operated apart: {name of a glass, object or group: transmittance of closed blinds}.
    options: those of load_scene().
    threads: None: all cores. progress: as of bake().

    Returns a Daylight. Some minutes for a room; the same bits on any number of threads.
    """
    loaded, rest = scene_of(scene, options, "daylight", threads, progress)
    if rest:
        raise TypeError(f"daylight() has no argument '{next(iter(rest))}'; help(luxel.daylight) lists them")
    subdivisions = {145: 1, 577: 2, 2305: 4}
    if sky_patches not in subdivisions:
        raise InputError(f"sky_patches: expected 145, 577 or 2305, not {sky_patches}")
    if not (0 <= occupied[0] < occupied[1] <= 24):
        raise InputError(f"occupied: expected two hours of a day such as (8, 18), not {occupied}")
    points = _points(positions)
    if normals is None:
        normals = (0.0, 0.0, 1.0) if loaded._handle.up_axis == 2 else (0.0, 1.0, 0.0)
    question = _core.DaylightOptions()
    question.weather = "" if weather is None else os.fspath(weather)
    question.north, question.albedo, question.subdivision = float(north), float(albedo), subdivisions[sky_patches]
    question.set_occupied(*occupied)
    for name, value in (("error", error), ("rays", rays), ("seed", seed), ("max_edge", max_edge),
                        ("blind_transmittance", blind_transmittance)):
        if value is not None:
            setattr(question, name, value)
    question.blinds = [(str(name), float(tau)) for name, tau in (blinds or {}).items()]
    handle = _core.daylight(loaded._handle, points, directions(normals, len(points)), question, call(threads, progress))
    if handle is None:
        raise Stopped("stopped before the daylight was computed")
    return Daylight(handle)
