# SPDX-License-Identifier: Apache-2.0
"""The arrays of a solution, and what it states of itself."""
import numpy as np

from ._errors import InputError
from ._options import call


class SolutionArrays:
    """What luxel.Solution states; see there."""

    _kept = None

    @property
    def _handle(self):
        if self._kept is None:
            raise ValueError("the solution is closed")
        return self._kept

    def close(self):
        """Lets go of the memory; arrays that are in use keep it. Further calls raise ValueError."""
        self._kept = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __len__(self):
        return len(self._handle)

    def __repr__(self):
        if self._kept is None:
            return "<luxel.Solution, closed>"
        return f"<luxel.Solution {self._handle.name}: {len(self)} patches, {self.method}, error {100 * self.error:.2g} %>"

    # ---- Light ----

    @property
    def irradiance(self):
        """(n, bands) float32, W/m²: what arrives at the fronts."""
        return self._handle.irradiance

    @property
    def irradiance_back(self):
        """(n, bands) float32, W/m²: what arrives at the backs; 0 at those of one-sided materials."""
        return self._handle.irradiance_back

    @property
    def irradiance_error(self):
        """(n, bands) float32, W/m²: standard error of `irradiance`; 1.96 of them hold the truth 95 times in 100. None where
        the method states none."""
        return self._handle.irradiance_error

    @property
    def irradiance_error_back(self):
        """(n, bands) float32, W/m²: standard error of `irradiance_back`, or None."""
        return self._handle.irradiance_error_back

    @property
    def radiosity(self):
        """(n, bands) float32, W/m²: what leaves the fronts: emittance + reflectance * irradiance."""
        return self._handle.radiosity

    @property
    def radiosity_back(self):
        """(n, bands) float32, W/m²: what leaves the backs."""
        return self._handle.radiosity_back

    @property
    def radiosity_error(self):
        """(n, bands) float32, W/m²: standard error of `radiosity`, or None. Computed: reflectance times irradiance_error."""
        return self._reflected(self.irradiance_error)

    @property
    def radiosity_error_back(self):
        """(n, bands) float32, W/m²: standard error of `radiosity_back`, or None. Computed."""
        return self._reflected(self.irradiance_error_back)

    def _reflected(self, error):
        return None if error is None else self.reflectance[self.patch_materials] * error

    @property
    def illuminance(self):
        """(n,) float32, lx: irradiance of the fronts in photometric units, 179 lm/W for plain colour. Computed."""
        return self.irradiance @ self.lux

    @property
    def illuminance_back(self):
        """(n,) float32, lx: the same of the backs. Computed."""
        return self.irradiance_back @ self.lux

    @property
    def illuminance_error(self):
        """(n,) float32, lx: standard error of `illuminance`, or None. Computed, as if the errors of bands had one sign: the
        same rays carry all bands."""
        return None if self.irradiance_error is None else self.irradiance_error @ self.lux

    @property
    def lux(self):
        """(bands,) float32: lx of 1 W/m² in each band."""
        weights = self._handle.lux
        if weights is None:
            raise InputError("the bands are neither red, green and blue nor wavelengths, so that there are no lux")
        return weights.astype(np.float32)

    def replicates(self, *, threads=None):
        """(replicates, n, 2 sides) float32, lx: the illuminance in each independent replicate of the run, before smoothing.
        Their spread is the error of anything computed from them. None unless baked with store_transport=True. Computed:
        some hundred milliseconds."""
        return self._handle.replicates(call(threads))

    # ---- Patches ----

    @property
    def areas(self):
        """(n,) float32, m²."""
        return self._handle.areas

    @property
    def normals(self):
        """(n, 3) float32, unit: the direction that fronts face."""
        return self._handle.normals

    @property
    def vertices(self):
        """(vertices, 3) float32, m, counted from `origin`."""
        return self._handle.vertices

    @property
    def corners(self):
        """(n, 3) uint32: indices of vertices, counter-clockwise seen from the front."""
        return self._handle.corners

    @property
    def centroids(self):
        """(n, 3) float32, m, counted from `origin`. Computed."""
        return self.vertices[self.corners].mean(axis=1, dtype=np.float64).astype(np.float32)

    @property
    def triangles(self):
        """(n,) uint32: index of the scene's triangle that each patch is a part of."""
        return self._handle.triangles

    @property
    def patch_materials(self):
        """(n,) uint32: indices into `materials`."""
        return self._handle.patch_materials

    @property
    def materials(self):
        """Names of the materials."""
        return tuple(self._handle.materials)

    @property
    def reflectance(self):
        """(materials, bands) float32. Computed. Of textured materials the mean over the texture."""
        return self._handle.reflectance

    @property
    def emittance(self):
        """(materials, bands) float32, W/m², of the fronts. Computed."""
        return self._handle.emittance

    @property
    def bands(self):
        """Names of the bands: ("red", "green", "blue"), or wavelengths such as "550 nm"."""
        return tuple(self._handle.bands)

    @property
    def light_groups(self):
        """Names of the groups of lamps that relight() can change; empty where all light is one."""
        return tuple(self._handle.light_groups)

    @property
    def origin(self):
        """(x, y, z) m, in the file's coordinates: what vertices count from. 0 unless the scene lies far from zero."""
        return self._handle.origin

    # ---- The run ----

    @property
    def method(self):
        """The solver: "sampled", "stochastic-jacobi", "dense", "hemicube" or "lines"."""
        return self._handle.facts["method"]

    @property
    def error(self):
        """Standard error of the visible light, relative to the brightness there, that 95 % of viewpoints stay below. 0: not
        estimated. What bake(error=...) asks for."""
        return self._handle.facts["error"]

    @property
    def mesh_error(self):
        """The same that the size of the patches leaves in the light between them; 0: not estimated."""
        return self._handle.facts["mesh_error"]

    @property
    def stop(self):
        """Why the solver stopped: "error_reached", "ray_limit", "time_limit", "stopped_by_user", "converged" and so on."""
        return self._handle.facts["stop"]

    @property
    def rays(self):
        """Number of rays traced."""
        return self._handle.facts["rays"]

    @property
    def facts(self):
        """Everything that the solution states of itself, as a dictionary: method, seed, errors, options, command line, ..."""
        return dict(self._handle.facts)

    @property
    def has_transport(self):
        """Whether it stores what relight() and resume() need: baked with store_transport=True."""
        return self._handle.has_samples
