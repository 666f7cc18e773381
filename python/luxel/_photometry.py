# SPDX-License-Identifier: Apache-2.0
"""Photometric files of luminaires."""
import os
from typing import NamedTuple

import numpy as np

from . import _core
from ._options import log


class PlaneFigures(NamedTuple):
    """Figures of one main plane of a luminaire."""

    max_intensity: float  # cd
    beam_angle: float  # degrees between the outermost directions with 50 % of it
    field_angle: float  # degrees, with 10 %


class Photometry:
    """The luminous intensity of a luminaire and what its file states. Made by load_photometry()."""

    def __init__(self, handle):
        self._handle = handle
        self._figures = handle.figures()

    def __repr__(self):
        return f"<luxel.Photometry {self.file}: {self.format}, {self.flux:.4g} lm>"

    @property
    def file(self):
        """The file, as it was named."""
        return self._handle.file

    @property
    def format(self):
        """Such as "IES LM-63-2002" or "EULUMDAT"."""
        return self._handle.format

    @property
    def luminaire(self):
        """Name of the luminaire; empty: not stated. `catalogue` and `maker` likewise."""
        return self._handle.luminaire

    @property
    def catalogue(self):
        """Catalogue number; empty: not stated."""
        return self._handle.catalogue

    @property
    def maker(self):
        """Manufacturer; empty: not stated."""
        return self._handle.maker

    @property
    def flux(self):
        """Luminous flux of the luminaire, lm, by the zonal rule of the trade."""
        return self._handle.flux

    @property
    def header_flux(self):
        """lm that the file's header promises; 0: none."""
        return self._handle.header_flux

    @property
    def max_intensity(self):
        """cd."""
        return self._handle.max_intensity

    @property
    def downward_fraction(self):
        """Part of the flux that leaves below the horizontal."""
        return self._figures["downward_fraction"]

    @property
    def planes(self):
        """PlaneFigures of C0-C180 and C90-C270 (of types A and B: horizontal and vertical)."""
        return PlaneFigures(*self._figures["x"]), PlaneFigures(*self._figures["y"])

    @property
    def type(self):
        """Goniometer type: "A", "B" or "C"."""
        return self._handle.type

    @property
    def vertical(self):
        """(v,) float64, degrees: vertical angles of the file; of type C gamma, 0 at the aim."""
        return self._handle.vertical

    @property
    def horizontal(self):
        """(h,) float64, degrees: horizontal angles of the file."""
        return self._handle.horizontal

    @property
    def intensity(self):
        """(h, v) float64, cd: luminous intensity at the angles of the file, with all its factors."""
        return self._handle.intensity

    @property
    def size(self):
        """(x, y, z) m: extents of the luminous opening."""
        return self._handle.size

    @property
    def lamps(self):
        """Lamps as the file has them: dictionaries with count, flux (lm), watts, name, colour and colour_rendering."""
        return tuple(self._handle.lamps())

    @property
    def warnings(self):
        """Sentences with file and line."""
        return tuple(self._handle.warnings)

    def at(self, vertical, horizontal):
        """cd at angles in degrees of the file's own type, between which intensity is bilinear. Arrays of one shape, or
        numbers; the result has their shape."""
        v, h = np.broadcast_arrays(np.asarray(vertical, dtype=float), np.asarray(horizontal, dtype=float))
        candela = self._handle.at_angles(np.ascontiguousarray(v).reshape(-1), np.ascontiguousarray(h).reshape(-1))
        return float(candela[0]) if v.ndim == 0 else candela.reshape(v.shape)


def load_photometry(path, *, lamp_set=1, rotate=0.0):
    """Reads an IES LM-63 or EULUMDAT file; its kind is found from its content.

    lamp_set: which of EULUMDAT's alternative sets of lamps, from 1. rotate: degrees, anticlockwise seen from above. Raises
    InputError with file and line.
    """
    photometry = Photometry(_core.load_photometry(os.fspath(path), int(lamp_set), float(rotate)))
    for warning in photometry.warnings:
        log.warning("%s", warning)
    return photometry
