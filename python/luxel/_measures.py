# SPDX-License-Identifier: Apache-2.0
"""Numbers with intervals, and records of results."""
from typing import NamedTuple

import numpy as np


class Interval(NamedTuple):
    """A number and an interval that holds its true value with a probability of at least 95 %.

    float(interval) is the value. Without stated errors both ends are the value.
    """

    value: float
    low: float
    high: float

    def __float__(self):
        return self.value

    def holds(self, number):
        """Whether a number lies in the interval."""
        return self.low <= number <= self.high

    def __str__(self):
        return f"{self.value:.4g} ({self.low:.4g} to {self.high:.4g})"


class SurfaceMeasure(NamedTuple):
    """The illuminance of one side of a surface, lx: of the means of its patches."""

    name: str
    side: str  # "front" or "back"
    patches: int  # that light reaches
    area: float  # m², of these
    unlit: float  # m², further area that no light reaches
    mean: Interval
    min: Interval
    max: Interval
    min_over_mean: Interval
    min_over_max: Interval
    darkest: int  # patch
    brightest: int  # patch
    errors: str  # where the interval of the mean comes from: "replicates", "patches" (an upper bound) or "none"


class Probes(NamedTuple):
    """The light at points. Arrays are in the order of the points and read-only."""

    illuminance: np.ndarray  # (n,) lx
    illuminance_error: np.ndarray  # (n,) lx, standard error of sampling and solution together
    sampling_error: np.ndarray  # (n,) lx, standard error of the probes' own rays
    irradiance: np.ndarray  # (n, bands) W/m²
    place: np.ndarray  # (n,) text: "free", "surface", "behind" (a surface's back) or "dark"
    reached: np.ndarray  # (n,) bool: whether the sampling error is the requested one


class Spheres(NamedTuple):
    """Radiance from all around points, in real spherical harmonics."""

    coefficients: np.ndarray  # (n, bands, 4 or 9) W/(m² sr), in the order 1; y, z, x; xy, yz, 3z²-1, xz, x²-y²
    relative_error: np.ndarray  # (n,) standard error of the luminance coefficients over the first one


class Plane(NamedTuple):
    """The illuminance on a calculation plane, lx, with maintenance factors."""

    mean: Interval
    min: Interval
    max: Interval
    uniformity: Interval  # min over mean, U0
    diversity: Interval  # min over max, Ud
    illuminance: np.ndarray  # (rows, columns) lx; NaN where there is no point
    illuminance_error: np.ndarray  # (rows, columns) lx, standard errors
    positions: np.ndarray  # (points, 3) m, row by row without the cells that have no point
    spacing: float  # m
    errors: str  # where the error of the solution comes from: "replicates", "patches" (an upper bound) or "none"
    points_behind: int  # left out: inside or behind something


class Lightmap(NamedTuple):
    """Pages of light for a rasteriser. Arrays are read-only; pages are square."""

    irradiance: np.ndarray  # (pages, size, size, 3) W/m², linear sRGB, from the top left
    irradiance_error: np.ndarray  # the same, standard errors; 0 where the solution has none
    texels: np.ndarray  # (pages, size, size) 0 empty, 1 inside a surface, 2 beside it, 3 filled from neighbours
    uv: np.ndarray  # (patches, 2 sides, 3 corners, 2) in [0, 1] from the top left of the page
    page: np.ndarray  # (patches, 2 sides) index of the page, or -1: the side has no light of its own
    charts: int
    rays: int


PLACES = np.array(["free", "surface", "behind", "dark"])


def intervals(record, names):
    """A copy of a dictionary whose tuples of these names are intervals."""
    return {key: Interval(*value) if key in names else value for key, value in record.items()}
